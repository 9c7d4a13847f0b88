#pragma once

#include "core/geometry/curve.h"
#include "core/recipe/recipe.h"

#include <vector>

namespace arris::program {

/// Where a transition is followed by arcs, a place on these may lie beside the place of the job that is told for it by
/// this much, mm. Lines and arcs are exact.
inline constexpr double kPlaceAccuracy = 0.5e-3;

/// A line, or an arc of at most 1 rad, of a segment of the job's way. It goes from one λ of that segment to another; in
/// between λ is proportional to the way.
struct WayPiece {
  geometry::Curve curve;
  double from = 0;
  double to = 0;
};

/// The whole curve in pieces that can be cut and moved sideways, tangential to each other.
[[nodiscard]] std::vector<WayPiece> piecesOf(const geometry::Curve& curve);

/// Whether the wheel's centre stays inside the travel in X and Y.
[[nodiscard]] bool isInTravel(const geometry::Curve& curve, const recipe::Machine& machine);

} // namespace arris::program
