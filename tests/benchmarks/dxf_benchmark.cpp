#include "core/base/numbers.h"
#include "core/pattern/pattern.h"
#include "tests/support/dxf_text.h"

#include <benchmark/benchmark.h>
#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>

#include <algorithm>
#include <random>
#include <sstream>

namespace arris {
namespace {

using geometry::Curve;
using geometry::Line;
using geometry::Point;

/// A closed wavy contour of radius 1 m in `count` chords, drawn in any order and direction as LINEs.
std::string chordsAsDxf(int count) {
  std::mt19937 random(7);
  const auto corner = [count](int i) {
    const double angle = 2 * base::kPi * (i % count) / count;
    const double radius = 1000 + 20 * std::cos(5 * angle);
    return Point(radius * std::cos(angle), radius * std::sin(angle));
  };
  std::vector<Curve> lines;
  for (int i = 0; i < count; ++i) {
    const bool backwards = random() % 2 == 0;
    lines.emplace_back(Line{corner(backwards ? i + 1 : i), corner(backwards ? i : i + 1)});
  }
  std::shuffle(lines.begin(), lines.end(), random);
  return test::DxfText().insUnits(4).add(lines).text();
}

const std::string& textOf(int count) {
  static std::map<int, std::string> texts;
  std::string& text = texts[count];
  if (text.empty()) {
    text = chordsAsDxf(count);
  }
  return text;
}

void finish(benchmark::State& state, const std::string& text) {
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
  state.counters["entities"] = static_cast<double>(state.range(0));
}

/// The yardstick: dxflib reading the same text and doing nothing with it.
void dxflibAlone(benchmark::State& state) {
  const std::string& text = textOf(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    std::istringstream stream(text);
    DL_CreationAdapter nothing;
    benchmark::DoNotOptimize(DL_Dxf().in(stream, &nothing));
  }
  finish(state, text);
}

BENCHMARK(dxflibAlone)->Arg(200000)->Unit(benchmark::kMillisecond);

void dxfToJoinedPattern(benchmark::State& state) {
  const std::string& text = textOf(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    const pattern::Pattern pattern = pattern::readDxf(text, {});
    if (pattern.contours.size() != 1 || base::hasErrors(pattern.problems)) {
      state.SkipWithError("the contour was not read");
    }
  }
  finish(state, text);
}

BENCHMARK(dxfToJoinedPattern)->RangeMultiplier(10)->Range(2000, 200000)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace arris
