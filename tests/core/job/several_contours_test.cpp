// Panes with cut-outs, several panes on one table, and what the wheel cannot do there.

#include "core/base/numbers.h"
#include "core/job/job.h"
#include "core/pattern/pieces.h"
#include "tests/support/contours.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace arris::job {
namespace {

using base::Code;
using base::kPi;
using geometry::Curve;
using geometry::Point;
using pattern::ContourKind;
using testing::ElementsAre;

std::vector<Curve> rectangle(double left, double low, double width, double height) {
  return test::closedLines({{left, low}, {left + width, low}, {left + width, low + height}, {left, low + height}});
}

Curve circle(double x, double y, double radius) {
  return geometry::arcAbout({x, y}, radius, 0, 2 * kPi);
}

pattern::Pattern patternOf(const std::vector<std::vector<Curve>>& contours) {
  std::vector<Curve> pieces;
  for (const std::vector<Curve>& contour : contours) {
    pieces.insert(pieces.end(), contour.begin(), contour.end());
  }
  return pattern::joinPieces(pattern::Pieces(std::move(pieces)), 0.05, 0.01);
}

/// Planned so that table and drawing have the same coordinates.
Job plannedWhereDrawn(const pattern::Pattern& pattern, recipe::Recipe recipe = {}) {
  geometry::Box box;
  for (const pattern::Contour& contour : pattern.contours) {
    box.extend(geometry::bounds(contour.curves));
  }
  recipe.place = box.min();
  return planJob(pattern, recipe, {});
}

std::vector<base::Problem> of(const Job& job, Code code) {
  std::vector<base::Problem> found;
  std::copy_if(job.problems.begin(), job.problems.end(), std::back_inserter(found),
               [code](const base::Problem& p) { return p.code == code; });
  return found;
}

TEST(SeveralContours, CutOutsComeBeforeTheirOutlineAndTheNearestNext) {
  // Park is at (0, 0): the left cut-out, then the right one, then the outline.
  const Job job =
      plannedWhereDrawn(patternOf({rectangle(300, 300, 1000, 700), {circle(1000, 600, 120)}, {circle(550, 600, 120)}}));
  ASSERT_TRUE(job.canBeGround());
  ASSERT_EQ(job.toolpath.chains.size(), 3U);
  EXPECT_EQ(job.contours[0].kind, ContourKind::CutOut);
  EXPECT_LT(geometry::bounds(job.contours[0].curves).center().x(), 600);
  EXPECT_EQ(job.contours[1].kind, ContourKind::CutOut);
  EXPECT_EQ(job.contours[2].kind, ContourKind::Outline);
}

TEST(SeveralContours, AreNumberedAsTheyAreMachinedEverywhere) {
  const Job job = plannedWhereDrawn(
      patternOf({rectangle(300, 300, 1000, 700), rectangle(450, 450, 300, 300), {circle(1000, 600, 120)}}));
  ASSERT_TRUE(job.canBeGround());
  int last = 0;
  for (Sampler sampler(job, 0.01); !sampler.done();) {
    const Sample row = sampler.next();
    if (row.contour != 0) {
      EXPECT_THAT(row.contour, testing::AnyOf(last, last + 1));
      last = row.contour;
    }
  }
  EXPECT_EQ(last, 3);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(job.contours[i].id, static_cast<int>(i) + 1);
    EXPECT_EQ(job.contours[i].parent, i < 2 ? 3 : 0);
  }
  for (const toolpath::Corner& corner : job.toolpath.corners) { // of the rectangles
    EXPECT_LT(
        geometry::nearest(job.contours[static_cast<std::size_t>(corner.contour - 1)].curves.front(), corner.s).distance,
        1100);
    EXPECT_EQ(corner.kind == toolpath::CornerKind::Concave,
              job.contours[static_cast<std::size_t>(corner.contour - 1)].kind == ContourKind::CutOut);
  }
}

