#pragma once

#include <array>
#include <string_view>

namespace arris::files {

/// That move when a job is run.
enum class Axes { Simulated, Linuxcnc };

/// In files and on the command line, in the order of the enumeration.
inline constexpr std::array<std::string_view, 2> kAxesWords{"simulated", "linuxcnc"};

} // namespace arris::files
