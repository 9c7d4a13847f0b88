#include "core/motion/speed_limits.h"

#include "core/base/numbers.h"
#include "core/motion/axis_range.h"
#include "core/motion/reachability.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace arris::motion {
namespace {

using base::kPi;
using base::squared;
using geometry::Arc;
using geometry::Parabola;

/// λ̈ is held over at most this angle on an arc, rad. What is lost against the optimum grows with it: 0.4 % of the time
/// at 0.01, below 0.05 % here.
constexpr double kArcStep = 0.001;

/// A blend is cut into this many intervals, beside those where an axis turns round.
constexpr int kBlendSteps = 64;

/// Two boundaries nearer than this share of the segment are one.
constexpr double kSameBoundary = 1e-9;

void addUniform(std::vector<double>& boundaries, double length, int steps) {
  for (int i = 1; i < steps; ++i) {
    boundaries.push_back(length * i / steps);
  }
}

// λ where an axis changes the sign of q' or (on arcs) of q''.
void addTurningPoints(std::vector<double>& boundaries, const Arc& arc) {
  const double heading = std::atan2(arc.tangent.y(), arc.tangent.x());
  const double quarter = kPi / 2;
  const double first = heading + std::min(0.0, arc.sweep());
  const double last = heading + std::max(0.0, arc.sweep());
  for (double k = std::ceil(first / quarter); k * quarter <= last; ++k) {
    boundaries.push_back((k * quarter - heading) / arc.curvature);
  }
}

void addTurningPoints(std::vector<double>& boundaries, const Parabola& p, double length) {
  const geometry::Vector before = p.q - p.a;
  const geometry::Vector after = p.c - p.q;
  for (int axis = 0; axis < 2; ++axis) {
    boundaries.push_back(length * before[axis] / (before[axis] - after[axis]));
  }
}

// Where the intervals of a segment begin and end, ascending from 0 to its length.
std::vector<double> boundaries(const Segment& segment, double length, const AxisLimits& limits) {
  if (isUniform(segment, limits)) {
    return {0, length};
  }
  std::vector<double> inner;
  if (const auto* arc = std::get_if<Arc>(&segment.shape)) {
    addUniform(inner, length, static_cast<int>(std::ceil(std::abs(arc->sweep()) / kArcStep)));
    addTurningPoints(inner, *arc);
  } else {
    addUniform(inner, length, kBlendSteps);
    addTurningPoints(inner, std::get<Parabola>(segment.shape), length);
  }
  std::sort(inner.begin(), inner.end());
  std::vector<double> result{0};
  const double same = kSameBoundary * length;
  for (const double lambda : inner) {
    if (lambda > result.back() + same && lambda < length - same) {
      result.push_back(lambda);
    }
  }
  result.push_back(length);
  return result;
}

// The greatest share of the speed that falls to each axis on a segment of one interval.
Eigen::Vector3d greatestShare(const Segment& segment) {
  const double length = parameterLength(segment);
  Eigen::Vector3d share = evaluate(segment, 0).first.cwiseAbs().cwiseMax(evaluate(segment, length).first.cwiseAbs());
  if (const auto* arc = std::get_if<Arc>(&segment.shape)) { // maybe a whole circle
    std::vector<double> turning;
    addTurningPoints(turning, *arc);
    for (const double lambda : turning) {
      share = share.cwiseMax(evaluate(segment, lambda).first.cwiseAbs());
    }
  }
  return share;
}

// λ̇² that the segment lets pass wherever the axes' speeds do not bind.
double constantCap2(const Segment& segment, const AxisLimits& limits) {
  double cap = std::min(segment.speedCap, kHighestOverride * segment.feed);
  const auto* arc = std::get_if<Arc>(&segment.shape);
  if (arc && limits.rule == recipe::AccelerationRule::Combined) {
    cap = std::min(cap, std::sqrt(uniformAcceleration(segment, limits) * arc->radius()));
  }
  return squared(cap);
}

double uniformCap2(const Segment& segment, const AxisLimits& limits) {
  const Eigen::Vector3d share = greatestShare(segment);
  double cap2 = constantCap2(segment, limits);
  for (int axis = 0; axis < 3; ++axis) {
    if (cap2 * squared(share[axis]) > squared(limits.speed[axis])) {
      cap2 = squared(limits.speed[axis] / share[axis]);
    }
  }
  return cap2;
}

// Lowers the caps at both ends of an interval in which no axis turns round, so that the straight line between them
// keeps the machine's speeds: (v_max,i / q'_i)² is convex over λ, and lies above its tangent in the middle.
void lowerToMachine(double& atFrom, double& atTo, const Segment& segment, double from, double to,
                    const AxisLimits& limits) {
  const Evaluation first = evaluate(segment, from);
  const Evaluation last = evaluate(segment, to);
  for (int axis = 0; axis < 2; ++axis) {
    const double share = std::max(std::abs(first.first[axis]), std::abs(last.first[axis]));
    const double limit2 = squared(limits.speed[axis]);
    if (std::max(atFrom, atTo) * squared(share) <= limit2) {
      continue;
    }
    const Evaluation middle = evaluate(segment, (from + to) / 2);
    const double tangent = limit2 / squared(middle.first[axis]);
    const double half = tangent * middle.second[axis] / middle.first[axis] * (to - from); // that it falls by
    const bool isSteep = !(std::abs(half) < tangent / 2);
    atFrom = std::min(atFrom, isSteep ? limit2 / squared(share) : tangent + half);
    atTo = std::min(atTo, isSteep ? limit2 / squared(share) : tangent - half);
  }
}

// λ̇² at the ends of a segment's intervals, one more than there are intervals; straight lines between them.
std::vector<double> caps2(const Segment& segment, const AxisLimits& limits, const std::vector<double>& ends) {
  if (isUniform(segment, limits)) {
    return std::vector<double>(ends.size(), uniformCap2(segment, limits));
  }
  std::vector<double> result(ends.size(), constantCap2(segment, limits));
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    lowerToMachine(result[i], result[i + 1], segment, ends[i], ends[i + 1], limits);
  }
  return result;
}

