#pragma once

#include "core/geometry/curve.h"

#include <optional>

namespace arris::geometry {

/// A place on a way and the unit direction of travel there.
struct Station {
  Point point;
  Vector tangent;
};

/// One or two curves from station to station, each an arc or, where that would be straight, a line.
struct Biarc {
  Curve first;
  std::optional<Curve> second;
};

/// Two arcs that touch each other and the directions of both stations, meeting half-way between the ends of equally
/// long tangents; one arc where both would be the same. Directions have all their digits, however far from the origin
/// the stations lie. They must lie apart, and neither direction may turn away from the way between them by 90° or more.
[[nodiscard]] Biarc biarcBetween(const Station& start, const Station& end);

} // namespace arris::geometry
