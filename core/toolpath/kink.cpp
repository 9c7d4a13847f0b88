#include "core/toolpath/kink.h"

#include "core/base/numbers.h"
#include "core/geometry/meetings.h"
#include "core/toolpath/toolpath.h"

#include <algorithm>
#include <cmath>

namespace arris::toolpath {
namespace {

using geometry::Arc;
using geometry::Curve;
using geometry::Point;
using geometry::Track;
using geometry::Vector;

/// Where the path turns back by more than this there is no arc, rad.
constexpr double kMostTurn = 3;

/// A path that is moved to the wheel's side may lose this share of its radius.
constexpr double kMostShrunk = 0.98;

/// No arc is larger, mm.
constexpr double kMostRadius = 1e6;

/// The largest radius at a kink between straight paths: an arc passes the kink at ρ (1/cos(φ/2) − 1).
double radiusBetweenLines(double turn) {
  const double half = turn / 2;
  const double rise = 2 * base::squared(std::sin(half / 2)) / std::cos(half); // 1/cos − 1 without cancellation
  return std::min(kKinkDeviation / rise, kMostRadius);
}

/// λ on the path where it first meets the line or circle that the other is part of, if it does.
std::optional<double> firstMeeting(const Curve& path, const Curve& other) {
  const Track track(path);
  const Track::Meetings meetings = track.meetWhole(other);
  std::optional<double> first;
  for (std::size_t i = 0; i < meetings.count; ++i) {
    const double s = meetings.s[i];
    if (std::abs(s) <= track.end() && (!first || track.lambda(s) < *first)) {
      first = track.lambda(s);
    }
  }
  return first;
}

bool canBeMoved(const Curve& path, double by) {
  const auto* arc = std::get_if<Arc>(&path);
  return !arc || arc->curvature * by < kMostShrunk;
}

// The centre lies where both paths, moved by the radius, meet.
std::optional<KinkArc> arcOfRadius(const Curve& before, const Curve& after, double side, double radius) {
  if (!canBeMoved(before, side * radius) || !canBeMoved(after, side * radius)) {
    return std::nullopt;
  }
  const Curve movedAfter = geometry::offset(after, side * radius);
  const std::optional<double> lambda = firstMeeting(movedAfter, geometry::offset(before, side * radius));
  if (!lambda) {
    return std::nullopt;
  }
  const Point center = geometry::pointAt(movedAfter, *lambda);
  const double length = geometry::parameterLength(before);
  KinkArc result;
  result.cutBefore = length - geometry::nearest(before, center).lambda;
  result.cutAfter = *lambda * geometry::parameterLength(after) / geometry::parameterLength(movedAfter);
  const geometry::Evaluation from = geometry::evaluate(before, length - result.cutBefore);
  const Vector to = geometry::evaluate(after, result.cutAfter).first;
  result.arc = {from.point, from.first, side / radius, radius * std::abs(geometry::turn(from.first, to))};
  return result;
}

} // namespace

std::optional<KinkArc> arcAtKink(const Curve& before, const Curve& after, double side, double mostBefore,
                                 double mostAfter) {
  const double turn = side * geometry::turn(geometry::endTangent(before), geometry::startTangent(after));
  if (turn <= 0 || turn > kMostTurn) {
    return std::nullopt;
  }
  const Point kink = geometry::startPoint(after);
  double radius = std::min(radiusBetweenLines(turn), std::min(mostBefore, mostAfter) / std::tan(turn / 2));
  for (; radius >= kLeastKinkRadius; radius *= 0.8) { // curved paths may need a little less
    std::optional<KinkArc> arc = arcOfRadius(before, after, side, radius);
    const bool fits =
        arc && arc->cutBefore > 0 && arc->cutBefore <= mostBefore && arc->cutAfter > 0 && arc->cutAfter <= mostAfter;
    if (fits && geometry::nearest(arc->arc, kink).distance <= 1.001 * kKinkDeviation) {
      return arc;
    }
  }
  return std::nullopt;
}

} // namespace arris::toolpath