// Braking stays possible: an axis that would have to be pushed on while the path turns it back binds the speed alone.
double brakingLimit(double most, const Eigen::Vector2d& first, const Eigen::Vector2d& inside,
                    const Eigen::Vector2d& second, const Eigen::Vector2d& limits) {
  for (int axis = 0; axis < 2; ++axis) {
    const bool opposed = first[axis] == 0 || inside[axis] * second[axis] <= 0;
    const double share = std::abs(second[axis]);
    if (opposed && most * share > limits[axis]) {
      most = limits[axis] / share;
    }
  }
  return most;
}

/// The backward pass over one interval after the other, from the end.
class BackwardPass {
public:
  explicit BackwardPass(AxisLimits limits) : m_limits(std::move(limits)) {}

  void enter(const Segment& segment) {
    if (segment.stopAtEnd) {
      m_next2 = 0;
    }
  }

  void uniform(const Segment& segment, Interval& interval) {
    interval.end2 = std::min(m_next2, interval.cap2);
    interval.brake = uniformAcceleration(segment, m_limits);
    m_next2 = std::min(interval.cap2, interval.end2 + 2 * interval.brake * (interval.to - interval.from));
  }

  void curved(Interval& interval, const Evaluation& from, const Evaluation& to) {
    const Eigen::Vector2d most = planningLimits(m_limits).head<2>();
    const Eigen::Vector2d inside = (from.first + to.first).head<2>();
    const double endMost = brakingLimit(interval.capEnd2, to.first.head<2>(), inside, to.second.head<2>(), most);
    const double startMost = brakingLimit(interval.cap2, from.first.head<2>(), inside, from.second.head<2>(), most);
    interval.end2 = std::min(m_next2, endMost);

    const double twice = 2 * (interval.to - interval.from);
    ReachProblem problem;
    for (int axis = 0; axis < 2; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      problem.rows[i] = {from.second[axis] - from.first[axis] / twice, from.first[axis] / twice, most[axis]};
      problem.rows[i + 2] = {-to.first[axis] / twice, to.second[axis] + to.first[axis] / twice, most[axis]};
    }
    problem.startMost = startMost;
    problem.endMost = interval.end2;
    const ReachResult reach = greatestStart(problem);
    interval.brake = std::max(0.0, (reach.start - interval.end2) / twice);
    m_next2 = reach.start;
  }

private:
  AxisLimits m_limits;
  double m_next2 = 0; ///< K² where the interval that comes next ends; at rest at the end of the track
};

} // namespace

AxisLimits axisLimits(const recipe::Recipe& recipe, const recipe::Machine& machine) {
  return {{recipe.accelX, recipe.accelY, recipe.accelZ}, machine.maxSpeed / 60, recipe.accelerationRule};
}

std::vector<Interval> speedLimits(const std::vector<Segment>& track, const AxisLimits& limits,
                                  const std::stop_token& stop) {
  std::vector<Interval> result; // from the last to the first
  BackwardPass pass(limits);
  for (std::size_t s = track.size(); s-- > 0 && !stop.stop_requested();) {
    const Segment& segment = track[s];
    const std::vector<double> ends = boundaries(segment, parameterLength(segment), limits);
    const std::vector<double> caps = caps2(segment, limits, ends);
    pass.enter(segment);
    Evaluation atEnd = evaluate(segment, ends.back());
    for (std::size_t i = ends.size() - 1; i-- > 0;) {
      const Evaluation atStart = evaluate(segment, ends[i]);
      Interval interval{static_cast<int>(s), ends[i], ends[i + 1], caps[i], caps[i + 1], 0, 0};
      if (isUniform(segment, limits)) {
        pass.uniform(segment, interval);
      } else {
        pass.curved(interval, atStart, atEnd);
      }
      result.push_back(interval);
      atEnd = atStart;
    }
  }
  std::reverse(result.begin(), result.end());
  return result;
}

Interval restToRest(const Segment& straight, const AxisLimits& limits) {
  const double cap2 = uniformCap2(straight, limits);
  return {0, 0, parameterLength(straight), cap2, cap2, 0, uniformAcceleration(straight, limits)};
}

} // namespace arris::motion
