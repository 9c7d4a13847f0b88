#pragma once

#include "core/files/axes.h"
#include "core/files/recipe_json.h"

#include <string>
#include <string_view>
#include <vector>

namespace arris::files {

/// What the operator has chosen about the window, and what it remembers.
struct Settings {
  enum class LengthUnit { Millimetre, Inch };
  enum class Appearance { Light, Dark };
  enum class Keypad { Touch, Always }; ///< opens when a field is touched, or also at a click
  std::string language;                ///< "de", "zh_CN"; empty: that of the system
  LengthUnit lengthUnit = LengthUnit::Millimetre;
  Appearance appearance = Appearance::Light;
  int scale = 100; ///< percent, `kLeastScale` to `kMostScale`
  Keypad keypad = Keypad::Touch;
  Axes axes = Axes::Simulated;     ///< that the window drives
  std::string code;                ///< fingerprint of the code of the engineering values; empty: they are open
  std::vector<std::string> recent; ///< patterns opened last, the latest first; `kMostRecent` at most
  bool operator==(const Settings&) const = default;
};

inline constexpr int kLeastScale = 100;
inline constexpr int kMostScale = 400;
inline constexpr std::size_t kMostRecent = 10;

/// As a JSON file, `"arris_settings": 1`.
[[nodiscard]] std::string writeSettingsFile(const Settings& settings);

/// From the text of the file: what is absent is as by default, an unknown key is a warning, every wrong value an error,
/// a newer version is refused. `file` names it in the problems.
[[nodiscard]] Read<Settings> readSettingsFile(std::string_view text, std::string_view file);

} // namespace arris::files
