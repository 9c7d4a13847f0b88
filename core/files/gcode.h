#pragma once

#include "core/job/job.h"

#include <array>
#include <string>
#include <string_view>

namespace arris::files {

/// How a transition is written: as the parabola that it is (G5.1), or within 1 µm of it as arcs (G2, G3) or lines (G1)
/// for controllers without G5.1.
enum class TransitionForm { Spline, Arcs, Lines };

/// The words for it on the command line, in the order of the enumeration.
inline constexpr std::array<std::string_view, 3> kTransitionForms{"spline", "arcs", "lines"};

/// The planned program as ISO 6983 in absolute table coordinates, mm. F is the highest speed at which a block can be
/// run from end to end: the feed, v_trans in a transition, or less where the axes bind. It carries the geometry and
/// these caps; how the speed changes in between is the controller's matter. `patternFile` goes into a comment. For jobs
/// that can be ground.
[[nodiscard]] std::string gcode(const job::Job& job, std::string_view patternFile, TransitionForm form);

} // namespace arris::files
