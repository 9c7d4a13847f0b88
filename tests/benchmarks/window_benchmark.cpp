// What the operator waits for: from a changed value to the new drawing, one repaint of a large one, the window made
// anew in another appearance. By the clock, not by the processor's time: much of it happens in the background.

#include "core/base/numbers.h"
#include "tests/benchmarks/application.h"
#include "tests/support/panes.h"
#include "tests/support/scratch.h"
#include "ui/main_window.h"
#include "ui/views/drawing_view.h"

#include <QScrollBar>

#include <benchmark/benchmark.h>

#include <cmath>

namespace arris {
namespace {

constexpr QSize kLargeView(1920, 1080);
constexpr std::int64_t kManySegments = 100'000;

/// A pane with a waved edge in chords that stay chords.
pattern::Pattern wavedPane(std::int64_t chords) {
  std::vector<geometry::Point> corners;
  for (std::int64_t i = 0; i < chords; ++i) {
    const double angle = 2 * base::kPi * static_cast<double>(i) / static_cast<double>(chords);
    const double radius = 550 + 20 * std::cos(8 * angle);
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return test::polygon(corners);
}

ui::PlannerSteps waved(std::int64_t chords) {
  ui::PlannerSteps steps = ui::plannerSteps();
  steps.read = [chords](const auto& file, const auto& options, const auto&) {
    return ui::Import{file, options, wavedPane(chords), {}};
  };
  return steps;
}

void waitFor(const bool& done) {
  while (!done) {
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
}

/// Shown, so that it is painted.
void show(ui::DrawingView& view) {
  view.resize(kLargeView);
  view.show();
  for (int i = 0; i < 10; ++i) {
    QCoreApplication::processEvents();
  }
}

void waitUntilDrawn(const ui::DrawingView& view, const bool& planned) {
  waitFor(planned);
  while (!view.isUpToDate()) {
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
}

void recipeChangeToDrawing(benchmark::State& state) {
  needApplication();
  ui::Planner planner({}, waved(state.range(0)));
  ui::DrawingView view;
  show(view);
  bool planned = false;
  QObject::connect(&planner, &ui::Planner::planned, &view, [&](const ui::PlanPointer& plan) {
    view.setPlan(plan);
    view.viewport()->repaint();
    planned = true;
  });
  planner.openPattern("waved.dxf");
  waitUntilDrawn(view, planned);
  recipe::Recipe recipe;
  for (auto _ : state) {
    recipe.depth = recipe.depth == 0.3 ? 0.2 : 0.3;
    planned = false;
    planner.setRecipe(recipe);
    waitUntilDrawn(view, planned);
  }
}

BENCHMARK(recipeChangeToDrawing)
    ->Arg(1000)
    ->Arg(100000)
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

ui::PlanPointer manySegments() {
  static const ui::PlanPointer kPlan = [] {
    const auto import = std::make_shared<const ui::Import>(ui::Import{"waved.dxf", {}, wavedPane(kManySegments), {}});
    return ui::planOf(import, job::planJob(import->pattern, {}, {}));
  }();
  return kPlan;
}

/// Of a drawing that fills the view, or of a part of it `zoom` times as large.
void repaintPanning(benchmark::State& state) {
  needApplication();
  ui::DrawingView view;
  show(view);
  view.setPlan(manySegments());
  for (std::int64_t i = 0; i < state.range(0); ++i) {
    view.zoomIn();
  }
  view.viewport()->repaint();
  waitUntilDrawn(view, true);
  int step = 3;
  std::int64_t frames = 0;
  for (auto _ : state) {
    step = ++frames % 200 == 0 ? -step : step;
    view.horizontalScrollBar()->setValue(view.horizontalScrollBar()->value() + step);
    view.viewport()->repaint();
    QCoreApplication::processEvents(); // what was painted beside arrives
  }
}

BENCHMARK(repaintPanning)->ArgName("zoomSteps")->Arg(0)->Arg(6)->Arg(12)->Unit(benchmark::kMillisecond);

void repaintRunning(benchmark::State& state) {
  needApplication();
  ui::DrawingView view;
  show(view);
  const ui::PlanPointer plan = manySegments();
  view.setPlan(plan);
  const auto& track = plan->job.track;
  int segment = 0;
  view.setWheel(ui::LiveWheel{{0, 0}, {0, 0}});
  view.viewport()->repaint();
  waitUntilDrawn(view, true);
  for (auto _ : state) { // a report each 20 ms: so many segments at most at the usual feed
    segment = (segment + 10) % static_cast<int>(track.size());
    const auto& way = track[static_cast<std::size_t>(segment)];
    const double middle = motion::parameterLength(way) / 2;
    view.setWheel(ui::LiveWheel{motion::evaluate(way, middle).point.head<2>(), {segment, middle}});
    view.viewport()->repaint();
  }
}

BENCHMARK(repaintRunning)->Unit(benchmark::kMillisecond);

// The axes go on meanwhile; half a second without an answer ends the job.
void windowMadeAnew(benchmark::State& state) {
  needApplication();
  const test::Scratch scratch;
  ui::MainWindow window({{}, {scratch / "state"}, control::Pace::Simulated}, waved(1000));
  window.resize(kLargeView);
  window.show();
  bool isPlanned = false;
  QObject::connect(&window.planner(), &ui::Planner::planned, &window, [&] { isPlanned = true; });
  window.openPattern("waved.dxf");
  waitFor(isPlanned);
  files::Settings settings;
  for (auto _ : state) {
    const bool wasDark = settings.appearance == files::Settings::Appearance::Dark;
    settings.appearance = wasDark ? files::Settings::Appearance::Light : files::Settings::Appearance::Dark;
    window.preferences().change(settings);
    QCoreApplication::processEvents();
    window.repaint();
  }
}

BENCHMARK(windowMadeAnew)->UseRealTime()->Unit(benchmark::kMillisecond);

} // namespace
} // namespace arris
