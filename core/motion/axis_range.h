#pragma once

#include "core/motion/speed_limits.h"

namespace arris::motion {

/// The λ̈ that the axes admit in one state, mm/s²; least ≤ 0 in every state below K.
struct AccelerationRange {
  double least = 0;
  double most = 0;
};

/// Whether the axes bind λ̈ alone, whatever the speed (straight moves, and everything under AccelerationRule::Combined);
/// the range is then ±`uniformAcceleration` all along the segment.
[[nodiscard]] bool isUniform(const Segment& segment, const AxisLimits& limits);
[[nodiscard]] double uniformAcceleration(const Segment& segment, const AxisLimits& limits);

/// Limits of the axes for planning, mm/s²: with the margin of the rule `PerAxis`.
[[nodiscard]] Eigen::Vector3d planningLimits(const AxisLimits& limits);

/// The λ̈ that may be held from λ with λ̇² = `speed2` to the end of the interval: within the axis limits at both ends
/// of that stretch, and so inside it. Along a parabola an axis' acceleration is linear in λ while λ̈ is constant, so
/// this is exact; on an arc it is within the margin.
[[nodiscard]] AccelerationRange admissible(const Segment& segment, const Interval& interval, const AxisLimits& limits,
                                           double lambda, double speed2);

} // namespace arris::motion
