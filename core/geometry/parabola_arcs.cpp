#include "core/geometry/parabola_arcs.h"

#include "core/geometry/biarc.h"

#include <algorithm>
#include <cmath>

namespace arris::geometry {
namespace {

/// A station and its parameter λ.
struct Place {
  double lambda = 0;
  Station station;
};

Place placeAt(const Parabola& parabola, double lambda) {
  const Evaluation at = evaluate(parabola, lambda);
  return {lambda, {at.point, at.first.normalized()}};
}

/// The largest distance of the parabola between the stations from the arcs, seen at enough places that what lies
/// between them is no more than a few percent larger.
double deviation(const Parabola& parabola, const Place& start, const Place& end, const Biarc& biarc) {
  constexpr int kPlaces = 16;
  double largest = 0;
  for (int i = 1; i < kPlaces; ++i) {
    const Point point = pointAt(parabola, start.lambda + (end.lambda - start.lambda) * i / kPlaces);
    const double first = nearest(biarc.first, point).distance;
    largest = std::max(largest, biarc.second ? std::min(first, nearest(*biarc.second, point).distance) : first);
  }
  return largest;
}

} // namespace

std::vector<Arc> arcsAlong(const Parabola& parabola, double tolerance) {
  constexpr double kShareOfTolerance = 0.9; // of the tolerance, for what lies between the places looked at
  const double length = parameterLength(parabola);
  std::vector<Arc> arcs;
  Place start = placeAt(parabola, 0);
  double step = length / 2;
  while (start.lambda < length) {
    const double left = length - start.lambda;
    step = step >= left ? left : std::min(step, left / 2); // no sliver at the end
    const Place end = placeAt(parabola, step == left ? length : start.lambda + step);
    const Biarc biarc = biarcBetween(start.station, end.station);
    const double scale =
        std::cbrt(kShareOfTolerance * tolerance / deviation(parabola, start, end, biarc)); // deviation ~ step³
    if (scale >= 1) {
      arcs.push_back(std::get<Arc>(biarc.first)); // a parabola is bent everywhere
      if (biarc.second) {
        arcs.push_back(std::get<Arc>(*biarc.second));
      }
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
