#pragma once

#include "core/geometry/curve.h"

#include <optional>

namespace arris::toolpath {

/// The arc that takes the place of a kink, and how much of the path before and after the kink it replaces, mm.
struct KinkArc {
  geometry::Arc arc;
  double cutBefore = 0;
  double cutAfter = 0;
};

/// The arc tangential to both paths at the kink where `before` ends and `after` starts, on the wheel's side (+1 left,
/// −1 right) of them: as large as `kKinkDeviation` allows, replacing no more than `mostBefore` and `mostAfter`. None
/// where it would be smaller than `kLeastKinkRadius`, or the path turns away from the wheel's side.
[[nodiscard]] std::optional<KinkArc> arcAtKink(const geometry::Curve& before, const geometry::Curve& after, double side,
                                               double mostBefore, double mostAfter);

} // namespace arris::toolpath
