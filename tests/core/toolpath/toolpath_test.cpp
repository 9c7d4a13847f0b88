#include "core/base/numbers.h"
#include "core/toolpath/chain.h"
#include "core/toolpath/toolpath.h"
#include "tests/support/panes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

namespace arris::toolpath {
namespace {

using base::Code;
using base::kPi;
using geometry::Arc;
using geometry::Curve;
using geometry::Line;
using geometry::Point;
using recipe::Direction;
using recipe::Recipe;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;

const std::vector<Point> kRectangle{{0, 0}, {400, 0}, {400, 300}, {0, 300}};

Toolpath toolpathOf(const pattern::Pattern& pane, const Recipe& recipe = {}) {
  return makeToolpath(pane.contours, recipe);
}

std::vector<Role> rolesOf(const Toolpath& toolpath) {
  std::vector<Role> roles;
  for (const PathSegment& piece : toolpath.chains.front().segments) {
    roles.push_back(piece.role);
  }
  return roles;
}

/// Where the lead-in meets the wheel path.
Point startOf(const Toolpath& toolpath) {
  return geometry::startPoint(toolpath.chains.front().segments.at(1).shape);
}

/// The one problem of this code.
base::Problem onlyOf(const Toolpath& toolpath, Code code) {
  base::Problems found;
  std::copy_if(toolpath.problems.begin(), toolpath.problems.end(), std::back_inserter(found),
               [code](const base::Problem& problem) { return problem.code == code; });
  EXPECT_EQ(found.size(), 1U);
  return found.empty() ? base::Problem() : found.front();
}

void expectAt(const Point& actual, const Point& expected, double within = 1e-9) {
  EXPECT_LT((actual - expected).norm(), within) << actual.transpose() << " instead of " << expected.transpose();
}

pattern::Pattern discOf(double radius) {
  return test::paneOf({Arc{{radius, 0}, {0, 1}, 1 / radius, 2 * kPi * radius}});
}

/// A rectangle 400 × 300 whose upper edge is hollowed out by an arc of this radius.
pattern::Pattern hollow(double radius) {
  return test::paneOf({Line{{0, 0}, {400, 0}}, Line{{400, 0}, {400, 300}},
                       geometry::arcBetween({400, 300}, {0, 300}, -2 * std::asin(200 / radius)),
                       Line{{0, 300}, {0, 0}}});
}

TEST(Toolpath, GoesRoundARectangleInTheOrderOfMachining) {
  using enum Role;
  EXPECT_THAT(rolesOf(toolpathOf(test::polygon(kRectangle))),
              ElementsAre(LeadIn, Contour, Transition, Contour, Transition, Contour, Transition, Contour, Transition,
                          Contour, LeadOut));
}

TEST(Toolpath, StartsInTheMiddleOfTheLongestLineThatIsLowest) {
  expectAt(startOf(toolpathOf(test::polygon(kRectangle))), {200, -75});
}

TEST(Toolpath, StartsTheSameWhateverTheOrderOfTheEdges) {
  for (std::size_t first = 0; first < kRectangle.size(); ++first) {
    std::vector<Point> rotated = kRectangle;
    std::rotate(rotated.begin(), rotated.begin() + static_cast<std::ptrdiff_t>(first), rotated.end());
    expectAt(startOf(toolpathOf(test::polygon(rotated))), {200, -75});
  }
}

TEST(Toolpath, PrefersALineToALongerArc) {
  const std::vector<Curve> curves{Line{{0, 0}, {100, 0}}, geometry::arcBetween({100, 0}, {0, 0}, 1.5 * kPi)};
  expectAt(startOf(toolpathOf(test::paneOf(curves))), {50, -75});
}

TEST(Toolpath, StartsAFullCircleAtItsLeastY) {
  expectAt(startOf(toolpathOf(discOf(200))), {0, -275});
}

TEST(Toolpath, StartsAtTheContourPointNearestToTheOneGiven) {
  Recipe recipe;
  recipe.start = Point(-50, 120);
  expectAt(startOf(toolpathOf(test::polygon(kRectangle), recipe)), {-75, 120});
}

TEST(Toolpath, StartsAfterTheCornerWhereTheCornerIsNearest) {
  Recipe recipe;
  recipe.start = Point(500, 400);
  const Toolpath toolpath = makeToolpath(test::polygon(kRectangle).contours, recipe, Leads::Without);
  expectAt(geometry::startPoint(toolpath.chains.front().segments.front().shape), {475, 300}); // clockwise: down
}

TEST(Toolpath, KeepsTheGlassOnTheRightClockwiseAndOnTheLeftCounterClockwise) {
  for (const auto& [direction, side] : {std::pair{Direction::Clockwise, -1.0}, {Direction::CounterClockwise, 1.0}}) {
    Recipe recipe;
    recipe.direction = direction;
    const Toolpath toolpath = toolpathOf(test::polygon(kRectangle), recipe);
    const geometry::Vector travel = geometry::startTangent(toolpath.chains.front().segments[1].shape);
    const geometry::Vector toGlass = Point(200, 0) - startOf(toolpath);
    EXPECT_GT(side * geometry::cross(travel, toGlass), 0);
  }
}

TEST(Toolpath, NumbersTheCornersAsTheyAreMet) {
  const Toolpath toolpath = toolpathOf(test::polygon(kRectangle)); // clockwise from the lower side
  expectAt(toolpath.corners[0].s, {0, 0});
  expectAt(toolpath.corners[1].s, {0, 300});
  expectAt(toolpath.corners[2].s, {400, 300});
  expectAt(toolpath.corners[3].s, {400, 0});
}

TEST(Corners, AreRolledFromOneHundredTwentyDegreesOnWithoutRelief) {
  std::vector<Point> octagon;
  for (int i = 0; i < 8; ++i) {
    octagon.emplace_back(400 * std::cos(i * kPi / 4), 400 * std::sin(i * kPi / 4)); // 135°
  }
  Recipe shallow;
  EXPECT_EQ(toolpathOf(test::polygon(octagon), shallow).corners.front().treatment, Treatment::Transition);
  Recipe deep;
  deep.depth = 0.5; // (1 − sin 67.5°)² = 0.0058 < 2·0.5/75
  const Toolpath rolled = toolpathOf(test::polygon(octagon), deep);
  ASSERT_EQ(rolled.corners.size(), 8U);
  EXPECT_EQ(rolled.corners.front().kind, CornerKind::Blunt);
  EXPECT_EQ(rolled.corners.front().treatment, Treatment::Roll);
  EXPECT_EQ(rolled.corners.front().reason, Reason::BluntWithoutRelief);
  EXPECT_THAT(rolled.problems, IsEmpty());
}

TEST(Corners, BelowOneHundredTwentyDegreesWithoutReliefKeepTheirTransitionWithAWarning) {
  Recipe deep;
  deep.depth = 5;
  deep.wheelRadius = 50; // (1 − sin 45°)² = 0.086 < 0.2
  const Toolpath toolpath = toolpathOf(test::polygon(kRectangle), deep);
  EXPECT_EQ(toolpath.corners.front().treatment, Treatment::Transition);
  EXPECT_EQ(toolpath.corners.front().reason, Reason::SharpWithoutRelief);
  ASSERT_EQ(toolpath.problems.size(), 4U);
  EXPECT_THAT(toolpath.problems, testing::Each(Field(&base::Problem::code, Code::NoRelief)));
  // Lift R/2 (s + 1/s) − R at 90°: 25·(0.70711 + 1.41421) − 50.
  EXPECT_NEAR(std::get<double>(toolpath.problems.front().values[0].value), 3.03301, 5e-6);
}

TEST(Corners, WarnOfATransitionThatTakesMoreThanAMinute) {
  Recipe slow;
  slow.feed = 700; // 60°: 12.99 s at 3600 mm/min, 66.8 s at 700
  EXPECT_THAT(toolpathOf(test::triangle600(), slow).problems, Contains(Field(&base::Problem::code, Code::SlowCorner)));
  slow.feed = 800; // 58.5 s
  EXPECT_THAT(toolpathOf(test::triangle600(), slow).problems, IsEmpty());
}

TEST(Corners, SayWhatLimitsTheirSpeed) {
  Recipe recipe;
  const auto limitedBy = [&] { return toolpathOf(test::polygon(kRectangle), recipe).corners.front().limitedBy; };
  EXPECT_EQ(limitedBy(), LimitedBy::Angle);
  recipe.cornerSpeed = 50;
  EXPECT_EQ(limitedBy(), LimitedBy::CornerSpeed);
  // At a right angle |q''_x| = 1/(2R), and so v_trans ≤ √(2 R a_x): below 15 mm/s for a_x < 1.5.
  recipe.accelX = 1;
  EXPECT_EQ(limitedBy(), LimitedBy::AxisX);
  recipe.accelY = 0.5;
  EXPECT_EQ(limitedBy(), LimitedBy::AxisY);
  EXPECT_NEAR(toolpathOf(test::polygon(kRectangle), recipe).corners.front().transitionSpeed, std::sqrt(75.0), 1e-9);
  recipe.accelerationRule = recipe::AccelerationRule::Combined;
  EXPECT_EQ(limitedBy(), LimitedBy::CornerSpeed);
}

TEST(Toolpath, RefusesAHollowThatIsTighterThanTheWheelAndNamesTheWheelThatFits) {
  Recipe recipe;
  recipe.wheelRadius = 250.5;
  const Toolpath toolpath = toolpathOf(hollow(250), recipe);
  const base::Problem problem = onlyOf(toolpath, Code::Unreached);
  EXPECT_NEAR(problem.largestWheel.value_or(0), 250, 1e-6);
  // Between the tips the wheel sags by r − √(r² − 200²).
  const double left = (250 - std::sqrt(250.0 * 250 - 40000)) - (250.5 - std::sqrt(250.5 * 250.5 - 40000));
  EXPECT_NEAR(std::get<double>(problem.values[2].value), left, 1e-6);
  expectAt(*problem.where, {200, 200}, 1e-6);
}

TEST(Toolpath, GoesThroughAHollowThatIsWideEnough) {
  EXPECT_THAT(toolpathOf(hollow(250)).problems, IsEmpty());
}

TEST(Toolpath, RefusesAWheelThatWouldTouchTheGlassAcrossAGap) {
  // A ring cut open by a gap of 120 mm: the inner arc of radius 200 has room for the wheel, the gap has not.
  const double half = std::asin(60.0 / 200);
  const double outer = std::asin(60.0 / 400);
  const std::vector<Curve> curves{geometry::arcAbout({0, 0}, 400, kPi / 2 + outer, 2 * (kPi - outer)),
                                  Line{geometry::pointAt(geometry::arcAbout({0, 0}, 400, kPi / 2 - outer, 0.1), 0),
                                       Point(60, 200 * std::cos(half))},
                                  geometry::arcAbout({0, 0}, 200, kPi / 2 - half, -2 * (kPi - half)),
                                  Line{Point(-60, 200 * std::cos(half)), Point(-60, 400 * std::cos(outer))}};
  const Toolpath toolpath = toolpathOf(test::paneOf(curves));
  EXPECT_EQ(toolpath.chains.size(), 2U); // round the ring, and inside it from above
  int sides = 0;
  for (const base::Problem& problem : toolpath.problems) {
    if (problem.code == Code::Unreached) {
      EXPECT_NEAR(problem.largestWheel.value_or(0), 60, 1e-3);
      ++sides;
    }
  }
  EXPECT_EQ(sides, 2); // of the gap
}

TEST(Toolpath, RefusesASpike) {
  const Toolpath toolpath = toolpathOf(test::polygon({{0, 0}, {400, 0}, {400, 0.1}}));
  EXPECT_THAT(toolpath.problems, Contains(Field(&base::Problem::code, Code::SpikeInContour)));
}

TEST(Leads, AreQuarterArcsTangentialToThePathAndAwayFromTheGlass) {
  for (const Direction direction : {Direction::Clockwise, Direction::CounterClockwise}) {
    Recipe recipe;
    recipe.direction = direction;
    const std::vector<PathSegment> segments = toolpathOf(test::polygon(kRectangle), recipe).chains.front().segments;
    const double sign = direction == Direction::Clockwise ? -1 : 1;
    expectAt(geometry::startPoint(segments.front().shape), {200 - sign * 20, -95});
    expectAt(geometry::endPoint(segments.front().shape), {200, -75});
    expectAt(geometry::endPoint(segments.back().shape), {200 + sign * 30, -95});
    EXPECT_NEAR(geometry::parameterLength(segments.front().shape), 10 * kPi, 1e-9);
  }
}

TEST(Leads, AreHalfTheRadiusOfAHollowThatIsTooTight) {
  Recipe recipe;
  recipe.start = Point(200, 250);
  recipe.lead = 100; // the path's radius is 250 − 75 = 175 < 200
  const Toolpath toolpath = toolpathOf(hollow(250), recipe);
  EXPECT_THAT(toolpath.problems, IsEmpty());
  EXPECT_NEAR(std::get<Arc>(toolpath.chains.front().segments.front().shape).radius(), 87.5, 1e-9);
}

TEST(Leads, AreRefusedWhereTheWheelGoesDownOnTheBlank) {
  Recipe recipe;
  recipe.lead = 1; // less than the depth and 1 mm
  EXPECT_THAT(toolpathOf(test::polygon(kRectangle), recipe).problems,
              Contains(Field(&base::Problem::code, Code::NoLead)));
}

TEST(Leads, AreRefusedWhereTheyTouchAnotherEdge) {
  Recipe recipe;
  recipe.start = Point(1, 0); // √(75² + 1²) is less than 75.13 from the corner
  EXPECT_THAT(toolpathOf(test::polygon(kRectangle), recipe).problems,
              Contains(Field(&base::Problem::code, Code::NoLead)));
  recipe.start = Point(40, 0); // lead-in √(75² + 40²)
  EXPECT_THAT(toolpathOf(test::polygon(kRectangle), recipe).problems, IsEmpty());
}

TEST(Leads, FitOnAPolygonWithShortEdgesAndBluntCorners) {
  std::vector<Point> corners; // a circle drawn with 32 chords of 3.9 mm: √(75² + 2²) is less than 75.13
  for (int i = 0; i < 32; ++i) {
    corners.emplace_back(20 * std::cos(i * kPi / 16), 20 * std::sin(i * kPi / 16));
  }
  EXPECT_THAT(toolpathOf(test::polygon(corners)).problems, IsEmpty());
}

TEST(Overlap, IsMeasuredAlongTheContour) {
  Recipe recipe;
  recipe.overlap = 250; // clockwise from (200, 0): 200 to the corner, 50 up the next side
  const std::vector<PathSegment> segments = toolpathOf(test::polygon(kRectangle), recipe).chains.front().segments;
  expectAt(geometry::startPoint(segments.back().shape), {-75, 50});
  EXPECT_EQ(segments[segments.size() - 3].corner, 1); // the same corner again
}

TEST(Overlap, IsAtMostAQuarterOfTheContour) {
  Recipe recipe;
  recipe.overlap = 400;
  const Toolpath toolpath = toolpathOf(test::polygon(kRectangle), recipe);
  expectAt(geometry::startPoint(toolpath.chains.front().segments.back().shape), {-75, 150}); // 350 along
  ASSERT_EQ(toolpath.problems.size(), 1U);
  EXPECT_EQ(toolpath.problems.front().code, Code::OverlapShortened);
}

TEST(Overlap, OnAnArcIsMeasuredOnTheGlassNotOnTheWheelPath) {
  Recipe recipe;
  recipe.overlap = 100;
  const std::vector<PathSegment> segments = toolpathOf(discOf(200), recipe).chains.front().segments;
  const double angle = -kPi / 2 - 100.0 / 200; // clockwise
  expectAt(geometry::startPoint(segments.back().shape), {275 * std::cos(angle), 275 * std::sin(angle)});
}

} // namespace
} // namespace arris::toolpath
