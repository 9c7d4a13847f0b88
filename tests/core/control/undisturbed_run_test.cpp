// A run that nobody disturbs is the plan.

#include "core/control/run_rows.h"
#include "core/control/simulated_axes.h"
#include "tests/support/bench.h"
#include "tests/support/panes.h"
#include "tests/support/random_panes.h"

#include <gtest/gtest.h>

namespace arris::control {
namespace {

using test::Bench;

void expectEqualToPlan(const job::Job& job, int servedEvery) {
  Bench bench(job.machine);
  bench.getReady(job);
  bench.servedEvery = servedEvery;
  job::Sampler plan(job);
  std::size_t rows = 0;
  bench.onPeriod = [&](const Report& report, const Cycle&) {
    if (report.runTick < 0) {
      return;
    }
    ASSERT_EQ(report.runTick, static_cast<std::int64_t>(rows));
    ++rows;
    const job::Sample row = plan.next();
    ASSERT_EQ(report.commanded, row.setPoint.position) << "row " << rows; // to the last bit
    if (plan.done()) { // the plan's last row is the very end, the run's the first period at or after it
      EXPECT_EQ(report.velocity, Eigen::Vector3d::Zero());
    } else {
      ASSERT_EQ(report.velocity, row.setPoint.velocity) << "row " << rows;
      ASSERT_EQ(report.axisAcceleration, row.setPoint.axisAcceleration) << "row " << rows;
    }
  };
  ASSERT_TRUE(bench.supervisor.start());
  ASSERT_TRUE(bench.until([&] { return bench.supervisor.jobState() == JobState::Ended; }, 2 * job.duration + 10));
  EXPECT_EQ(rows, plan.count());
  EXPECT_TRUE(plan.done());
  EXPECT_TRUE(bench.faults.empty());
  EXPECT_EQ(bench.supervisor.panesDone(), 1);
}

TEST(UndisturbedRun, OfTheTriangleIsThePlanToTheLastBit) {
  expectEqualToPlan(job::planJob(test::triangle600(), recipe::Recipe{}, recipe::Machine{}), 10);
}

class UndisturbedRuns : public testing::TestWithParam<int> {};

TEST_P(UndisturbedRuns, OfRandomPanesAreThePlanToTheLastBit) {
  std::uint64_t seed = 5000 + 7 * static_cast<std::uint64_t>(GetParam());
  const job::Job job = test::randomJob(seed);
  SCOPED_TRACE(seed - 1);
  expectEqualToPlan(job, 1 + GetParam() % 30);
}

INSTANTIATE_TEST_SUITE_P(Seeds, UndisturbedRuns, testing::Range(0, 12));

/// The rows of a run on simulated axes beside those of the plan.
void expectRowsOfPlan(const job::Job& job) {
  auto axes = std::make_unique<SimulatedAxes>(job.machine, Pace::Simulated, Eigen::Vector3d(40, 50, 100),
                                              Eigen::Vector3d(0, 0, 0));
  Bench bench(job.machine, std::move(axes));
  bench.getReady(job);
  job::Sampler plan(job);
  std::size_t count = 0;
  RunRows rows(bench.supervisor.job(), [&](const files::RunRow& run) {
    ++count;
    const job::Sample row = plan.next();
    if (plan.done()) {
      return;
    }
    SCOPED_TRACE(testing::Message() << "row " << count);
    ASSERT_EQ(run.row.time, row.setPoint.time);
    ASSERT_EQ(run.row.phase, job::name(row.phase));
    ASSERT_EQ(run.row.corner, row.corner);
    ASSERT_EQ(run.row.contour, row.contour);
    ASSERT_EQ(run.row.segment, row.segment);
    ASSERT_EQ(run.row.path, row.path);
    ASSERT_NEAR(run.row.distance, row.distance, 1e-12);
    ASSERT_LT((run.row.position - row.setPoint.position).norm(), 0.05);
    ASSERT_LT((run.measuredVelocity - row.setPoint.velocity).norm(), 5);
  });
  bench.onPeriod = [&](const Report& report, const Cycle&) { rows.add(report); };
  ASSERT_TRUE(bench.supervisor.start());
  ASSERT_TRUE(bench.until(State::Running, 20));
  ASSERT_TRUE(bench.until([&] { return bench.supervisor.jobState() == JobState::Ended; }, 2 * job.duration + 10));
  rows.finish();
  EXPECT_EQ(count, plan.count());
}

TEST(RunRows, OfAnUndisturbedRunAreThoseOfThePlan) {
  expectRowsOfPlan(job::planJob(test::triangle600(), recipe::Recipe{}, recipe::Machine{}));
  for (std::uint64_t seed = 300; seed < 330;) {
    SCOPED_TRACE(seed);
    const job::Job job = test::randomJob(seed);
    expectRowsOfPlan(job);
    if (testing::Test::HasFailure()) {
      return;
    }
  }
}

} // namespace
} // namespace arris::control
