// The controller: one period of it alone, and whole runs on simulated axes against the time they take.

#include "core/control/simulated_axes.h"
#include "tests/support/bench.h"
#include "tests/support/panes.h"
#include "tests/support/random_panes.h"

#include <benchmark/benchmark.h>

#include <array>
#include <chrono>

namespace arris {
namespace {

using control::JobState;
using test::Bench;

job::Job triangleToRun() {
  return job::planJob(test::triangle600(), {}, {});
}

job::Job roundedToRun() {
  std::uint64_t seed = 1;
  return test::randomJob(seed);
}

std::unique_ptr<Bench> readyOnSimulatedAxes(const job::Job& job) {
  auto axes = std::make_unique<control::SimulatedAxes>(job.machine, control::Pace::Simulated,
                                                       Eigen::Vector3d(20, 30, 110), Eigen::Vector3d(0, 0, 0));
  auto bench = std::make_unique<Bench>(job.machine, std::move(axes));
  bench->getReady(job);
  return bench;
}

/// Controller alone, in a run: the feedback is the set-points of some periods ago, the reports are thrown away.
void controlPeriod(benchmark::State& state, const job::Job& job) {
  const auto bench = readyOnSimulatedAxes(job);
  control::Feedback feedback;
  const auto start = [&] {
    bench->supervisor.start();
    bench->until(control::State::Running, 20);
    bench->runFor(0.1);
    feedback = bench->axes->read();
  };
  start();
  control::Report report;
  std::int64_t count = 0;
  std::array<Eigen::Vector3d, 64> given;
  given.fill(feedback.position);
  for (auto _ : state) {
    given[static_cast<std::size_t>(bench->report().tick + 1) % given.size()] =
        bench->controller.advance(feedback).setPoint;
    ++feedback.tick;
    feedback.position = given[static_cast<std::size_t>(feedback.tick) % given.size()];
    if (++count % 256 == 0 || bench->report().state != control::State::Running) {
      state.PauseTiming();
      if (bench->report().state != control::State::Running) {
        state.SkipWithError("the run ended");
        break;
      }
      bench->channels.commands.push(control::command::Heartbeat{});
      while (bench->channels.reports.pop(report)) {
      }
      state.ResumeTiming();
    }
  }
}

/// A whole run in simulated time: operator's side, controller and simulated axes.
void controlledRun(benchmark::State& state, const job::Job& job) {
  const auto bench = readyOnSimulatedAxes(job);
  double simulated = 0;
  double took = 0;
  for (auto _ : state) {
    const std::int64_t before = bench->report().tick;
    const auto begin = std::chrono::steady_clock::now();
    bench->supervisor.start();
    bench->until(control::State::Running, 20);
    bench->until([&] { return bench->supervisor.jobState() == JobState::Ended; }, 1e5);
    took += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    simulated += static_cast<double>(bench->report().tick - before) * job.machine.period;
    bench->runFor(0.1);
    bench->supervisor.serve();
  }
  state.counters["times_real_time"] = simulated / took;
}

BENCHMARK_CAPTURE(controlPeriod, triangle, triangleToRun())->Iterations(60000);
BENCHMARK_CAPTURE(controlPeriod, rounded_pane, roundedToRun())->Iterations(20000);
BENCHMARK_CAPTURE(controlledRun, triangle, triangleToRun())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(controlledRun, rounded_pane, roundedToRun())->Unit(benchmark::kMillisecond);

} // namespace
} // namespace arris
