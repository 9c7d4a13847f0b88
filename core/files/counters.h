#pragma once

#include "core/files/recipe_json.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace arris::files {

/// What a machine has done in its life.
struct Counters {
  std::string since;      ///< when counting began, ISO 8601
  double drivesOn = 0;    ///< s with power on the drives
  double spindleOn = 0;   ///< s with the spindle ordered to turn
  double grinding = 0;    ///< s along the glass
  double ground = 0;      ///< mm of wheel path along the glass
  std::int64_t panes = 0; ///< that came to their end
  bool operator==(const Counters&) const = default;
};

/// As a JSON file, `"arris_counters": 1`.
[[nodiscard]] std::string writeCounters(const Counters& counters);

/// From the text of the file. Reports every wrong or absent value by name; an unknown key is a warning, a newer version
/// is refused. `file` names it in the problems.
[[nodiscard]] Read<Counters> readCounters(std::string_view text, std::string_view file);

} // namespace arris::files
