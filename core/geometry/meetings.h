#pragma once

#include "core/geometry/curve.h"

#include <array>
#include <cstddef>

namespace arris::geometry {

/// A line or an arc by its start: what lines and arcs have in common. Curvature 0 is a line.
struct Track {
  Point start{0, 0};
  Vector tangent{1, 0}; ///< unit
  double curvature = 0;
  double length = 0;

  Track() = default;
  explicit Track(const Curve& lineOrArc);

  [[nodiscard]] Point at(double lambda) const;
};

/// λ of up to two points, in no order; those outside the track too, on an arc from 0 up to a full turn.
struct Meetings {
  std::array<double, 2> lambda{};
  std::size_t count = 0;
};

/// Where the track, prolonged at both ends (an arc to its circle), meets a circle or a straight line. None where they
/// run along each other. Good for every curvature, from 0 on.
[[nodiscard]] Meetings meetCircle(const Track& track, const Point& center, double radius);

/// `normal` is a unit vector and `through` a point of the line.
[[nodiscard]] Meetings meetLine(const Track& track, const Point& through, const Vector& normal);

} // namespace arris::geometry
