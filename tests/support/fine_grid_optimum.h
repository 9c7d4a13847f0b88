#pragma once

#include "core/motion/speed_limits.h"

namespace arris::test {

/// The time that the track takes at an override of 100 % when it is time-optimal under the limits of the axes, the
/// feed, the speed caps and "braking stays possible everywhere"; an independent calculation: bang-bang on a grid of
/// `step` mm (and a thousandth of the radius on arcs), each node with the limits at that node, bisected. Rule PerAxis.
/// Only segments from `first` to before `last`, from rest to rest.
[[nodiscard]] double fineGridOptimum(const std::vector<motion::Segment>& track, std::size_t first, std::size_t last,
                                     const motion::AxisLimits& limits, double step);

} // namespace arris::test
