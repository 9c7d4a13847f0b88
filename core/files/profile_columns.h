#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace arris::files {

/// The columns of a profile in the order in which they are written (contract).
inline constexpr std::array<std::string_view, 17> kProfileColumns{
    "t_s",      "x_mm",       "y_mm",    "z_mm",    "vx_mm_s", "vy_mm_s", "vz_mm_s", "ax_mm_s2",   "ay_mm_s2",
    "az_mm_s2", "speed_mm_s", "path_mm", "contour", "segment", "phase",   "corner",  "distance_mm"};

/// Where they stand in the table above.
namespace column {
inline constexpr std::size_t kTime = 0;
inline constexpr std::size_t kPosition = 1;
inline constexpr std::size_t kVelocity = 4;
inline constexpr std::size_t kAcceleration = 7;
inline constexpr std::size_t kSpeed = 10;
inline constexpr std::size_t kPath = 11;
inline constexpr std::size_t kContour = 12;
inline constexpr std::size_t kSegment = 13;
inline constexpr std::size_t kPhase = 14;
inline constexpr std::size_t kCorner = 15;
inline constexpr std::size_t kDistance = 16;
} // namespace column

/// What a run's profile has after these.
inline constexpr std::array<std::string_view, 6> kRunColumns{"x_cmd_mm",     "y_cmd_mm",     "z_cmd_mm",
                                                             "vx_meas_mm_s", "vy_meas_mm_s", "vz_meas_mm_s"};

/// The words of the column `phase`: those of a plan, then those that only a run has. Records hold places in this table:
/// new words go to its end.
inline constexpr std::array<std::string_view, 15> kPhaseWords{
    "approach",   "plunge",   "lead-in", "cruise",   "decelerate", "transition", "roll", "stop",
    "accelerate", "lead-out", "retract", "traverse", "dwell",      "hold",       "step"};

/// The place of a word in the table; nothing for any other text.
[[nodiscard]] constexpr std::optional<std::size_t> phaseNumber(std::string_view word) {
  for (std::size_t i = 0; i < kPhaseWords.size(); ++i) {
    if (kPhaseWords[i] == word) {
      return i;
    }
  }
  return std::nullopt;
}

} // namespace arris::files
