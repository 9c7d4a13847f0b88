// Speed limits by reachability (per grid point) and the forward pass (per set-point).

#include "core/base/numbers.h"
#include "core/job/job.h"
#include "tests/support/panes.h"
#include "tests/support/random_panes.h"

#include <benchmark/benchmark.h>

namespace arris {
namespace {

/// A disc: nothing but arc, where every grid point has the full reachability problem.
job::Job discJob() {
  const double radius = 400;
  const geometry::Arc circle{{radius, 0}, {0, 1}, 1 / radius, 2 * base::kPi * radius};
  return job::planJob(test::paneOf({circle}), {}, {});
}

job::Job roundedJob() {
  std::uint64_t seed = 1;
  return test::randomJob(seed);
}

void speedLimits(benchmark::State& state, const job::Job& job) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(motion::speedLimits(job.track, job.limits));
  }
  const auto points = static_cast<double>(job.intervals.size());
  state.counters["grid_points"] = points;
  state.counters["per_grid_point"] =
      benchmark::Counter(points, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void setPoints(benchmark::State& state, const job::Job& job) {
  std::size_t tick = 0;
  motion::Interpolator interpolator(job.track, job.intervals, job.limits);
  for (auto _ : state) {
    if (interpolator.atEnd()) {
      interpolator = motion::Interpolator(job.track, job.intervals, job.limits);
      tick = 0;
    }
    benchmark::DoNotOptimize(interpolator.advanceTo(0.001 * static_cast<double>(tick++)));
  }
}

void planning(benchmark::State& state, const pattern::Pattern& pattern) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(job::planJob(pattern, {}, {}));
  }
}

BENCHMARK_CAPTURE(speedLimits, disc, discJob());
BENCHMARK_CAPTURE(speedLimits, rounded_pane, roundedJob());
BENCHMARK_CAPTURE(setPoints, triangle, job::planJob(test::triangle600(), {}, {}));
BENCHMARK_CAPTURE(setPoints, disc, discJob());
BENCHMARK_CAPTURE(setPoints, rounded_pane, roundedJob());
BENCHMARK_CAPTURE(planning, triangle, test::triangle600());

} // namespace
} // namespace arris
