// Reading and planning each drawing of the folder that ARRIS_PATTERN_CORPUS names, in a process of its own: the time of
// the processor and the most memory that the process had.

#include "tests/support/corpus.h"
#include "tests/support/limited_process.h"

#include <benchmark/benchmark.h>

namespace arris {
namespace {

void readAndPlan(benchmark::State& state, const std::filesystem::path& file, const test::CorpusVerdict& verdict) {
  constexpr unsigned kSeconds = 60;
  constexpr unsigned kMegabytes = 4096;
  double peak = 0;
  for (auto _ : state) {
    const test::Outcome outcome = test::inLimitedProcess(kSeconds, kMegabytes, [&] {
      const job::Job job = test::plannedAs(verdict, pattern::readDxf(test::contentOf(file), {}));
      return std::string(job.canBeGround() ? "planned" : "refused");
    });
    if (!outcome.ended) {
      state.SkipWithError(outcome.failure.c_str());
      break;
    }
    state.SetIterationTime(outcome.cpuSeconds);
    state.SetLabel(outcome.text);
    peak = std::max(peak, outcome.peakMegabytes);
  }
  state.counters["peak_MB"] = peak;
}

// One row for each drawing; none without a corpus.
[[maybe_unused]] const bool kRegistered = [] {
  const auto folder = test::corpusFolder();
  for (const std::filesystem::path& file : folder ? test::drawingsIn(*folder) : std::vector<std::filesystem::path>()) {
    const std::string name = file.filename().string();
    const test::CorpusVerdict verdict = test::verdictOn(name).value_or(test::CorpusVerdict{});
    benchmark::RegisterBenchmark(("corpus/" + name).c_str(),
                                 [file, verdict](benchmark::State& state) { readAndPlan(state, file, verdict); })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond)
        ->Iterations(3);
  }
  return true;
}();

} // namespace
} // namespace arris
