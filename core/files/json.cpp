#include "core/files/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
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

std::string shown(const Json& value) {
  constexpr std::size_t kLongest = 40;
  std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  if (text.size() > kLongest) {
    text = text.substr(0, kLongest) + "...";
  }
  return text;
}

} // namespace arris::files
