#include "tests/structure/rules.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <regex>
#include <sstream>

namespace arris::test {
namespace {

std::string part(const std::string& path, std::size_t index) {
  std::istringstream parts(path);
  std::string result;
  for (std::size_t i = 0; i <= index && std::getline(parts, result, '/'); ++i) {
  }
  return result;
}

std::size_t placeInFlow(const std::string& path, const std::vector<std::string>& flow) {
  return static_cast<std::size_t>(std::find(flow.begin(), flow.end(), part(path, 1)) - flow.begin());
}

bool isQtHeader(const std::string& header) {
  static const std::regex kQt("(Q[A-Za-z][A-Za-z0-9]*(/.*)?|q[a-z_]+\\.h|qcustomplot.*)");
  return std::regex_match(header, kQt);
}

/// Why a source must not include a header; nothing where it may.
std::optional<std::string> objection(const std::string& source, const std::string& header,
                                     const std::vector<std::string>& flow) {
  const std::string from = part(source, 0);
  const std::string to = part(header, 0);
  if (from == "ui" && to == "app") {
    return "ui includes app";
  }
  if (from != "core") {
    return std::nullopt;
  }
  if (isQtHeader(header)) {
    return "core includes Qt";
  }
  if (to == "ui" || to == "app") {
    return "core includes " + to;
  }
  if (to == "core" && placeInFlow(header, flow) > placeInFlow(source, flow)) {
    return "core/" + part(source, 1) + " includes core/" + part(header, 1) + ", which stands after it in the flow";
  }
  return std::nullopt;
}

bool translates(const std::string& line) {
  // Member functions of that name are another matter: Eigen's translate moves.
  static const std::regex kCall("(^|[^A-Za-z0-9_.])(tr|translate|QT_TR_NOOP|QT_TRANSLATE_NOOP|QT_TR_N_NOOP)\\s*\\(");
  static const std::regex kComment("//.*");
  return std::regex_search(std::regex_replace(line, kComment, ""), kCall);
}

} // namespace

std::vector<std::string> flowOf(std::string_view cmakeLists) {
  static const std::regex kList("foreach\\(folder ([a-z ]+)\\)");
  std::match_results<std::string_view::const_iterator> match;
  if (!std::regex_search(cmakeLists.begin(), cmakeLists.end(), match, kList)) {
    return {};
  }
  std::istringstream words(match[1].str());
  return {std::istream_iterator<std::string>(words), {}};
}

std::vector<std::string> brokenRules(const std::string& path, std::string_view text,
                                     const std::vector<std::string>& flow) {
  static const std::regex kInclude(R"re(\s*#\s*include\s*[<"]([^>"]+)[>"].*)re");
  std::vector<std::string> broken;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const auto report = [&](const std::string& words) {
      broken.push_back(path + ":" + std::to_string(number) + ": " + words);
    };
    std::smatch match;
    if (std::regex_match(line, match, kInclude)) {
      if (const auto words = objection(path, match[1], flow)) {
        report(*words);
      }
    } else if (part(path, 0) != "ui" && translates(line)) {
      report("only ui translates");
    }
  }
  return broken;
}

} // namespace arris::test
