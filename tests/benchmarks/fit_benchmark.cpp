#include "core/base/numbers.h"
#include "core/pattern/fit_chords.h"
#include "tests/support/contours.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace arris {
namespace {

using geometry::Curve;
using geometry::Point;

/// Chords of a circle of radius 1 m with `waves` waves of 20 mm.
std::vector<Curve> chordsOf(std::int64_t count, int waves) {
  std::vector<Point> points;
  for (std::int64_t i = 0; i < count; ++i) {
    const double angle = 2 * base::kPi * static_cast<double>(i) / static_cast<double>(count);
    const double radius = 1000 + (waves > 0 ? 20 * std::cos(waves * angle) : 0);
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return test::closedLines(points);
}

void fitAll(benchmark::State& state, int waves) {
  const std::vector<Curve> chords = chordsOf(state.range(0), waves);
  std::size_t curves = 0;
  double deviation = 0;
  for (auto _ : state) {
    std::vector<Curve> chain = chords;
    deviation = pattern::fitChords(chain, 0.01).deviation;
    curves = chain.size();
  }
  state.counters["curves"] = static_cast<double>(curves);
  state.counters["deviation_um"] = 1000 * deviation;
}

void fitCircle(benchmark::State& state) {
  fitAll(state, 0);
}

void fitFreeForm(benchmark::State& state) {
  fitAll(state, 25);
}

BENCHMARK(fitCircle)->RangeMultiplier(10)->Range(1000, 100000)->Unit(benchmark::kMillisecond);
BENCHMARK(fitFreeForm)->RangeMultiplier(10)->Range(10000, 100000)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace arris
