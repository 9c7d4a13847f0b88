#pragma once

#include "core/geometry/curve.h"

#include <vector>

namespace arris::pattern {

/// Replaces every joint of a closed chain that turns by more than `kTangentTurn` and less than `kSmoothTurn`, a
/// rounding of the drawing, by arcs that are tangential to both neighbours: within `kSmoothDeviation` of the joint, of
/// a radius of at most about 1e6 mm, and as long as that and half of each neighbour allow. Afterwards each joint is
/// tangential or a corner. Returns the largest distance between the chain and the drawing, mm.
double smoothJoints(std::vector<geometry::Curve>& closedChain);

} // namespace arris::pattern
