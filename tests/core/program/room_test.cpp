#include "core/base/tolerances.h"
#include "core/program/manoeuvres.h"
#include "tests/support/panes.h"
#include "tests/support/programs.h"
#include "tests/support/swept_glass.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace arris::program {
namespace {

using motion::Move;

bool alongContour(const motion::Segment& segment) {
  return segment.move == Move::Contour || segment.move == Move::Transition || segment.move == Move::Roll;
}

TEST(RoomBesideTheWay, IsUnboundedRoundAConvexPaneButNoneOnLeadsAndOffTheContour) {
  const job::Job job = job::planJob(test::triangle600(15), {}, {});
  ASSERT_TRUE(job.canBeGround());
  const Room room(job);
  for (int i = 0; i < static_cast<int>(job.track.size()); ++i) {
    EXPECT_EQ(room.beside(i, 5), alongContour(job.track[static_cast<std::size_t>(i)]) ? 5 : 0) << "segment " << i;
  }
}

// A notch 160 mm wide leaves the wheel of 75 mm a lane of 10 mm.
TEST(RoomBesideTheWay, BetweenTwoWallsIsWhatIsLeftToTheOtherWall) {
  const job::Job job = job::planJob(
      test::polygon({{0, 0}, {800, 0}, {800, 600}, {480, 600}, {480, 300}, {320, 300}, {320, 600}, {0, 600}}), {}, {});
  ASSERT_TRUE(job.canBeGround());
  const Room room(job);
  const double middle = job.placement.patternOrigin.x() + 400;
  int walls = 0;
  for (int i = 0; i < static_cast<int>(job.track.size()); ++i) {
    const motion::Segment& segment = job.track[static_cast<std::size_t>(i)];
    const geometry::Curve curve = motion::curveOf(segment);
    const auto* line = std::get_if<geometry::Line>(&curve);
    const bool isWall = alongContour(segment) && line && std::abs(line->from.x() - middle) < 6 &&
                        std::abs(line->to.x() - middle) < 6 && std::abs(line->from.y() - line->to.y()) > 1;
    if (isWall) {
      ++walls;
      EXPECT_EQ(room.beside(i, 5), 5);
      EXPECT_NEAR(room.beside(i, 20), 10, 0.02);
      EXPECT_LE(room.beside(i, 20), 10 + base::kContourAccuracy);
    }
  }
  EXPECT_EQ(walls, 2);
}

// The tip of a tooth 160 mm from the opposite wall leaves 10 mm there, however much there is at both ends of the wall.
TEST(RoomBesideTheWay, IsWhatATipOppositeTheMiddleOfAWallLeaves) {
  const job::Job job = job::planJob(test::polygon({{0, 0},
                                                   {900, 0},
                                                   {900, 700},
                                                   {620, 700},
                                                   {620, 500},
                                                   {480, 450},
                                                   {620, 400},
                                                   {620, 200},
                                                   {320, 200},
                                                   {320, 700},
                                                   {0, 700}}),
                                    {}, {});
  ASSERT_TRUE(job.canBeGround());
  const geometry::Point beforeTip = job.placement.patternOrigin + geometry::Point(395, 450);
  const Room room(job);
  bool found = false;
  for (int i = 0; i < static_cast<int>(job.track.size()); ++i) {
    const motion::Segment& segment = job.track[static_cast<std::size_t>(i)];
    const geometry::Curve curve = motion::curveOf(segment);
    if (segment.move == Move::Contour && std::holds_alternative<geometry::Line>(curve) &&
        geometry::nearest(curve, beforeTip).distance < 1e-6) {
      found = true;
      EXPECT_NEAR(room.beside(i, 20), 10, 0.02);
      EXPECT_LE(room.beside(i, 20), 10 + base::kContourAccuracy);
    }
  }
  EXPECT_TRUE(found);
}

TEST(RoomBesideTheWay, KeepsTheWheelOffAllGlassAndInTheTravel) {
  for (const job::Job& job : test::jobsOfAllKinds(20)) {
    const Room room(job);
    const double least = job.recipe.wheelRadius - base::kContourAccuracy;
    for (int i = 0; i < static_cast<int>(job.track.size()); ++i) {
      const double beside = room.beside(i, 8);
      EXPECT_TRUE(room.has(i, beside));
      if (beside == 0) {
        continue;
      }
      for (const double lambda : test::placesAlong(job.track[static_cast<std::size_t>(i)])) {
        for (const double share : {0.2, 0.6, 1.0}) {
          const Eigen::Vector3d wheel = test::wheelAt(job, {i, lambda}, share * beside);
          ASSERT_GE(test::distanceFromGlass(job.contours, wheel.head<2>()), least);
          ASSERT_GE(wheel.minCoeff(), -1e-6);
          ASSERT_LE((wheel - job.machine.travel).maxCoeff(), 1e-6);
        }
      }
    }
  }
}

} // namespace
} // namespace arris::program