TEST(SeveralContours, TheWheelIsUpBetweenThem) {
  const Job job = plannedWhereDrawn(patternOf({rectangle(300, 300, 1000, 700), {circle(800, 600, 120)}}));
  ASSERT_TRUE(job.canBeGround());
  std::vector<motion::Move> moves;
  for (const motion::Segment& segment : job.track) {
    const bool isRapid = segment.number == 0;
    if (isRapid && (moves.empty() || moves.back() != segment.move)) {
      moves.push_back(segment.move);
    }
  }
  using enum motion::Move;
  EXPECT_THAT(moves, ElementsAre(Approach, Plunge, Retract, Traverse, Plunge, Retract, Traverse));
  for (const motion::Segment& segment : job.track) {
    if (segment.move == Traverse || segment.move == Approach) {
      EXPECT_GE(motion::evaluate(segment, 0).point.z(), 77) << "lower than the clearance height";
    }
  }
}

// The cut-outs' corners are concave: the wheel comes to rest in each, and the changes of speed belong to it.
TEST(SeveralContours, TheWheelStopsInTheCornersOfARectangularCutOut) {
  const Job job = plannedWhereDrawn(patternOf({rectangle(300, 300, 1000, 700), rectangle(600, 450, 400, 300)}));
  ASSERT_TRUE(job.canBeGround());
  ASSERT_EQ(job.cornerResults.size(), 8U);
  for (int i = 0; i < 4; ++i) {
    const toolpath::Corner& corner = job.toolpath.corners[static_cast<std::size_t>(i)];
    const CornerResult& result = job.cornerResults[static_cast<std::size_t>(i)];
    EXPECT_EQ(corner.treatment, toolpath::Treatment::Stop);
    EXPECT_NEAR(corner.fillet, 75 * std::sqrt(2.0) - 75, 1e-9);
    EXPECT_NEAR(corner.unground, 75, 1e-9);
    EXPECT_EQ(result.plannedSpeed, 0);
    // From 60 mm/s, or as fast as the way allows, along one axis at 20 mm/s².
    EXPECT_GT(result.decelerationLength, 30);
    EXPECT_NEAR((result.decelerationPoint - corner.a).norm(), result.decelerationLength, 1e-6);
    EXPECT_NEAR((result.accelerationPoint - corner.c).norm(), result.accelerationLength, 1e-6);
  }
}

TEST(SeveralContours, PanesTooNearForTheWheelAreRefusedOnBothSidesOfTheGap) {
  const Job job = plannedWhereDrawn(patternOf({rectangle(200, 300, 400, 400), rectangle(700, 300, 400, 400)}));
  const std::vector<base::Problem> unreached = of(job, Code::Unreached);
  ASSERT_EQ(unreached.size(), 2U);
  std::set<double> sides;
  for (const base::Problem& problem : unreached) {
    EXPECT_NEAR(problem.largestWheel.value_or(0), 50, 1e-3); // half the gap
    // The wheel touches both tips at once, 50 mm beside the line between them: it leaves 400 mm of either side.
    EXPECT_NEAR(std::get<double>(problem.values[1].value), 400, 1e-6);
    sides.insert(std::round(problem.where->x()));
  }
  EXPECT_THAT(sides, ElementsAre(600, 700));
}

TEST(SeveralContours, AcceptedAsUnreachedThePanesAreGroundOnAWayRoundBoth) {
  recipe::Recipe recipe;
  recipe.acceptUnreached = true;
  const Job job = plannedWhereDrawn(patternOf({rectangle(200, 300, 400, 400), rectangle(700, 300, 400, 400)}), recipe);
  ASSERT_TRUE(job.canBeGround());
  EXPECT_EQ(job.toolpath.chains.size(), 1U);
  EXPECT_EQ(of(job, Code::UnreachedAccepted).size(), 2U);
  EXPECT_THAT(job.toolpath.unground, ElementsAre(testing::DoubleNear(400, 1e-6), testing::DoubleNear(400, 1e-6)));
}

