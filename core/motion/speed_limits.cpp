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

// Inner boundaries of the intervals of a segment, ascending.
std::vector<double> boundaries(const Segment& segment, double length, const AxisLimits& limits) {
  std::vector<double> result;
  if (isUniform(segment, limits)) {
    return result;
  }
  if (const auto* arc = std::get_if<Arc>(&segment.shape)) {
    addUniform(result, length, static_cast<int>(std::ceil(std::abs(arc->sweep()) / kArcStep)));
    addTurningPoints(result, *arc);
  } else {
    addUniform(result, length, kBlendSteps);
    addTurningPoints(result, std::get<Parabola>(segment.shape), length);
  }
  std::sort(result.begin(), result.end());
  const double same = kSameBoundary * length;
  const auto outside = [=](double lambda) { return !(lambda > same && lambda < length - same); };
  result.erase(std::remove_if(result.begin(), result.end(), outside), result.end());
  result.erase(std::unique(result.begin(), result.end(), [=](double a, double b) { return b - a <= same; }),
               result.end());
  return result;
}

// The greatest share of the speed that falls to each axis on the way from one evaluation to the other.
Eigen::Vector3d greatestShare(const Segment& segment, const AxisLimits& limits, const Evaluation& from,
                              const Evaluation& to) {
  const auto* arc = std::get_if<Arc>(&segment.shape);
  if (arc && isUniform(segment, limits)) { // one interval may hold a whole circle
    std::vector<double> turning;
    addTurningPoints(turning, *arc);
    Eigen::Vector3d share = from.first.cwiseAbs().cwiseMax(to.first.cwiseAbs());
    for (const double lambda : turning) {
      share = share.cwiseMax(evaluate(segment, lambda).first.cwiseAbs());
    }
    return share;
  }
  return from.first.cwiseAbs().cwiseMax(to.first.cwiseAbs());
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

double speedCap2(const Segment& segment, const AxisLimits& limits, const Evaluation& from, const Evaluation& to) {
  const Eigen::Vector3d share = greatestShare(segment, limits, from, to);
  double cap = std::min(segment.speedCap, kHighestOverride * segment.feed);
  for (int axis = 0; axis < 3; ++axis) {
    if (cap * share[axis] > limits.speed[axis]) {
      cap = limits.speed[axis] / share[axis];
    }
  }
  const auto* arc = std::get_if<Arc>(&segment.shape);
  if (arc && limits.rule == recipe::AccelerationRule::Combined) {
    cap = std::min(cap, std::sqrt(uniformAcceleration(segment, limits) * arc->radius()));
  }
  return squared(cap);
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

  void uniform(const Segment& segment, Interval& interval, const Evaluation& from, const Evaluation& to) {
    interval.cap2 = speedCap2(segment, m_limits, from, to);
    interval.end2 = std::min(m_next2, interval.cap2);
    interval.brake = uniformAcceleration(segment, m_limits);
    m_next2 = std::min(interval.cap2, interval.end2 + 2 * interval.brake * (interval.to - interval.from));
  }

  void curved(const Segment& segment, Interval& interval, const Evaluation& from, const Evaluation& to) {
    const Eigen::Vector2d most = planningLimits(m_limits).head<2>();
    const Eigen::Vector2d inside = (from.first + to.first).head<2>();
    interval.cap2 = speedCap2(segment, m_limits, from, to);
    const double endMost = brakingLimit(interval.cap2, to.first.head<2>(), inside, to.second.head<2>(), most);
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

std::vector<Interval> speedLimits(const std::vector<Segment>& track, const AxisLimits& limits) {
  std::vector<Interval> result; // from the last to the first
  BackwardPass pass(limits);
  for (std::size_t s = track.size(); s-- > 0;) {
    const Segment& segment = track[s];
    const double length = parameterLength(segment);
    const std::vector<double> inner = boundaries(segment, length, limits);
    pass.enter(segment);
    double to = length;
    Evaluation atEnd = evaluate(segment, length);
    for (std::size_t b = inner.size() + 1; b-- > 0;) {
      const double from = b > 0 ? inner[b - 1] : 0;
      const Evaluation atStart = evaluate(segment, from);
      Interval interval{static_cast<int>(s), from, to, 0, 0, 0};
      if (isUniform(segment, limits)) {
        pass.uniform(segment, interval, atStart, atEnd);
      } else {
        pass.curved(segment, interval, atStart, atEnd);
      }
      result.push_back(interval);
      to = from;
      atEnd = atStart;
    }
  }
  std::reverse(result.begin(), result.end());
  return result;
}

} // namespace arris::motion
