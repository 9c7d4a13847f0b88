// A run that nobody disturbs is the plan.

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

} // namespace
} // namespace arris::control
