#pragma once

#include "core/base/problem.h"
#include "core/geometry/curve.h"

#include <stop_token>
#include <vector>

namespace arris::pattern {

/// What fitting did to a contour.
struct ChordFit {
  double deviation = 0; ///< largest distance between the contour and the drawing where it was fitted, mm
  base::Problems notes; ///< chords that are too coarse for the tolerance
};

/// Replaces the chords of curves in a closed chain of lines and arcs by lines and arcs that are tangential to each
/// other and to the arcs that the chords touch, within `tolerance` (mm, above 0) and centred between vertices and
/// middles of chords. Corners and what is no chord stay as they are. The chain keeps its direction, and its start where
/// that is not inside a curve. Cost grows as n log n. A stop ends it early.
[[nodiscard]] ChordFit fitChords(std::vector<geometry::Curve>& closedChain, double tolerance,
                                 const std::stop_token& stop = {});

} // namespace arris::pattern
