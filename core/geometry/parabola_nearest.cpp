#include "core/geometry/parabola_nearest.h"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <limits>

namespace arris::geometry {
namespace {

/// The squared distance has at most two minima along the parabola; between two of these steps at most one.
constexpr int kParabolaSteps = 16;
constexpr int kParabolaBits = std::numeric_limits<double>::digits / 2; // as near as a minimum can be told

} // namespace

Nearest nearestOnParabola(const Parabola& parabola, const Point& point) {
  const double length = parameterLength(parabola);
  const auto squared = [&](double lambda) { return (evaluate(parabola, lambda).point - point).squaredNorm(); };
  const auto stepAt = [&](int step) { return length * step / kParabolaSteps; };
  int best = 0;
  for (int step = 1; step <= kParabolaSteps; ++step) {
    best = squared(stepAt(step)) < squared(stepAt(best)) ? step : best;
  }
  const double low = stepAt(std::max(best - 1, 0));
  const double high = stepAt(std::min(best + 1, kParabolaSteps));
  auto [lambda, least] = boost::math::tools::brent_find_minima(squared, low, high, kParabolaBits);
  for (const double end : {low, high}) { // where it is at an end it is only approached
    if (squared(end) < least) {
      lambda = end;
      least = squared(end);
    }
  }
  return {lambda, std::sqrt(least)};
}

} // namespace arris::geometry
