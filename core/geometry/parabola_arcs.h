#pragma once

#include "core/geometry/curve.h"

#include <vector>

namespace arris::geometry {

// For controllers that know only lines and arcs. The legs of the parabola must not be parallel.

/// Arcs that follow the parabola within `tolerance` (mm), tangential to each other and to its ends: a chain of biarcs,
/// each as long as the tolerance allows.
[[nodiscard]] std::vector<Arc> arcsAlong(const Parabola& parabola, double tolerance);

/// Points on the parabola, its ends included, between which chords stay within `tolerance` (mm).
[[nodiscard]] std::vector<Point> chordsAlong(const Parabola& parabola, double tolerance);

} // namespace arris::geometry
