#include "tests/support/spline_points.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace arris::test {

using geometry::Curve;
using geometry::Point;

namespace {

double basis(const std::vector<double>& knots, std::size_t i, int degree, double u) {
  if (degree == 0) {
    return knots[i] <= u && u < knots[i + 1] ? 1 : 0;
  }
  const auto p = static_cast<std::size_t>(degree);
  const double before = knots[i + p] - knots[i];
  const double after = knots[i + p + 1] - knots[i + 1];
  double value = 0;
  if (before > 0) {
    value += (u - knots[i]) / before * basis(knots, i, degree - 1, u);
  }
  if (after > 0) {
    value += (knots[i + p + 1] - u) / after * basis(knots, i + 1, degree - 1, u);
  }
  return value;
}

/// From the curve between two parameters: about the nearest of some points, by parting the range in three again and
/// again.
double refined(const std::function<Point(double)>& curve, double low, double high, const Point& point) {
  constexpr int kSteps = 16;
  const double step = (high - low) / kSteps;
  double best = low;
  for (int i = 1; i <= kSteps; ++i) {
    const double u = low + step * i;
    best = (curve(u) - point).squaredNorm() < (curve(best) - point).squaredNorm() ? u : best;
  }
  high = std::min(high, best + step);
  low = std::max(low, best - step);
  for (int i = 0; i < 40; ++i) {
    const double a = low + (high - low) / 3;
    const double b = high - (high - low) / 3;
    const bool isLow = (curve(a) - point).squaredNorm() < (curve(b) - point).squaredNorm();
    (isLow ? high : low) = isLow ? b : a;
  }
  return (curve((low + high) / 2) - point).norm();
}

/// About each of the curve's points that is nearer than its neighbours: the nearest of all need not be the one.
double distanceFrom(const std::function<Point(double)>& curve, const std::vector<Point>& points, double from,
                    double step, const Point& point) {
  const auto away = [&](std::size_t i) {
    return i < points.size() ? (points[i] - point).norm() : std::numeric_limits<double>::infinity();
  };
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double before = i > 0 ? away(i - 1) : std::numeric_limits<double>::infinity();
    if (away(i) <= before && away(i) <= away(i + 1)) {
      const double middle = from + step * (static_cast<double>(i) + 0.5);
      const double last = from + step * static_cast<double>(points.size());
      nearest = std::min(nearest, refined(curve, std::max(from, middle - step), std::min(last, middle + step), point));
    }
  }
  return nearest;
}

} // namespace

Point basisPoint(const geometry::Spline& spline, double u) {
  Point sum = Point::Zero();
  double weights = 0;
  const auto degree = static_cast<std::size_t>(spline.degree);
  const auto span =
      static_cast<std::size_t>(std::upper_bound(spline.knots.begin(), spline.knots.end(), u) - spline.knots.begin());
  const std::size_t first = span > degree + 1 ? span - degree - 1 : 0;
  for (std::size_t i = first; i < std::min(span, spline.points.size()); ++i) {
    const double weight = basis(spline.knots, i, spline.degree, u) * (spline.weights.empty() ? 1 : spline.weights[i]);
    sum += weight * spline.points[i];
    weights += weight;
  }
  return sum / weights;
}

geometry::Spline randomSpline(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&random](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  geometry::Spline spline;
  spline.degree = 1 + static_cast<int>(random() % 7);
  const auto degree = static_cast<std::size_t>(spline.degree);
  const std::size_t count = degree + 3 + random() % 10;
  for (std::size_t i = 0; i < count; ++i) {
    spline.points.emplace_back(uniform(-200, 200), uniform(-200, 200));
  }
  const bool clamped = random() % 3 != 0;
  double knot = uniform(-5, 5);
  std::size_t times = 0;
  for (std::size_t i = 0; i < count + degree + 1; ++i) {
    const bool atAnEnd = i <= degree || i > count;
    const bool again = times < degree && !atAnEnd && random() % 4 == 0; // once more would break the curve
    const bool repeats = i > 0 && ((clamped && atAnEnd) || again);
    knot += repeats ? 0 : uniform(0.1, 1);
    times = repeats ? times + 1 : 1;
    spline.knots.push_back(knot);
  }
  if (clamped) {
    std::fill(spline.knots.begin() + static_cast<std::ptrdiff_t>(count), spline.knots.end(), spline.knots.back() + 1);
  }
  for (std::size_t i = 0; random() % 2 == 0 && i < count; ++i) {
    spline.weights.resize(count, 1);
    spline.weights[i] = std::exp(uniform(-2, 2));
  }
  return spline;
}

geometry::Spline circleAsSpline(const Point& center, double radius, int pieces) {
  geometry::Spline spline;
  spline.degree = 2;
  const double half = base::kPi / pieces;
  for (int i = 0; i <= 2 * pieces; ++i) {
    const bool outside = i % 2 == 1;
    const double reach = outside ? radius / std::cos(half) : radius;
    spline.points.emplace_back(center + reach * Point(std::cos(half * i), std::sin(half * i)));
    spline.weights.push_back(outside ? std::cos(half) : 1);
  }
  spline.knots.push_back(0);
  for (int i = 0; i <= pieces; ++i) {
    spline.knots.insert(spline.knots.end(), 2, i);
  }
  spline.knots.push_back(pieces);
  return spline;
}

Apart apart(const std::function<Point(double)>& curve, double from, double to, const std::vector<Curve>& chain) {
  constexpr int kPlaces = 3000;
  const double step = (to - from) / kPlaces;
  Apart result;
  std::vector<Point> points;
  for (int i = 0; i < kPlaces; ++i) { // the middle of each step: never on a knot
    points.push_back(curve(from + step * (i + 0.5)));
    double nearest = 1e300;
    for (const Curve& part : chain) {
      nearest = std::min(nearest, geometry::nearest(part, points.back()).distance);
    }
    result.curveFromChain = std::max(result.curveFromChain, nearest);
  }
  for (const Curve& part : chain) {
    for (const double share : {0.1, 0.5, 0.8}) {
      const Point point = geometry::pointAt(part, share * geometry::parameterLength(part));
      result.chainFromCurve = std::max(result.chainFromCurve, distanceFrom(curve, points, from, step, point));
    }
  }
  return result;
}

Joints jointsOf(const std::vector<Curve>& chain) {
  Joints joints;
  for (std::size_t i = 1; i < chain.size(); ++i) {
    joints.gap = std::max(joints.gap, (geometry::endPoint(chain[i - 1]) - geometry::startPoint(chain[i])).norm());
    joints.turn = std::max(
        joints.turn, std::abs(geometry::turn(geometry::endTangent(chain[i - 1]), geometry::startTangent(chain[i]))));
  }
  return joints;
}

} // namespace arris::test
