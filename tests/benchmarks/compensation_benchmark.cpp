// Compensation of a closed convex contour by 75 mm, with corners 10 mm apart, beside Clipper 6.4 with round joins.

#include "core/base/numbers.h"
#include "core/toolpath/corners.h"
#include "tests/support/panes.h"

#include <benchmark/benchmark.h>
#include <polyclipping/clipper.hpp>

#include <cmath>

namespace arris {
namespace {

constexpr double kEdge = 10;       ///< mm
constexpr double kPerUnit = 1e5;   ///< Clipper's integers: 10 nm
constexpr double kArcError = 1e-3; ///< mm, of Clipper's chords round a corner

std::vector<geometry::Point> corners(std::int64_t count) {
  const double step = 2 * base::kPi / static_cast<double>(count);
  const double radius = kEdge / (2 * std::sin(step / 2));
  std::vector<geometry::Point> result;
  for (std::int64_t i = 0; i < count; ++i) {
    const double angle = step * static_cast<double>(i);
    result.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return result;
}

/// Every second edge bulges outwards by half of what the corners turn.
pattern::Contour contourOfLinesAndArcs(std::int64_t count) {
  pattern::Contour contour = test::polygon(corners(count)).contours.front();
  for (std::size_t i = 0; i < contour.curves.size(); i += 2) {
    geometry::Curve& curve = contour.curves[i];
    curve = geometry::arcBetween(geometry::startPoint(curve), geometry::endPoint(curve),
                                 base::kPi / static_cast<double>(count));
  }
  return contour;
}

void compensation(benchmark::State& state, const pattern::Contour& contour) {
  const recipe::Recipe recipe;
  for (auto _ : state) {
    base::Problems problems;
    benchmark::DoNotOptimize(toolpath::compensate(contour, recipe, problems));
  }
}

void lines(benchmark::State& state) {
  compensation(state, test::polygon(corners(state.range(0))).contours.front());
  state.SetComplexityN(state.range(0));
}

void linesAndArcs(benchmark::State& state) {
  compensation(state, contourOfLinesAndArcs(state.range(0)));
  state.SetComplexityN(state.range(0));
}

void clipper(benchmark::State& state) {
  ClipperLib::Path path;
  for (const geometry::Point& corner : corners(state.range(0))) {
    path.emplace_back(std::llround(corner.x() * kPerUnit), std::llround(corner.y() * kPerUnit));
  }
  for (auto _ : state) {
    ClipperLib::ClipperOffset offset(2, kArcError * kPerUnit);
    offset.AddPath(path, ClipperLib::jtRound, ClipperLib::etClosedPolygon);
    ClipperLib::Paths result;
    offset.Execute(result, 75 * kPerUnit);
    benchmark::DoNotOptimize(result);
  }
}

BENCHMARK(lines)->RangeMultiplier(10)->Range(1000, 100000)->Complexity()->Unit(benchmark::kMillisecond);
BENCHMARK(linesAndArcs)->RangeMultiplier(10)->Range(1000, 100000)->Complexity()->Unit(benchmark::kMillisecond);
BENCHMARK(clipper)->RangeMultiplier(10)->Range(1000, 10000)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace arris
