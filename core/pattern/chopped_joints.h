#pragma once

#include "core/base/problem.h"
#include "core/geometry/curve.h"

#include <vector>

namespace arris::pattern {

/// Which joints of a contour come from a curve that was drawn as chords.
struct ChoppedJoints {
  std::vector<bool> smooth; ///< by curve: the joint at its start is such a one
  base::Problems notes;     ///< runs of joints that would be at a larger tolerance
};

/// A joint between lines (or a line and an arc) is smooth where chords of a curve would meet like that: it turns by at
/// most 20°, a curve that turns like that passes the shorter chord within `tolerance` (mm), and it does not stand out
/// by its turn among its neighbours, as a drawn corner does.
[[nodiscard]] ChoppedJoints findChoppedJoints(const std::vector<geometry::Curve>& closedChain, double tolerance);

} // namespace arris::pattern
