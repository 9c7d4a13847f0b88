#include "core/geometry/parabola_arcs.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace arris::geometry {
namespace {

/// A place on the parabola: its parameter λ, the point and the unit direction of travel.
struct Station {
  double lambda = 0;
  Point point;
  Vector tangent;
};

Station stationAt(const Parabola& parabola, double lambda) {
  const Evaluation at = evaluate(parabola, lambda);
  return {lambda, at.point, at.first.normalized()};
}

using Biarc = std::array<Arc, 2>;

/// The arc that leaves `from` in direction `tangent` and meets `to`.
Arc arcTo(const Point& from, const Vector& tangent, const Point& to) {
  const Vector way = to - from;
  const double sine = cross(tangent, way);
  const double curvature = 2 * sine / way.squaredNorm();
  return {from, tangent, curvature, 2 * std::atan2(sine, tangent.dot(way)) / curvature};
}

/// The two arcs with equal tangent lengths d: |chord − d (t₀ + t₁)| = 2d, solved without cancellation.
Biarc biarcBetween(const Station& start, const Station& end) {
  const Vector chord = end.point - start.point;
  const double along = chord.dot(start.tangent + end.tangent);
  const double opening = (end.tangent - start.tangent).squaredNorm(); // 2 (1 − t₀·t₁)
  const double d = chord.squaredNorm() / (along + std::sqrt(along * along + opening * chord.squaredNorm()));
  const Point joint = (start.point + d * start.tangent + end.point - d * end.tangent) / 2;
  const Arc second = arcTo(end.point, -end.tangent, joint);
  return {arcTo(start.point, start.tangent, joint), std::get<Arc>(reversed(second))};
}

/// The largest distance of the parabola between the stations from the arcs, seen at enough places that what lies
/// between them is no more than a few percent larger.
double deviation(const Parabola& parabola, const Station& start, const Station& end, const Biarc& biarc) {
  constexpr int kPlaces = 16;
  double largest = 0;
  for (int i = 1; i < kPlaces; ++i) {
    const Point point = pointAt(parabola, start.lambda + (end.lambda - start.lambda) * i / kPlaces);
    largest = std::max(largest, std::min(nearest(biarc[0], point).distance, nearest(biarc[1], point).distance));
  }
  return largest;
}

} // namespace

std::vector<Arc> arcsAlong(const Parabola& parabola, double tolerance) {
  constexpr double kShare = 0.9; // of the tolerance, for what lies between the places looked at
  const double length = parameterLength(parabola);
  std::vector<Arc> arcs;
  Station start = stationAt(parabola, 0);
  double step = length / 2;
  while (start.lambda < length) {
    const double left = length - start.lambda;
    step = step >= left ? left : std::min(step, left / 2); // no sliver at the end
    const Station end = stationAt(parabola, step == left ? length : start.lambda + step);
    const Biarc biarc = biarcBetween(start, end);
    const double scale = std::cbrt(kShare * tolerance / deviation(parabola, start, end, biarc)); // deviation ~ step³
    if (scale >= 1) {
      arcs.insert(arcs.end(), biarc.begin(), biarc.end());
      start = end;
    }
    step *= std::clamp(scale, 0.1, 2.0);
  }
  return arcs;
}

std::vector<Point> chordsAlong(const Parabola& parabola, double tolerance) {
  const double length = parameterLength(parabola);
  const double bulge = (parabola.a - 2 * parabola.q + parabola.c).norm() / 4; // of one chord over the whole
  const int count = std::max(1, static_cast<int>(std::ceil(std::sqrt(bulge / tolerance))));
  std::vector<Point> points;
  points.reserve(static_cast<std::size_t>(count) + 1);
  for (int i = 0; i < count; ++i) {
    points.push_back(pointAt(parabola, length * i / count));
  }
  points.push_back(parabola.c);
  return points;
}

} // namespace arris::geometry
