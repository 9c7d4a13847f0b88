#pragma once

#include "core/geometry/curve.h"

namespace arris::geometry {

/// Nearest point of a parabola.
[[nodiscard]] Nearest nearestOnParabola(const Parabola& parabola, const Point& point);

} // namespace arris::geometry