TEST(SeveralContours, AHoleSmallerThanTheWheelIsRefusedWithTheLargestThatFits) {
  const pattern::Pattern pattern = patternOf({rectangle(300, 300, 1000, 700), {circle(800, 600, 40)}});
  const Job refused = plannedWhereDrawn(pattern);
  const std::vector<base::Problem> problems = of(refused, Code::ContourNotEntered);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NEAR(problems.front().largestWheel.value_or(0), 40, 1e-3);
  recipe::Recipe recipe;
  recipe.acceptUnreached = true;
  const Job accepted = plannedWhereDrawn(pattern, recipe);
  ASSERT_TRUE(accepted.canBeGround());
  EXPECT_EQ(of(accepted, Code::ContourLeftOut).size(), 1U);
  EXPECT_NEAR(accepted.toolpath.unground.back(), 2 * kPi * 40, 1e-9);
}

// A transition swings out by 130.4 − 75 mm at 36.87°; other glass that the roll just clears is in its way.
TEST(SeveralContours, ATransitionThatWouldTouchAnotherPaneBecomesARollWithAWarning) {
  const std::vector<Curve> wedge = test::closedLines({{300, 300}, {700, 500}, {300, 700}}); // tip at (700, 500)
  const pattern::Pattern pattern = patternOf({wedge, rectangle(700 + 160, 200, 100, 600)});
  const Job job = plannedWhereDrawn(pattern);
  ASSERT_TRUE(job.canBeGround());
  const std::vector<base::Problem> blocked = of(job, Code::TransitionBlocked);
  ASSERT_EQ(blocked.size(), 1U);
  EXPECT_NEAR(blocked.front().where->x(), 860, 1e-6);
  const toolpath::Corner& corner = job.toolpath.corners[static_cast<std::size_t>(*blocked.front().corner - 1)];
  EXPECT_EQ(corner.treatment, toolpath::Treatment::Roll);
  EXPECT_EQ(corner.reason, toolpath::Reason::TransitionBlocked);
  EXPECT_LT((corner.s - Point(700, 500)).norm(), 1e-9);
}

TEST(SeveralContours, AGivenStartCountsForTheContourNearestToIt) {
  const pattern::Pattern pattern = patternOf({rectangle(300, 300, 1000, 700), {circle(800, 600, 120)}});
  recipe::Recipe recipe;
  recipe.start = Point(300, 640); // the left side of the outline
  const Job job = plannedWhereDrawn(pattern, recipe);
  ASSERT_TRUE(job.canBeGround());
  const auto startOf = [&](std::size_t chain) {
    return geometry::startPoint(job.toolpath.chains[chain].segments.at(1).shape);
  };
  EXPECT_LT((startOf(0) - Point(800, 600 - 45)).norm(), 1e-9); // the circle's least Y, on the path of radius 45
  EXPECT_LT((startOf(1) - Point(225, 640)).norm(), 1e-9);
}

// The lead of 20 mm has no room at the middle of the longest line (45 mm wide there), but at the next longest.
TEST(SeveralContours, WhereTheLeadsHaveNoRoomTheNextBestStartIsTaken) {
  recipe::Recipe recipe;
  recipe.wheelRadius = 20;
  // A keyhole: a slot 42 mm wide and 400 long that opens into a square of 150.
  const std::vector<Curve> keyhole = test::closedLines(
      {{400, 400}, {550, 400}, {550, 454}, {950, 454}, {950, 496}, {550, 496}, {550, 550}, {400, 550}});
  const Job job = plannedWhereDrawn(patternOf({rectangle(200, 200, 1000, 600), keyhole}), recipe);
  EXPECT_THAT(of(job, Code::NoLead), testing::IsEmpty());
  ASSERT_TRUE(job.canBeGround());
  const Point start = geometry::startPoint(job.toolpath.chains.front().segments.at(1).shape);
  EXPECT_LT(start.x(), 550); // in the square
}

} // namespace
} // namespace arris::job
