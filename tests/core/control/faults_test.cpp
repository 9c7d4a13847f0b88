// Whatever goes wrong during a run: the axes come to rest as the category of the fault says, nothing restarts by
// itself, and the job can be resumed where it was.

#include "core/base/numbers.h"
#include "tests/support/bench.h"
#include "tests/support/mishaps.h"
#include "tests/support/panes.h"
#include "tests/support/random_panes.h"
#include "tests/support/run_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace arris::control {
namespace {

using test::Bench;
using test::RunWatch;

class FaultsOfARun : public testing::TestWithParam<int> {};

TEST_P(FaultsOfARun, EndAtRestAsTheirCategorySaysAndTheJobIsResumedWhereItWas) {
  const test::Mishap mishap = test::mishaps()[static_cast<std::size_t>(GetParam())];
  const FaultInfo& row = info(mishap.fault);
  std::mt19937 dice(static_cast<unsigned>(GetParam()));
  const job::Job job = job::planJob(test::triangle600(), recipe::Recipe{}, recipe::Machine{});
  for (int round = 0; round < 3; ++round) {
    SCOPED_TRACE(testing::Message() << row.name << " round " << round);
    Bench bench(job.machine);
    RunWatch watch(job, job.machine);
    bench.getReady(job);
    bench.onPeriod = [&](const Report& report, const Cycle& cycle) { watch.add(report, cycle); };
    ASSERT_TRUE(bench.supervisor.start());
    bench.runFor(job.duration * std::uniform_real_distribution<double>(0.05, 0.9)(dice));
    ASSERT_EQ(bench.report().state, State::Running);
    const bool wasLow = bench.report().commanded.z() < 60;

    mishap.begins(bench);
    const State end = mishap.fault == Fault::EmergencyStop ? State::EmergencyStop : State::Faulted;
    ASSERT_TRUE(bench.until(end, 30));
    EXPECT_TRUE(bench.report().faults.has(mishap.fault));
    EXPECT_EQ(bench.report().outputs.driveEnable[0], row.category == StopCategory::Two);
    EXPECT_EQ(bench.report().outputs.spindleSpeed, 0);
    if (wasLow && row.raises) {
      EXPECT_NEAR(bench.report().commanded.z(), 77, 1e-6); // clearance height
    }
    bench.runFor(0.2);
    mishap.isMended(bench);
    bench.runFor(0.2);
    const Report held = bench.report();
    bench.runFor(5); // nothing restarts by itself
    EXPECT_EQ(bench.report().state, end);
    EXPECT_LT((bench.report().measured - held.measured).norm(), 1e-12);
    ASSERT_TRUE(bench.supervisor.acknowledge());
    bench.runFor(5);
    const State after = row.category == StopCategory::Two ? State::Idle : State::Off;
    ASSERT_EQ(bench.report().state, after);
    bench.supervisor.serve();
    if (after == State::Off) {
      ASSERT_TRUE(bench.supervisor.enable());
      ASSERT_TRUE(bench.until([&] { return bench.report().drivesReady; }, 2));
    }
    if (row.losesPlace) {
      ASSERT_TRUE(bench.supervisor.home());
      ASSERT_TRUE(bench.until(State::Idle, 1000));
    }
    ASSERT_EQ(bench.report().state, State::Idle);
    EXPECT_EQ(bench.supervisor.jobState(), JobState::Aborted);
    ASSERT_TRUE(bench.supervisor.startFrom(bench.report().place));
    ASSERT_TRUE(bench.until([&] { return bench.supervisor.jobState() == JobState::Ended; }, 3 * job.duration));
    EXPECT_EQ(watch.broken(), "");
  }
}

INSTANTIATE_TEST_SUITE_P(Every, FaultsOfARun, testing::Range(0, static_cast<int>(test::mishaps().size())));

/// A pane of 20,000 chords, none of them fitted: more segments than the controller keeps.
job::Job longJob() {
  std::vector<geometry::Point> corners;
  constexpr int kChords = 20000;
  for (int i = 0; i < kChords; ++i) {
    const double angle = 2 * base::kPi * i / kChords;
    corners.emplace_back(400 * std::cos(angle), 400 * std::sin(angle));
  }
  return job::planJob(test::polygon(corners), recipe::Recipe{}, recipe::Machine{});
}

TEST(RotaryBuffers, ThatRunDryStopTheWheelOnItsPathBeforeTheEndOfWhatIsBuffered) {
  const job::Job job = longJob();
  ASSERT_TRUE(job.canBeGround());
  ASSERT_GT(job.track.size(), PathWindow::kSegments);
  Bench bench(job.machine);
  RunWatch watch(job, job.machine);
  bench.getReady(job);
  bench.onPeriod = [&](const Report& report, const Cycle& cycle) { watch.add(report, cycle); };
  ASSERT_TRUE(bench.supervisor.start());
  ASSERT_TRUE(bench.until([&] { return bench.report().place.segment > 100; }, 100));
  bench.operatorLives = false; // from here on nobody supplies the buffers
  for (int i = 0; i < 1'000'000 && bench.report().state != State::Faulted && bench.report().state != State::Idle; ++i) {
    if (i % 100 == 0) {
      bench.channels.commands.push(command::Heartbeat{});
    }
    bench.period();
  }
  ASSERT_EQ(bench.report().state, State::Faulted);
  EXPECT_TRUE(bench.report().faults.has(Fault::BufferDry));
  EXPECT_EQ(watch.broken(), "");
  EXPECT_GT(bench.report().place.segment, static_cast<int>(PathWindow::kSegments) - 2000);
}

TEST(RotaryBuffers, SupplyAProgramLongerThanTheyAreAndTheRunIsThePlan) {
  const job::Job job = longJob();
  Bench bench(job.machine);
  bench.getReady(job);
  bench.servedEvery = 50;
  job::Sampler plan(job);
  std::int64_t differs = 0;
  bench.onPeriod = [&](const Report& report, const Cycle&) {
    if (report.runTick >= 0 && !plan.done()) {
      const Eigen::Vector3d planned = plan.next().setPoint.position;
      const bool same = plan.done() ? (report.commanded - planned).norm() < 1e-9 : report.commanded == planned;
      differs = differs == 0 && !same ? report.runTick : differs;
    }
  };
  ASSERT_TRUE(bench.supervisor.start());
  ASSERT_TRUE(bench.until([&] { return bench.supervisor.jobState() == JobState::Ended; }, 2 * job.duration));
  EXPECT_EQ(differs, 0) << "periods from the start, of " << plan.count();
  EXPECT_TRUE(plan.done());
}

} // namespace
} // namespace arris::control
