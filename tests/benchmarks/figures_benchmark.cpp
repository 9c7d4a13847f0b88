#include "core/job/job.h"
#include "tests/benchmarks/application.h"
#include "tests/support/panes.h"
#include "ui/figures/preview_figure.h"
#include "ui/figures/profile_figure.h"

#include <benchmark/benchmark.h>

namespace arris {
namespace {

const job::Job& triangle() {
  static const job::Job kJob = job::planJob(test::triangle600(), {}, {});
  return kJob;
}

void previewAsSvg(benchmark::State& state) {
  needApplication();
  for (auto _ : state) {
    const ui::Drawing drawing = ui::drawingOf(triangle());
    const ui::Figure figure = ui::previewFigure(drawing, ui::previewTitle(triangle(), QStringLiteral("triangle")));
    benchmark::DoNotOptimize(ui::encoded(figure, ui::FigureFormat::Svg));
  }
}

BENCHMARK(previewAsSvg)->Unit(benchmark::kMillisecond);

void profileAsPdf(benchmark::State& state) {
  needApplication();
  for (auto _ : state) {
    const ui::Figure figure = ui::profileFigure(triangle(), QStringLiteral("triangle"));
    benchmark::DoNotOptimize(ui::encoded(figure, ui::FigureFormat::Pdf));
  }
}

BENCHMARK(profileAsPdf)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace arris
