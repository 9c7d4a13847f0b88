#pragma once

#include "core/geometry/curve.h"

namespace arris::geometry {

/// Nearest point of a parabola, to within 1 nm of the distance.
[[nodiscard]] Nearest nearestOnParabola(const Parabola& parabola, const Point& point);

} // namespace arris::geometry
