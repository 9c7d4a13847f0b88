// Compensation of closed contours by 75 mm, with corners 10 mm apart, beside Clipper 6.4 with round joins: a waved
// contour with hollows too tight for the wheel, whose local shape does not depend on its size; the same with arcs; and
// a star of fixed size, where the wheel bridges the more points the more there are.

#include "core/base/numbers.h"
#include "core/toolpath/wheel_loop.h"
#include "tests/support/panes.h"

#include <benchmark/benchmark.h>
#include <polyclipping/clipper.hpp>

#include <cmath>

namespace arris {
namespace {

constexpr double kEdge = 10;       ///< mm
constexpr double kWave = 400;      ///< mm, length of a wave
constexpr double kAmplitude = 100; ///< mm, of a wave: hollows of down to 81 mm radius
constexpr double kTooth = 5;       ///< mm
constexpr double kPerUnit = 1e5;   ///< Clipper's integers: 10 nm
constexpr double kArcError = 1e-3; ///< mm, of Clipper's chords round a corner

/// A square whose sides are waved and serrated: corners `kEdge` apart along each side, every second one a tooth.
std::vector<geometry::Point> serrated(std::int64_t count) {
  const std::int64_t onSide = count / 4;
  const double side = kEdge * static_cast<double>(onSide);
  const double waves = std::round(side / kWave);
  std::vector<geometry::Point> result;
  for (std::int64_t i = 0; i < 4 * onSide; ++i) {
    const double along = kEdge * static_cast<double>(i % onSide);
    const double inwards =
        kAmplitude * base::squared(std::sin(base::kPi * waves * along / side)) + (i % 2 == 1 ? kTooth : 0);
    const std::int64_t quarterTurns = i / onSide;
    const Eigen::Rotation2Dd turned(base::kPi / 2 * static_cast<double>(quarterTurns));
    result.emplace_back(turned * geometry::Point(along - side / 2, inwards - side / 2));
  }
  return result;
}

std::vector<geometry::Point> star(std::int64_t count) {
  std::vector<geometry::Point> result;
  for (std::int64_t i = 0; i < count; ++i) {
    const double angle = 2 * base::kPi * static_cast<double>(i) / static_cast<double>(count);
    const double r = i % 2 == 0 ? 1000 : 600;
    result.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return result;
}

/// Every second edge bulges outwards by 3°.
pattern::Contour contourOfLinesAndArcs(std::int64_t count) {
  pattern::Contour contour = test::polygon(serrated(count)).contours.front();
  for (std::size_t i = 0; i < contour.curves.size(); i += 2) {
    geometry::Curve& curve = contour.curves[i];
    curve = geometry::arcBetween(geometry::startPoint(curve), geometry::endPoint(curve), base::radians(3));
  }
  return contour;
}

void compensation(benchmark::State& state, const pattern::Contour& contour) {
  const recipe::Recipe recipe;
  for (auto _ : state) {
    const toolpath::Glass glass = toolpath::glassOf({contour}, recipe.direction);
    const toolpath::Offset offset = toolpath::offsetOf(glass, recipe.wheelRadius);
    for (const toolpath::Loop& loop : offset.loops) {
      benchmark::DoNotOptimize(toolpath::makeWheelLoop(glass, offset, loop, recipe));
    }
  }
  state.SetComplexityN(state.range(0));
}

void lines(benchmark::State& state) {
  compensation(state, test::polygon(serrated(state.range(0))).contours.front());
}

void linesAndArcs(benchmark::State& state) {
  compensation(state, contourOfLinesAndArcs(state.range(0)));
}

void denseStar(benchmark::State& state) {
  compensation(state, test::polygon(star(state.range(0))).contours.front());
}

void clipper(benchmark::State& state) {
  ClipperLib::Path path;
  for (const geometry::Point& corner : serrated(state.range(0))) {
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
BENCHMARK(denseStar)->RangeMultiplier(10)->Range(1000, 10000)->Complexity()->Unit(benchmark::kMillisecond);
BENCHMARK(clipper)->RangeMultiplier(10)->Range(1000, 10000)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace arris
