#include "core/motion/axis_range.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arris::motion {
namespace {

using recipe::AccelerationRule;

/// The backward pass puts states exactly on the limits; what the range admits more keeps rounding from emptying it.
constexpr double kRangeSlack = 1 + 1e-9;

// The u with |a u + b| ≤ limit.
void intersect(AccelerationRange& range, double a, double b, double limit) {
  if (a == 0) {
    return;
  }
  const double one = (-limit - b) / a;
  const double other = (limit - b) / a;
  range.least = std::max(range.least, std::min(one, other));
  range.most = std::min(range.most, std::max(one, other));
}

} // namespace

bool isUniform(const Segment& segment, const AxisLimits& limits) {
  return limits.rule == AccelerationRule::Combined || std::holds_alternative<Vertical>(segment.shape) ||
         std::holds_alternative<geometry::Line>(segment.shape);
}

double uniformAcceleration(const Segment& segment, const AxisLimits& limits) {
  const Eigen::Vector3d most = planningLimits(limits);
  if (std::holds_alternative<Vertical>(segment.shape)) {
    return most.z();
  }
  if (limits.rule == AccelerationRule::Combined) {
    return most.head<2>().norm();
  }
  const Eigen::Vector3d direction = evaluate(segment, 0).first.cwiseAbs();
  return std::min(most.x() / direction.x(), most.y() / direction.y());
}

Eigen::Vector3d planningLimits(const AxisLimits& limits) {
  return (limits.rule == AccelerationRule::PerAxis ? kPlanningShare : 1) * limits.acceleration;
}

AccelerationRange admissible(const Segment& segment, const Interval& interval, const AxisLimits& limits, double lambda,
                             double speed2) {
  if (isUniform(segment, limits)) {
    const double most = uniformAcceleration(segment, limits);
    return {-most, most};
  }
  const Eigen::Vector2d most = kRangeSlack * planningLimits(limits).head<2>();
  const Evaluation here = evaluate(segment, lambda);
  const Evaluation end = evaluate(segment, interval.to);
  const double rest = interval.to - lambda;
  AccelerationRange range{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (int axis = 0; axis < 2; ++axis) {
    intersect(range, here.first[axis], here.second[axis] * speed2, most[axis]);
    intersect(range, end.first[axis] + 2 * rest * end.second[axis], end.second[axis] * speed2, most[axis]);
  }
  return range;
}

} // namespace arris::motion
