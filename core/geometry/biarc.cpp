#include "core/geometry/biarc.h"

#include "core/base/numbers.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace arris::geometry {
namespace {

/// A curve may be turned by this much without anybody noticing, rad: a tenth of what counts as tangential.
constexpr double kUnnoticedTurn = base::kTangentTurn / 10;

/// A shallower arc than this between its ends and its middle is a line, rad.
constexpr double kStraightTurn = kUnnoticedTurn / 10;

/// The arc from a point in a given direction to another point; a line where that lies straight ahead.
Curve arcFrom(const Point& from, const Vector& tangent, const Point& to) {
  const Vector chord = to - from;
  const double half = turn(tangent, chord);
  if (std::abs(half) < kStraightTurn) {
    return Line{from, to};
  }
  const double curvature = 2 * std::sin(half) / chord.norm();
  return Arc{from, tangent, curvature, 2 * half / curvature};
}

/// The one arc from 0 to `to` that both are, if they are; two all but straight ones may make up a line.
std::optional<Curve> common(const Curve& first, const Curve& second, const Point& to) {
  const auto* a = std::get_if<Arc>(&first);
  const auto* b = std::get_if<Arc>(&second);
  const double length = parameterLength(first) + parameterLength(second);
  if (a && b && std::abs(a->curvature - b->curvature) * length * std::max(1.0, length) < kUnnoticedTurn) {
    const double sweep = a->sweep() + b->sweep();
    return std::abs(sweep) < kStraightTurn ? Curve(Line{a->start, to})
                                           : Curve(Arc{a->start, a->tangent, sweep / length, length});
  }
  return std::nullopt;
}

Curve shiftedBy(const Curve& curve, const Point& by) {
  if (const auto* line = std::get_if<Line>(&curve)) {
    return Line{line->from + by, line->to + by};
  }
  Arc arc = std::get<Arc>(curve);
  arc.start += by;
  return arc;
}

} // namespace

// |v|² = 2d v·(t₁+t₂) + 2d²(1 − t₁·t₂), all seen from the start: small numbers keep their digits.
Biarc biarcBetween(const Station& start, const Station& end) {
  const Vector v = end.point - start.point;
  const double along = v.dot(start.tangent + end.tangent);
  const double bend = (start.tangent - end.tangent).squaredNorm(); // 2(1 − t₁·t₂) without cancellation
  const double d = v.squaredNorm() / (along + std::sqrt(base::squared(along) + bend * v.squaredNorm()));
  const Point middle = (d * start.tangent + v - d * end.tangent) / 2;
  const Curve first = arcFrom(Point::Zero(), start.tangent, middle);
  const Curve second = reversed(arcFrom(v, -end.tangent, middle));
  if (const std::optional<Curve> one = common(first, second, v)) {
    return {shiftedBy(*one, start.point), std::nullopt};
  }
  return {shiftedBy(first, start.point), shiftedBy(second, start.point)};
}

} // namespace arris::geometry
