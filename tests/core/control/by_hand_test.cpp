// Figures recomputed by hand from the method: overrides and holds.

#include "core/base/numbers.h"
#include "tests/support/bench.h"
#include "tests/support/panes.h"
#include "tests/support/run_watch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace arris::control {
namespace {

using test::Bench;

job::Job trianglePlan(toolpath::Leads leads) {
  return job::planJob(test::triangle600(), recipe::Recipe{}, recipe::Machine{}, leads);
}

/// Time on the contour from rest to rest, s, to within a period.
double timeOnContour(double override) {
  const job::Job job = trianglePlan(toolpath::Leads::Without);
  Bench bench(job.machine);
  bench.getReady(job);
  bench.supervisor.setOverride(override);
  std::int64_t periods = 0;
  bench.onPeriod = [&](const Report& report, const Cycle&) {
    if (report.isInMotion && report.place.segment >= 0 &&
        job.track[static_cast<std::size_t>(report.place.segment)].number > 0) {
      ++periods;
    }
  };
  EXPECT_TRUE(bench.supervisor.start());
  EXPECT_TRUE(bench.until([&] { return bench.supervisor.jobState() == JobState::Ended; }, 5000));
  return static_cast<double>(periods) * job.machine.period;
}

TEST(Override, TheTriangleTakesTheTimesOfTheMethodAtEveryOverride) {
  EXPECT_NEAR(timeOnContour(1), 75.614, 0.002);
  EXPECT_NEAR(timeOnContour(1.5), 70.768, 0.002);
  EXPECT_NEAR(timeOnContour(0.5), 146.246, 0.002);
  EXPECT_NEAR(timeOnContour(0.1), 723.257, 0.002);
}

// At 130° with the bisector along X v_trans is clamped to 40.683 mm/s, so that X is saturated on the blend: a hold at A
// cannot brake before the middle of it.
TEST(Hold, AtTheBeginningOfABlendWithSaturatedAxisBrakesWhenTheAxesAdmitIt) {
  const job::Job job = job::planJob(test::isosceles(130, 700), recipe::Recipe{}, recipe::Machine{});
  ASSERT_TRUE(job.canBeGround());
  const auto corner = std::find_if(job.toolpath.corners.begin(), job.toolpath.corners.end(),
                                   [](const auto& c) { return std::abs(base::degrees(c.angle) - 130) < 1e-6; });
  ASSERT_NE(corner, job.toolpath.corners.end());
  ASSERT_NEAR(corner->transitionSpeed, 40.683, 0.0005);
  Bench bench(job.machine);
  test::RunWatch watch(job, job.machine);
  bench.getReady(job);
  double since = -1;
  double brakes = -1;
  bench.onPeriod = [&](const Report& report, const Cycle& cycle) {
    watch.add(report, cycle);
    if (since >= 0) {
      since += job.machine.period;
      brakes = brakes < 0 && report.acceleration < -1e-3 ? since : brakes;
    }
  };
  ASSERT_TRUE(bench.supervisor.start());
  ASSERT_TRUE(bench.until(
      [&] {
        const int segment = bench.report().place.segment;
        return segment >= 0 && job.track[static_cast<std::size_t>(segment)].corner == corner->id;
      },
      1000));
  ASSERT_TRUE(bench.supervisor.hold());
  since = 0;
  ASSERT_TRUE(bench.until(State::Held, 10));
  EXPECT_NEAR(brakes, 0.860, 0.003);
  EXPECT_EQ(watch.broken(), "");
  EXPECT_EQ(bench.report().velocity, Eigen::Vector3d::Zero());
  EXPECT_TRUE(bench.faults.empty());
}

} // namespace
} // namespace arris::control
