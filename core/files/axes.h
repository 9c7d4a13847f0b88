#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace arris::files {

/// That move when a job is run.
enum class Axes { Simulated, Linuxcnc };

/// In files and on the command line, in the order of the enumeration.
inline constexpr std::array<std::string_view, 2> kAxesWords{"simulated", "linuxcnc"};

[[nodiscard]] constexpr std::string_view wordOf(Axes axes) {
  return kAxesWords.at(static_cast<std::size_t>(axes));
}

/// Of one of the words; whoever takes it from outside has checked that it is one.
[[nodiscard]] constexpr Axes axesNamed(std::string_view word) {
  return word == wordOf(Axes::Linuxcnc) ? Axes::Linuxcnc : Axes::Simulated;
}

} // namespace arris::files
