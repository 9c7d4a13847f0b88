#include "core/program/progress.h"
#include "core/program/travel.h"
#include "tests/support/panes.h"

#include <gtest/gtest.h>

namespace arris::program {
namespace {

job::Job triangleOf600() {
  return job::planJob(test::triangle600(), recipe::Recipe{}, recipe::Machine{});
}

TEST(WorkingWay, CountsTheWayAlongTheGlassOnly) {
  const job::Job job = triangleOf600();
  const WorkingWay way(job);
  double along = 0;
  for (std::size_t i = 0; i < job.track.size(); ++i) {
    EXPECT_NEAR(way.before({static_cast<int>(i), 0}), along, 1e-9);
    const double length = motion::parameterLength(job.track[i]);
    const bool works = motion::isAlongContour(job.track[i].move);
    const double half = works ? motion::arcLength(job.track[i], length / 2) : 0;
    EXPECT_NEAR(way.before({static_cast<int>(i), length / 2}), along + half, 1e-9);
    along += works ? motion::arcLength(job.track[i], length) : 0;
  }
  EXPECT_NEAR(way.length(), along, 1e-9);
  EXPECT_GT(along, 3 * 600);
  EXPECT_LT(along, motion::arcLength(job.track) - 100); // leads, plunge and rapids are not counted
  EXPECT_EQ(way.before({}), 0);
  EXPECT_EQ(way.before({1'000'000, 3}), way.length());
}

TEST(Timetable, TellsWhatTheProfileTells) {
  const job::Job job = triangleOf600();
  const Timetable table(job, 1);
  EXPECT_DOUBLE_EQ(table.left({}), job.duration);
  EXPECT_DOUBLE_EQ(table.left({0, 0}), job.duration);
  for (job::Sampler sampler(job, 0.1); !sampler.done();) {
    const motion::SetPoint at = sampler.next().setPoint;
    EXPECT_NEAR(table.left({at.segment, at.lambda}), job.duration - at.time, 1e-6);
  }
  EXPECT_NEAR(table.left({static_cast<int>(job.track.size()), 0}), 0, 1e-12);
}

// The times on the contour are those of the method: by_hand_test.cpp.
TEST(Timetable, KnowsTheOverride) {
  const job::Job job = job::planJob(test::triangle600(), recipe::Recipe{}, recipe::Machine{}, toolpath::Leads::Without);
  const auto isWork = [](const motion::Segment& segment) { return segment.number > 0; };
  const auto first = std::find_if(job.track.begin(), job.track.end(), isWork) - job.track.begin();
  const auto end = job.track.rend() - std::find_if(job.track.rbegin(), job.track.rend(), isWork);
  for (const auto& [factor, seconds] : {std::pair{0.1, 723.257}, {0.5, 146.246}, {1.0, 75.614}, {1.5, 70.768}}) {
    const Timetable table(job, factor);
    const double work = table.left({static_cast<int>(first), 0}) - table.left({static_cast<int>(end), 0});
    EXPECT_NEAR(work, seconds, 0.002) << factor;
  }
}

TEST(Travel, IsLeftWhereTheOriginPutsTheWayOutsideByThatMuch) {
  const job::Job job = triangleOf600();
  EXPECT_FALSE(outsideTravel(job.track, job.machine, {0, 0, 0}));
  const auto problem = outsideTravel(job.track, job.machine, {0, 0, 2.5});
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->code, base::Code::OutsideTravel);
  EXPECT_NEAR(std::get<double>(problem->values.at(1).value), 2.5, 1e-9); // its top is the top of the travel
}

} // namespace
} // namespace arris::program
