#pragma once

#include "core/geometry/curve.h"

#include <vector>

namespace arris::pattern {

/// Makes one curve of neighbours in a closed chain that lie on one line or circle: every point where they met stays
/// within 1e-6 mm of it, the rounding of the file. A circle in pieces becomes one full circle. Returns a bound of the
/// distance between the chain and the drawing, mm.
double mergeNeighbours(std::vector<geometry::Curve>& closedChain);

} // namespace arris::pattern
