#include "core/base/numbers.h"
#include "core/base/tolerances.h"
#include "core/pattern/contour.h"
#include "tests/support/contours.h"

#include <gtest/gtest.h>

#include <cmath>

namespace arris::pattern {
namespace {

using base::Code;
using base::kPi;
using geometry::Arc;
using geometry::Curve;
using geometry::Line;
using geometry::Point;

std::vector<Curve> circle(double x, double y, double radius) {
  return {geometry::arcAbout({x, y}, radius, -kPi / 2, 2 * kPi)};
}

std::vector<Curve> together(std::vector<Curve> a, const std::vector<Curve>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::vector<Code> codesOf(const Pattern& pattern) {
  std::vector<Code> codes;
  for (const base::Problem& problem : pattern.problems) {
    codes.push_back(problem.code);
  }
  return codes;
}

TEST(Contour, RunsCounterClockwiseFromItsLowestCorner) {
  const Pattern pattern = test::joined(test::closedLines({{0, 50}, {100, 50}, {100, 0}, {0, 0}}), 0.05); // clockwise
  ASSERT_EQ(pattern.contours.size(), 1U);
  const Contour& contour = pattern.contours[0];
  EXPECT_EQ(contour.id, 1);
  EXPECT_EQ(contour.kind, ContourKind::Outline);
  EXPECT_NEAR(geometry::signedArea(contour.curves), 5000, 1e-9);
  EXPECT_EQ(geometry::startPoint(contour.curves[0]), Point(0, 0));
  EXPECT_EQ(geometry::endPoint(contour.curves[0]), Point(100, 0));
}

TEST(Contour, MakesOneOfCollinearLinesAndOfArcsOfOneCircle) {
  const std::vector<Curve> pieces{Line{{0, 0}, {30, 0}},
                                  Line{{30, 0}, {31, 0}},
                                  Line{{31, 0}, {100, 0}},
                                  geometry::arcAbout({100, 20}, 20, -kPi / 2, 1),
                                  geometry::arcAbout({100, 20}, 20, -kPi / 2 + 1, kPi - 1),
                                  Line{{100, 40}, {0, 40}},
                                  Line{{0, 40}, {0, 20}},
                                  Line{{0, 20}, {0, 0}}};
  const Pattern pattern = test::joined(pieces, 0.05);
  ASSERT_EQ(pattern.contours.size(), 1U);
  EXPECT_EQ(pattern.contours[0].curves.size(), 4U);
  EXPECT_LT(test::farthest(pieces, pattern.contours[0].curves), 1e-9);
}

TEST(Contour, MakesOneAcrossItsStartToo) {
  // The lowest corner is not a corner: it lies in the middle of the lower side.
  const Pattern pattern = test::joined(test::closedLines({{-100, 0}, {0, 0}, {100, 0}, {100, 50}, {-100, 50}}), 0.05);
  ASSERT_EQ(pattern.contours.size(), 1U);
  EXPECT_EQ(pattern.contours[0].curves.size(), 4U);
}

TEST(Contour, ACircleInPiecesIsACircle) {
  std::vector<Curve> quarters;
  for (int i = 0; i < 4; ++i) {
    quarters.emplace_back(geometry::arcAbout({10, 20}, 30, 0.3 + i * kPi / 2, kPi / 2));
  }
  const Pattern pattern = test::joined(test::shuffled(quarters, 2), 0.05);
  ASSERT_EQ(pattern.contours.size(), 1U);
  ASSERT_EQ(pattern.contours[0].curves.size(), 1U);
  EXPECT_NEAR(std::get<Arc>(pattern.contours[0].curves[0]).radius(), 30, 1e-9);
  EXPECT_LT((geometry::startPoint(pattern.contours[0].curves[0]) - Point(10, -10)).norm(), 1e-9);
}

TEST(Contour, ATrueCornerBetweenArcsOfOneRadiusStays) {
  const std::vector<Curve> lens{geometry::arcBetween({0, 0}, {60, 0}, 1.5), geometry::arcBetween({60, 0}, {0, 0}, 1.5)};
  const Pattern pattern = test::joined(lens, 0.05);
  ASSERT_EQ(pattern.contours.size(), 1U);
  EXPECT_EQ(pattern.contours[0].curves.size(), 2U);
  EXPECT_TRUE(pattern.problems.empty());
}

struct Crossing {
  std::string name;
  std::vector<Curve> pieces;
  Point where;
};

class CrossesItself : public testing::TestWithParam<Crossing> {};

INSTANTIATE_TEST_SUITE_P(
    Contour, CrossesItself,
    testing::Values(
        Crossing{"bowTie", test::closedLines({{0, 0}, {100, 100}, {100, 0}, {0, 100}}), {50, 50}},
        Crossing{"unevenBowTie", test::closedLines({{0, 0}, {120, 100}, {120, 0}, {0, 50}}), {600.0 / 15, 500.0 / 15}},
        Crossing{"cornerOnASide", test::closedLines({{0, 0}, {100, 0}, {100, 50}, {50, 0}, {0, 50}}), {50, 0}},
        Crossing{"slotOfNoWidth",
                 test::closedLines({{0, 0},
                                    {100, 0},
                                    {100, 50},
                                    {60, 50},
                                    {60, 20},
                                    {50, 20},
                                    {50, 10},
                                    {60, 10},
                                    {60, 15},
                                    {60.0001, 15},
                                    {60.0001, 50.5},
                                    {0, 50.5}}),
                 {60, 20}},
        Crossing{
            "spike", test::closedLines({{0, 0}, {100, 0}, {100, 50}, {100, 80}, {100, 50.5}, {0, 50.5}}), {100, 80}},
        Crossing{"arcThroughTheOppositeSide",
                 {Line{{0, 0}, {100, 0}}, geometry::arcBetween({100, 0}, {100, 40}, -kPi * 1.2),
                  Line{{100, 40}, {0, 40}}, Line{{0, 40}, {0, 0}}},
                 {0, 0}},
        Crossing{"neighboursThatMeetAgain",
                 {Line{{0, 0}, {100, 0}}, geometry::arcBetween({100, 0}, {30, -10}, 4.7), Line{{30, -10}, {0, 0}}},
                 {20.1231287, 0}},
        Crossing{"neighbourEndsOnTheOther",
                 {Line{{0, 0}, {100, 0}}, geometry::arcBetween({100, 0}, {50, 0}, kPi), Line{{50, 0}, {50, 50}},
                  Line{{50, 50}, {0, 0}}},
                 {50, 0}}),
    [](const testing::TestParamInfo<Crossing>& test) { return test.param.name; });

TEST_P(CrossesItself, AndIsRefusedWithThePlace) {
  const Pattern pattern = test::joined(GetParam().pieces, 1e-5);
  ASSERT_EQ(pattern.contours.size(), 1U);
  double nearest = 1e9;
  for (const base::Problem& problem : pattern.problems) {
    ASSERT_EQ(problem.code, Code::ContourCrossesItself);
    nearest = std::min(nearest, (*problem.where - GetParam().where).norm());
  }
  ASSERT_FALSE(pattern.problems.empty());
  if (GetParam().where != Point(0, 0)) {
    EXPECT_LT(nearest, 1e-3);
  }
}

TEST(Contour, ThatOnlyComesNearItselfIsNotRefused) {
  // A slot of 0.01 mm, a needle of 0.3°, a ring with a mouth of 0.005 mm.
  for (const std::vector<Curve>& pieces :
       {test::closedLines({{0, 0}, {100, 0}, {100, 50}, {50.01, 50}, {50.01, 20}, {50, 20}, {50, 50}, {0, 50}}),
        test::closedLines({{0, 0}, {100, 0}, {0, 0.5}}),
        std::vector<Curve>{geometry::arcAbout({0, 0}, 50, 0.00005, 2 * kPi - 0.0001),
                           Line{{50 * std::cos(0.00005), -50 * std::sin(0.00005)}, {45, -0.00225}},
                           geometry::arcAbout({0, 0}, std::hypot(45, 0.00225), -0.00005, -(2 * kPi - 0.0001)),
                           Line{{45, 0.00225}, {50 * std::cos(0.00005), 50 * std::sin(0.00005)}}}}) {
    const Pattern pattern = test::joined(pieces, 1e-4);
    ASSERT_EQ(pattern.contours.size(), 1U);
    EXPECT_TRUE(pattern.problems.empty()) << base::describeWithPlace(pattern.problems.front());
  }
}

TEST(Contour, WithoutAreaIsDegenerate) {
  const Pattern pattern = test::joined({Line{{0, 0}, {100, 0}}, geometry::arcBetween({100, 0}, {0, 0}, 2e-4)}, 0.05);
  ASSERT_EQ(pattern.contours.size() + pattern.repairs.size(), 1U + pattern.repairs.size());
  EXPECT_EQ(codesOf(test::joined({Line{{0, 0}, {10, 0}}, geometry::arcBetween({10, 0}, {0, 0}, 1e-3)}, 0.05)),
            std::vector<Code>{Code::ContourDegenerate});
}

TEST(Contours, SeveralAreNumberedByPlaceAndToldApart) {
  // An outline with a hole and an island in it, and a second outline to the left.
  std::vector<Curve> pieces = together(test::closedLines({{0, 0}, {100, 0}, {100, 100}, {0, 100}}), circle(50, 50, 30));
  pieces = together(pieces, circle(50, 50, 10));
  pieces = together(pieces, test::closedLines({{-50, 0}, {-20, 0}, {-20, 30}}));
  for (std::uint64_t order = 0; order < 4; ++order) {
    const Pattern pattern = test::joined(test::shuffled(pieces, order), 0.05);
    ASSERT_EQ(pattern.contours.size(), 4U);
    std::vector<double> areas;
    for (const Contour& contour : pattern.contours) {
      EXPECT_EQ(contour.id, static_cast<int>(areas.size()) + 1);
      EXPECT_EQ(contour.kind == ContourKind::CutOut, geometry::signedArea(contour.curves) < 0);
      areas.push_back(geometry::signedArea(contour.curves));
    }
    EXPECT_NEAR(areas[0], 450, 1e-9);
    EXPECT_NEAR(areas[1], 10000, 1e-9);
    EXPECT_NEAR(areas[2], -900 * kPi, 1e-9) << "the hole runs clockwise";
    EXPECT_NEAR(areas[3], 100 * kPi, 1e-9) << "the island is an outline again";
    EXPECT_EQ(pattern.contours[0].parent, 0);
    EXPECT_EQ(pattern.contours[1].parent, 0);
    EXPECT_EQ(pattern.contours[2].parent, 2);
    EXPECT_EQ(pattern.contours[3].parent, 3);
    EXPECT_TRUE(pattern.problems.empty());
  }
}

TEST(Contours, InsideIsInsideUnderArcsToo) {
  // Horseshoe of arcs: one small circle in its bow, one in its mouth.
  const std::vector<Curve> horseshoe{
      geometry::arcAbout({0, 0}, 50, -kPi / 4, 1.5 * kPi),
      Line{{-35.355339059327378, -35.355339059327378}, {-21.213203435596427, -21.213203435596427}},
      geometry::arcAbout({0, 0}, 30, 1.25 * kPi, -1.5 * kPi),
      Line{{21.213203435596427, -21.213203435596427}, {35.355339059327378, -35.355339059327378}}};
  const Pattern pattern = test::joined(together(together(horseshoe, circle(0, 40, 3)), circle(0, 0, 3)), 0.05);
  ASSERT_EQ(pattern.contours.size(), 3U);
  int cutOuts = 0;
  for (const Contour& contour : pattern.contours) {
    if (contour.kind == ContourKind::CutOut) {
      ++cutOuts;
      EXPECT_NEAR(geometry::bounds(contour.curves).center().y(), 40, 1e-9);
    }
  }
  EXPECT_EQ(cutOuts, 1);
}

} // namespace
} // namespace arris::pattern
