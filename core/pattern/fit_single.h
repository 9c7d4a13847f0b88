#pragma once

#include "core/geometry/curve.h"

#include <optional>
#include <span>

namespace arris::pattern {

// Single arcs through points, by least squares of their distances.

/// The circle nearest to points all the way round, counter-clockwise where `turnsLeft`.
[[nodiscard]] geometry::Arc circleThrough(std::span<const geometry::Point> points, bool turnsLeft);

/// The arc from a point to another that is nearest to those between; none where they lie on a line.
[[nodiscard]] std::optional<geometry::Arc> arcThrough(const geometry::Point& from, const geometry::Point& to,
                                                      std::span<const geometry::Point> between);

/// Centre and radius; the radius is positive where the arc turns left.
struct Fillet {
  geometry::Point center;
  double radius = 0;
};

/// Of the circles that touch two lines in their directions of travel (unit), the one nearest to the points between
/// them, of which there is one at least; `turn` is what they turn by on the way from line to line, rad. None where the
/// lines are parallel and run the same way.
[[nodiscard]] std::optional<Fillet> filletThrough(const geometry::Point& onFirst, const geometry::Vector& first,
                                                  const geometry::Point& onSecond, const geometry::Vector& second,
                                                  double turn, std::span<const geometry::Point> between);

} // namespace arris::pattern
