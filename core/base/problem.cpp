#include "core/base/problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <map>

namespace arris::base {
namespace {

std::string asText(const Value& value) {
  return std::visit([](const auto& v) { return fmt::format("{}", v); }, value.value);
}

std::string shortNumber(const Value& value) {
  const double* number = std::get_if<double>(&value.value);
  return number ? fmt::format("{:.6g}", *number) : asText(value);
}

} // namespace

const CodeInfo& info(Code code) {
  const CodeInfo& row = allCodes().at(static_cast<std::size_t>(code));
  assert(row.code == code);
  return row;
}

std::string_view name(Severity severity) {
  switch (severity) {
  case Severity::Error:
    return "error";
  case Severity::Warning:
    return "warning";
  case Severity::Note:
    return "note";
  }
  return "error";
}

std::string fillIn(std::string_view text, const Problem& problem) {
  std::string result;
  while (!text.empty()) {
    const std::size_t open = text.find('{');
    const std::size_t close = text.find('}', open);
    if (close == std::string_view::npos) {
      break;
    }
    const std::string_view key = text.substr(open + 1, close - open - 1);
    const auto value = std::find_if(problem.values.begin(), problem.values.end(),
                                    [key](const Value& candidate) { return candidate.name == key; });
    result += text.substr(0, open);
    result += value != problem.values.end() ? shortNumber(*value) : std::string(text.substr(open, close - open + 1));
    text.remove_prefix(close + 1);
  }
  return result += text;
}

std::string describe(const Problem& problem) {
  return fillIn(info(problem.code).text, problem);
}

std::string describeWithPlace(const Problem& problem, std::string_view frame) {
  std::string result = fmt::format("{}: ", name(severityOf(problem)));
  if (problem.line) {
    result += fmt::format("line {}: ", *problem.line);
  }
  if (problem.where) {
    result += fmt::format("at ({:.3f}, {:.3f}) mm {}: ", problem.where->x(), problem.where->y(), frame);
  }
  return result + fmt::format("{} [{}]", describe(problem), info(problem.code).name);
}

void keepFirstOfEachCode(Problems& problems) {
  std::map<Code, std::int64_t> counts;
  const auto isTooMany = [&counts](const Problem& p) { return ++counts[p.code] > kMostOfOneCode; };
  problems.erase(std::remove_if(problems.begin(), problems.end(), isTooMany), problems.end());
  for (const auto& [code, count] : counts) {
    if (count > kMostOfOneCode) {
      problems.push_back(
          Problem(Code::MoreNotListed, {{"count", count - kMostOfOneCode}, {"code", std::string(info(code).name)}}));
    }
  }
}

} // namespace arris::base
