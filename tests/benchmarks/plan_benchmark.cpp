#include "core/base/numbers.h"
#include "core/files/gcode.h"
#include "core/files/report.h"
#include "core/job/job.h"
#include "tests/support/panes.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace arris {
namespace {

/// A circle of radius 600 in chords, as a CAD system exports it.
pattern::Pattern choppedCircle(std::int64_t count) {
  std::vector<geometry::Point> corners;
  for (std::int64_t i = 0; i < count; ++i) {
    const double angle = 2 * base::kPi * static_cast<double>(i) / static_cast<double>(count);
    corners.emplace_back(600 * std::cos(angle), 600 * std::sin(angle));
  }
  return test::polygon(corners);
}

/// What a change of a value in the window asks for before it can draw.
void planOfEntities(benchmark::State& state) {
  const pattern::Pattern pattern = choppedCircle(state.range(0));
  for (auto _ : state) {
    const job::Job job = job::planJob(pattern, {}, {});
    if (!job.canBeGround()) {
      state.SkipWithError("the pane was refused");
    }
  }
}

BENCHMARK(planOfEntities)->Arg(1000)->Arg(100000)->Unit(benchmark::kMillisecond);

void reportAndGCode(benchmark::State& state) {
  const pattern::Pattern pattern = choppedCircle(state.range(0));
  const job::Job job = job::planJob(pattern, {}, {});
  for (auto _ : state) {
    benchmark::DoNotOptimize(files::report(pattern, job, "circle.dxf"));
    benchmark::DoNotOptimize(files::gcode(job, "circle.dxf", files::TransitionForm::Spline));
  }
}

BENCHMARK(reportAndGCode)->Arg(1000)->Arg(100000)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace arris
