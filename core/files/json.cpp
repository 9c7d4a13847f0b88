#include "core/files/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

namespace arris::files {
namespace {

using base::Code;
using base::Expected;
using base::Problem;
using base::Unexpected;

/// Deeper than any file of Arris; what lies deeper is not kept.
constexpr int kDeepest = 16;

Unexpected malformed(std::string_view file, std::string reason) {
  return Unexpected(Problem(Code::JsonMalformed, {{"file", std::string(file)}, {"reason", std::move(reason)}}));
}

// "[json.exception.parse_error.101] parse error at line 2, column 5: syntax error …; last read: '…'" without what a
// reader has no use for, and without a last token that may be anything.
std::string reasonOf(const Json::exception& error) {
  std::string_view text = error.what();
  for (const std::string_view prefix : {std::string_view("] "), std::string_view("parse error at ")}) {
    if (const std::size_t at = text.find(prefix); at != std::string_view::npos) {
      text.remove_prefix(at + prefix.size());
    }
  }
  constexpr std::size_t kReadable = 160;
  const auto plain = [](char c) { return c >= ' ' && c <= '~'; };
  if (text.size() > kReadable || !std::all_of(text.begin(), text.end(), plain)) {
    text = text.substr(0, std::min(kReadable, text.find("; last read")));
  }
  return std::string(text);
}

/// Watches the parser: finds keys that stand twice and keeps deep nesting out of the result.
class Watch {
public:
  bool operator()(int depth, Json::parse_event_t event, const Json& parsed) {
    using Event = Json::parse_event_t;
    if (depth > kDeepest) {
      m_tooDeep = true;
      return false;
    }
    if (event == Event::object_start) {
      m_keys.emplace_back();
    } else if (event == Event::object_end) {
      m_keys.pop_back();
    } else if (event == Event::key && !m_keys.empty() && !m_keys.back().insert(parsed.get<std::string>()).second) {
      m_twice = parsed.get<std::string>();
    }
    return true;
  }

  [[nodiscard]] bool tooDeep() const {
    return m_tooDeep;
  }

  /// A key that stands twice in one object; empty where there is none.
  [[nodiscard]] const std::string& twice() const {
    return m_twice;
  }

private:
  std::vector<std::set<std::string>> m_keys; ///< of every open object
  std::string m_twice;
  bool m_tooDeep = false;
};

} // namespace

Expected<Json> parseJson(std::string_view text, std::string_view file) {
  Watch watch;
  Json json;
  try {
    json = Json::parse(text, std::ref(watch));
  } catch (const Json::exception& error) {
    return malformed(file, reasonOf(error));
  }
  if (watch.tooDeep()) {
    return malformed(file, fmt::format("it is nested more than {} deep", kDeepest));
  }
  if (!watch.twice().empty()) {
    return malformed(file, fmt::format("the key {} stands twice", shown(watch.twice())));
  }
  if (!json.is_object()) {
    return malformed(file, "it must be one object");
  }
  return json;
}

Expected<void> checkVersion(const Json& object, std::string_view key, int known, std::string_view file) {
  const auto version = object.find(key);
  if (version == object.end()) {
    return Unexpected(Problem(Code::JsonNotThisFormat, {{"file", std::string(file)}, {"key", std::string(key)}}));
  }
  if (!version->is_number_integer() || *version < 1) {
    return Unexpected(
        Problem(Code::ValueWrongType,
                {{"name", std::string(key)}, {"expected", "a whole number from 1 on"}, {"value", shown(*version)}}));
  }
  if (*version > known) {
    return Unexpected(Problem(Code::VersionNewer, {{"file", std::string(file)},
                                                   {"key", std::string(key)},
                                                   {"version", shown(*version)},
                                                   {"known", std::int64_t{known}}}));
  }
  return {};
}

Expected<Json> parseVersioned(std::string_view text, std::string_view key, int known, std::string_view file) {
  return parseJson(text, file).and_then([&](const Json& object) -> Expected<Json> {
    return checkVersion(object, key, known, file).map([&] { return object; });
  });
}

std::string shown(const Json& value) {
  constexpr std::size_t kLongest = 40;
  std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  if (text.size() > kLongest) {
    text = text.substr(0, kLongest) + "...";
  }
  return text;
}

Problem wrongType(std::string_view key, std::string expected, const Json& value) {
  return Problem(Code::ValueWrongType,
                 {{"name", std::string(key)}, {"expected", std::move(expected)}, {"value", shown(value)}});
}

std::string bare(const Json& value) {
  const std::string text = shown(value);
  return value.is_string() ? text.substr(1, text.find_last_not_of('"')) : text;
}

Problem notANumber(std::string_view key, std::string_view unit, const Json& value) {
  return Problem(Code::ValueNotANumber,
                 {{"name", std::string(key)}, {"unit", std::string(unit)}, {"value", bare(value)}});
}

std::string oneLine(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json valuesToJson(const std::vector<base::Value>& values) {
  Json object = Json::object();
  for (const base::Value& value : values) {
    std::visit([&](const auto& v) { object[value.name] = v; }, value.value);
  }
  return object;
}

std::vector<base::Value> valuesFromJson(const Json& object) {
  std::vector<base::Value> values;
  for (const auto& [name, value] : object.items()) {
    constexpr auto kMost = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    if (value.is_number_float() || (value.is_number_unsigned() && value.get<std::uint64_t>() > kMost)) {
      values.push_back({name, value.get<double>()});
    } else if (value.is_number_integer()) {
      values.push_back({name, value.get<std::int64_t>()});
    } else if (value.is_string()) {
      values.push_back({name, value.get<std::string>()});
    }
  }
  return values;
}

} // namespace arris::files
