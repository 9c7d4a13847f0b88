#include "core/files/settings_json.h"

#include "core/files/json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace arris::files {
namespace {

using base::Code;
using base::Problem;

constexpr std::string_view kSettingsKey = "arris_settings";
constexpr int kSettingsVersion = 1;

constexpr std::array<std::string_view, 2> kLengthUnits{"mm", "inch"};
constexpr std::array<std::string_view, 2> kAppearances{"light", "dark"};
constexpr std::array<std::string_view, 2> kKeypads{"touch", "always"};

template <typename Choice> std::string_view word(const std::array<std::string_view, 2>& words, Choice choice) {
  return words.at(static_cast<std::size_t>(choice));
}

/// Takes one member after the other into the settings.
class SettingsReader {
public:
  SettingsReader(Read<Settings>& read, std::string_view file) : m_read(read), m_file(file) {}

  void take(std::string_view key, const Json& value) {
    Settings& settings = m_read.value;
    if (key == "language") {
      text(settings.language, key, value);
    } else if (key == "length_unit") {
      choice(settings.lengthUnit, kLengthUnits, key, value);
    } else if (key == "appearance") {
      choice(settings.appearance, kAppearances, key, value);
    } else if (key == "scale_percent") {
      scale(key, value);
    } else if (key == "keypad") {
      choice(settings.keypad, kKeypads, key, value);
    } else if (key == "axes") {
      choice(settings.axes, kAxesWords, key, value);
    } else if (key == "code") {
      text(settings.code, key, value);
    } else if (key == "recent_patterns") {
      recent(key, value);
    } else if (key != kSettingsKey) {
      m_read.problems.emplace_back(Code::UnknownKey,
                                   std::vector<base::Value>{{"file", std::string(m_file)}, {"key", std::string(key)}});
    }
  }

private:
  void text(std::string& member, std::string_view key, const Json& value) {
    if (value.is_string()) {
      member = value.get<std::string>();
    } else {
      m_read.problems.push_back(wrongType(key, "a text", value));
    }
  }

  template <typename Choice>
  void choice(Choice& member, const std::array<std::string_view, 2>& words, std::string_view key, const Json& value) {
    const auto* found =
        value.is_string() ? std::find(words.begin(), words.end(), value.get<std::string>()) : words.end();
    if (found != words.end()) {
      member = static_cast<Choice>(found - words.begin());
    } else {
      m_read.problems.push_back(wrongType(key, fmt::format("one of: {}", fmt::join(words, ", ")), value));
    }
  }

  void scale(std::string_view key, const Json& value) {
    if (value.is_number_integer() && value >= kLeastScale && value <= kMostScale) {
      m_read.value.scale = value.get<int>();
    } else {
      m_read.problems.push_back(
          wrongType(key, fmt::format("a whole number from {} to {}", kLeastScale, kMostScale), value));
    }
  }

  void recent(std::string_view key, const Json& value) {
    const auto isText = [](const Json& element) { return element.is_string(); };
    if (value.is_array() && value.size() <= kMostRecent && std::all_of(value.begin(), value.end(), isText)) {
      m_read.value.recent = value.get<std::vector<std::string>>();
    } else {
      m_read.problems.push_back(wrongType(key, fmt::format("a list of up to {} texts", kMostRecent), value));
    }
  }

  Read<Settings>& m_read;
  std::string_view m_file;
};

} // namespace

std::string writeSettingsFile(const Settings& settings) {
  JsonWriter json;
  json.openObject();
  json.member(kSettingsKey, kSettingsVersion);
  json.member("language", settings.language);
  json.member("length_unit", word(kLengthUnits, settings.lengthUnit));
  json.member("appearance", word(kAppearances, settings.appearance));
  json.member("scale_percent", settings.scale);
  json.member("keypad", word(kKeypads, settings.keypad));
  json.member("axes", wordOf(settings.axes));
  json.member("code", settings.code);
  json.member("recent_patterns", std::span<const std::string>(settings.recent));
  json.close();
  return json.take();
}

Read<Settings> readSettingsFile(std::string_view text, std::string_view file) {
  Read<Settings> result;
  const auto object = parseVersioned(text, kSettingsKey, kSettingsVersion, file);
  if (!object) {
    result.problems.push_back(object.error());
    return result;
  }
  SettingsReader reader(result, file);
  for (const auto& [key, value] : object->items()) {
    reader.take(key, value);
  }
  return result;
}

} // namespace arris::files
