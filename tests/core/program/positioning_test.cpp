#include "core/job/program_track.h"
#include "core/program/manoeuvres.h"
#include "tests/support/panes.h"
#include "tests/support/programs.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace arris::program {
namespace {

using Eigen::Vector3d;

void expectOffTheJobsWay(const Program& program) {
  EXPECT_EQ(program.kind, Kind::Positioning);
  for (const JobStretch& stretch : program.places) {
    EXPECT_EQ(placeOn(stretch, 1), JobPlace{});
  }
}

TEST(AnOutlineTrace, GoesOnceAlongTheWheelPathAtClearanceHeightAndEndsAboveItsEnd) {
  for (const job::Job& job : test::jobsOfAllKinds(8)) {
    const job::Heights heights = job::heightsOf(job.recipe, job.machine);
    const Vector3d at(100, 50, heights.clearance);
    const Program program = traceProgram(job, at);
    ASSERT_TRUE(test::isOneMotion(program, at));
    expectOffTheJobsWay(program);
    std::vector<const motion::Segment*> expected;
    for (const motion::Segment& segment : job.track) {
      if (segment.contour > 0) {
        expected.push_back(&segment);
      }
    }
    std::size_t next = 0;
    for (const motion::Segment& segment : program.track) {
      const double length = motion::parameterLength(segment);
      EXPECT_GE(motion::evaluate(segment, length).point.z(), heights.clearance);
      if (segment.contour == 0) {
        EXPECT_TRUE(segment.move == motion::Move::Approach || segment.move == motion::Move::Traverse);
        continue;
      }
      ASSERT_LT(next, expected.size());
      for (const double lambda : {0.0, length / 3, length}) {
        const Vector3d ground = motion::evaluate(*expected[next], lambda).point;
        EXPECT_LT(
            (motion::evaluate(segment, lambda).point - Vector3d(ground.x(), ground.y(), heights.clearance)).norm(),
            1e-9);
      }
      EXPECT_EQ(segment.speedCap, expected[next]->speedCap);
      ++next;
    }
    EXPECT_EQ(next, expected.size());
    const motion::Segment& last = program.track.back();
    EXPECT_EQ(motion::evaluate(last, motion::parameterLength(last)).point.z(), heights.top);
  }
}

TEST(AnOutlineTrace, KeepsTheLimitsOfTheAxes) {
  for (const job::Job& job : test::jobsOfAllKinds(4)) {
    EXPECT_TRUE(test::keepsTheLimits(traceProgram(job, {100, 50, 60})));
  }
}

TEST(TheWayToPark, GoesUpAcrossAndToThePark) {
  recipe::Machine machine;
  machine.park = {20, 30, 100};
  const Vector3d at(400, 500, 46);
  const Program program = parkProgram({}, machine, at);
  ASSERT_TRUE(test::isOneMotion(program, at));
  expectOffTheJobsWay(program);
  ASSERT_EQ(program.track.size(), 3U);
  EXPECT_EQ(motion::evaluate(program.track[1], 0).point, Vector3d(400, 500, 120));
  const double length = motion::parameterLength(program.track[2]);
  EXPECT_EQ(motion::evaluate(program.track[2], 0).point, Vector3d(20, 30, 120));
  EXPECT_LT((motion::evaluate(program.track[2], length).point - machine.park).norm(), 1e-12);
  EXPECT_TRUE(test::keepsTheLimits(program));
}

TEST(TheWayToPark, IsEmptyAtThePark) {
  const recipe::Machine machine;
  EXPECT_TRUE(parkProgram({}, machine, machine.park).track.empty());
}

} // namespace
} // namespace arris::program
