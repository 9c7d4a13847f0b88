#include "core/geometry/parabola_nearest.h"

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cstdint>

namespace arris::geometry {
namespace {

/// The distance has at most two minima along the parabola; between two of these steps at most one.
constexpr int kParabolaSteps = 16;
constexpr std::uintmax_t kMostIterations = 100;

} // namespace

Nearest nearestOnParabola(const Parabola& parabola, const Point& point) {
  const double length = parameterLength(parabola);
  const auto distance = [&](double lambda) { return (evaluate(parabola, lambda).point - point).norm(); };
  const auto slope = [&](double lambda) { // of half the squared distance
    const Evaluation on = evaluate(parabola, lambda);
    return (on.point - point).dot(on.first);
  };
  const auto stepAt = [&](int step) { return length * step / kParabolaSteps; };
  int best = 0;
  for (int step = 1; step <= kParabolaSteps; ++step) {
    best = distance(stepAt(step)) < distance(stepAt(best)) ? step : best;
  }
  double lambda = stepAt(best);
  const double low = stepAt(std::max(best - 1, 0));
  const double high = stepAt(std::min(best + 1, kParabolaSteps));
  if (slope(low) < 0 && slope(high) > 0) {
    std::uintmax_t iterations = kMostIterations;
    const boost::math::tools::eps_tolerance<double> exact;
    lambda = boost::math::tools::toms748_solve(slope, low, high, exact, iterations).first;
  }
  return {lambda, distance(lambda)};
}

} // namespace arris::geometry
