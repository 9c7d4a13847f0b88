#include "core/base/numbers.h"
#include "core/pattern/pattern.h"
#include "tests/support/contours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

// Several contours in one drawing, and drawings whose pieces are chains.

namespace arris::pattern {
namespace {

using base::Code;
using geometry::Arc;
using geometry::Curve;
using geometry::Line;
using geometry::Point;
using geometry::Vector;

constexpr double kJoinGap = 0.05;

/// A star-shaped contour about `center` that stays between 0.4 and 1 times `radius` away from it.
std::vector<Point> starCorners(const Point& center, double radius, std::mt19937_64& random) {
  std::uniform_real_distribution<double> part(0, 1);
  const int count = 5 + static_cast<int>(random() % 10);
  std::vector<Point> corners;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * base::kPi * (i + 0.4 * part(random)) / count;
    const double away = radius * (0.8 + 0.2 * part(random));
    corners.emplace_back(center + away * Vector(std::cos(angle), std::sin(angle)));
  }
  return corners;
}

struct Nested {
  std::vector<std::vector<Point>> polygons;
  int deepest = 0;
};

/// Contours in circles that do not meet, each circle inside the clear middle of another or beside it.
void addNested(const Point& center, double radius, int depth, std::mt19937_64& random, Nested& nested) {
  nested.polygons.push_back(starCorners(center, radius, random));
  nested.deepest = std::max(nested.deepest, depth);
  const double clear = radius * 0.15;
  if (depth == 7 || clear < 0.1) {
    return;
  }
  const int inside = depth < 5 ? 1 + static_cast<int>(random() % 2) : static_cast<int>(random() % 2);
  for (int i = 0; i < inside; ++i) {
    const Vector aside = inside == 1 ? Vector(0, 0) : Vector((i == 0 ? -0.5 : 0.5) * clear, 0);
    addNested(center + aside, inside == 1 ? clear : 0.45 * clear, depth + 1, random, nested);
  }
}

bool isInside(const std::vector<Point>& polygon, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0, k = polygon.size() - 1; i < polygon.size(); k = i++) {
    const Point& a = polygon[i];
    const Point& b = polygon[k];
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
      inside = !inside;
    }
  }
  return inside;
}

/// The polygon that a contour was made of: the one with a corner where it starts.
std::size_t polygonOf(const Contour& contour, const Nested& nested) {
  const Point start = geometry::startPoint(contour.curves.front());
  for (std::size_t i = 0; i < nested.polygons.size(); ++i) {
    for (const Point& corner : nested.polygons[i]) {
      if ((corner - start).norm() < 1e-9) {
        return i;
      }
    }
  }
  return nested.polygons.size();
}

TEST(SeveralContours, AreToldApartByContainmentToAnyDepth) {
  int deepest = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::mt19937_64 random(seed);
    Nested nested;
    addNested({0, 0}, 1e6, 0, random, nested);
    addNested({2.1e6, 1e5}, 1e6, 0, random, nested);
    deepest = std::max(deepest, nested.deepest);
    std::vector<Curve> pieces;
    for (const std::vector<Point>& polygon : nested.polygons) {
      const std::vector<Curve> lines = test::closedLines(polygon);
      pieces.insert(pieces.end(), lines.begin(), lines.end());
    }
    const Pattern pattern = test::joined(test::shuffled(pieces, seed), 1e-4);
    ASSERT_EQ(pattern.contours.size(), nested.polygons.size());
    ASSERT_TRUE(pattern.problems.empty()) << base::describeWithPlace(pattern.problems[0]);
    for (const Contour& contour : pattern.contours) {
      const std::vector<Point>& own = nested.polygons[polygonOf(contour, nested)];
      int depth = 0;
      const Contour* parent = nullptr;
      for (const Contour& other : pattern.contours) {
        if (other.id == contour.id || !isInside(nested.polygons[polygonOf(other, nested)], own.front())) {
          continue;
        }
        ++depth;
        const bool nearer =
            !parent || std::abs(geometry::signedArea(other.curves)) < std::abs(geometry::signedArea(parent->curves));
        parent = nearer ? &other : parent;
      }
      EXPECT_EQ(contour.kind == ContourKind::CutOut, depth % 2 == 1) << seed;
      EXPECT_EQ(geometry::signedArea(contour.curves) < 0, depth % 2 == 1) << seed;
      EXPECT_EQ(contour.parent, parent ? parent->id : 0) << seed;
    }
  }
  EXPECT_GE(deepest, 5);
}

std::vector<Curve> square(double x, double y, double side) {
  return test::closedLines({{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}});
}

std::vector<Curve> both(std::vector<Curve> a, const std::vector<Curve>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

struct Meeting {
  std::string name;
  std::vector<Curve> other; ///< beside or in the square from (0, 0) to (100, 100)
  std::vector<Point> where;
};

class ContoursThatMeet : public testing::TestWithParam<Meeting> {};

INSTANTIATE_TEST_SUITE_P(
    SeveralContours, ContoursThatMeet,
    testing::Values(
        Meeting{"crossingSquares", square(60, 60, 80), {{100, 60}, {60, 100}}},
        Meeting{"aCornerOnASide", test::closedLines({{100, 50}, {150, 20}, {150, 80}}), {{100, 50}}},
        Meeting{"aCornerALittleBesideASide", test::closedLines({{100.0005, 50}, {150, 20}, {150, 80}}), {{100, 50}}},
        Meeting{"aCircleThatTouchesFromInside", {geometry::arcAbout({50, 20}, 20, 1, 2 * base::kPi)}, {{50, 0}}},
        Meeting{"aCircleThroughACorner", {geometry::arcAbout({0, 0}, 20, 1, 2 * base::kPi)}, {{20, 0}, {0, 20}}},
        Meeting{"sidesOnEachOther", test::closedLines({{100, 20}, {140, 20}, {140, 60}, {100, 60}}), {{100, 20}}}),
    [](const testing::TestParamInfo<Meeting>& test) { return test.param.name; });

TEST_P(ContoursThatMeet, AreRefusedWithThePlace) {
  for (std::uint64_t order = 0; order < 3; ++order) {
    const Pattern pattern = test::joined(test::shuffled(both(square(0, 0, 100), GetParam().other), order), 1e-4);
    ASSERT_EQ(pattern.contours.size(), 2U);
    for (const base::Problem& problem : pattern.problems) {
      EXPECT_EQ(problem.code, Code::ContoursCross);
    }
    for (const Point& place : GetParam().where) {
      const auto isThere = [&](const base::Problem& p) { return (*p.where - place).norm() < 2e-3; };
      EXPECT_TRUE(std::any_of(pattern.problems.begin(), pattern.problems.end(), isThere)) << place.transpose();
    }
  }
}

TEST(SeveralContours, ThatOnlyComeNearAreNotRefused) {
  const std::vector<Curve> island = test::closedLines({{0.002, 0.002}, {99.998, 0.002}, {99.998, 99}, {0.002, 99}});
  const Pattern pattern = test::joined(both(square(0, 0, 100), island), 1e-4);
  EXPECT_TRUE(pattern.problems.empty());
  EXPECT_EQ(pattern.contours.size(), 2U);
}

TEST(SeveralContours, AreFoundToCrossAmongThousands) {
  std::vector<Curve> pieces;
  for (int i = 0; i < 60; ++i) {
    for (int k = 0; k < 60; ++k) {
      pieces = both(std::move(pieces), square(10.0 * i, 10.0 * k, 8));
    }
  }
  EXPECT_TRUE(test::joined(pieces, kJoinGap).problems.empty());
  pieces = both(std::move(pieces), square(307, 307, 2)); // over a corner of one, clear of the next
  const Pattern pattern = test::joined(pieces, kJoinGap);
  EXPECT_EQ(test::problemsOf(pattern, Code::ContoursCross).size(), 2U);
}

TEST(SeveralContours, TooManyWithinEachOtherAreRefusedAndNotComparedOneByOne) {
  Pieces pieces;
  for (int i = 0; i < 20000; ++i) {
    pieces.add(geometry::arcAbout({0, 0}, 10 + 0.1 * i, 0, 2 * base::kPi));
  }
  const Pattern pattern = joinPieces(pieces, kJoinGap, 0);
  EXPECT_EQ(pattern.contours.size(), 20000u);
  EXPECT_TRUE(std::any_of(pattern.problems.begin(), pattern.problems.end(),
                          [](const base::Problem& p) { return p.code == Code::ContoursTooDense && p.where; }));
}

TEST(Join, APieceThatEndsOnAnotherIsToldWhereAndLeavesTheRestRight) {
  const Arc ring = geometry::arcAbout({300, 50}, 40, 0.3, 2 * base::kPi);
  std::vector<Curve> pieces = both(square(0, 0, 100), {ring, Line{{30, 0}, {30, 40}}, Line{{260, 50}, {250, 10}}});
  for (std::uint64_t order = 0; order < 4; ++order) {
    const Pattern pattern = test::joined(test::shuffled(pieces, order), kJoinGap);
    EXPECT_EQ(pattern.contours.size(), 2U);
    EXPECT_EQ(pattern.loose.size(), 2U);
    const std::vector<base::Problem> told = test::problemsOf(pattern, Code::EndOnPiece);
    ASSERT_EQ(told.size(), 2U);
    EXPECT_LT((*told[0].where - Point(30, 0)).norm(), 1e-9);
    EXPECT_LT((*told[1].where - Point(260, 50)).norm(), 1e-9);
  }
}

TEST(Join, ALineDrawnAgainOverAPartOfASideIsToldAtBothEnds) {
  const Pattern pattern = test::joined(both(square(0, 0, 100), {Line{{20, 0}, {70, 0}}}), kJoinGap);
  EXPECT_EQ(pattern.contours.size(), 1U);
  EXPECT_EQ(test::problemsOf(pattern, Code::EndOnPiece).size(), 2U);
}

TEST(Join, ABranchSpoilsOnlyTheChainThatBranches) {
  std::vector<Curve> pieces = both(square(0, 0, 100), square(200, 0, 100));
  pieces.emplace_back(Line{{200, 0}, {300, 100}});
  const Pattern pattern = test::joined(test::shuffled(pieces, 3), kJoinGap);
  ASSERT_EQ(pattern.contours.size(), 1U);
  EXPECT_NEAR(geometry::bounds(pattern.contours[0].curves).max().x(), 100, 1e-9);
  EXPECT_EQ(test::problemsOf(pattern, Code::BranchingChain).size(), 2U);
}

/// A smooth chain of many short arcs from (0, 0) to (100, 0), as a spline becomes one.
std::vector<Curve> manyArcs() {
  std::vector<Curve> arcs;
  constexpr int kCount = 5000;
  const Arc whole = geometry::arcBetween({0, 0}, {100, 0}, -2);
  for (int i = 0; i < kCount; ++i) {
    arcs.push_back(geometry::part(whole, whole.length * i / kCount, whole.length * (i + 1) / kCount));
  }
  return arcs;
}

TEST(Join, APieceOfManyCurvesIsJoinedAtItsEndsOnly) {
  Pieces pieces;
  pieces.add(manyArcs());
  pieces.add(Line{{100, 0.02}, {100, -50}}); // nearer to the last arc's end than that arc is long
  pieces.add(Line{{100, -50}, {0, -50}});
  pieces.add(Line{{0, -50}, {0, 0}});
  const Pattern pattern = joinPieces(pieces, kJoinGap, 0);
  ASSERT_EQ(pattern.contours.size(), 1U);
  EXPECT_FALSE(base::hasErrors(pattern.problems));
  EXPECT_EQ(pattern.repairs.size(), 1U);
  EXPECT_LT(test::farthest(manyArcs(), pattern.contours[0].curves), 0.0101);
}

TEST(Join, AClosedPieceIsAContourByItself) {
  const std::vector<Curve> lines = square(0, 0, 100);
  Pieces pieces;
  pieces.add(lines);
  pieces.add(square(100, 100, 50)); // meets the first in one point: ends of four, were they single lines
  const Pattern pattern = joinPieces(pieces, kJoinGap, 0);
  EXPECT_EQ(pattern.contours.size(), 2U);
  EXPECT_EQ(test::problemsOf(pattern, Code::ContoursCross).size(), 1U);
  EXPECT_TRUE(test::problemsOf(pattern, Code::BranchingChain).empty());
}

std::vector<Curve> backwards(std::vector<Curve> chain) {
  std::reverse(chain.begin(), chain.end());
  std::transform(chain.begin(), chain.end(), chain.begin(), geometry::reversed);
  return chain;
}

TEST(Join, CopiesOfChainsAreRemovedWhicheverWayTheyWereDrawn) {
  const std::vector<Curve> open = manyArcs();
  std::vector<Curve> rest = test::closedLines({{100, 0}, {100, -50}, {0, -50}, {0, 0}});
  rest.pop_back();
  Pieces pieces;
  pieces.add(open);
  pieces.add(backwards(open));
  pieces.add(rest);
  pieces.add(rest);
  const Pattern pattern = joinPieces(pieces, kJoinGap, 0);
  EXPECT_EQ(pattern.contours.size(), 1U);
  EXPECT_TRUE(pattern.problems.empty());
  EXPECT_EQ(pattern.repairs.size(), 2U);
}

TEST(Join, AContourDrawnOverInOtherPiecesIsRemoved) {
  const std::vector<Curve> lines = square(0, 0, 100);
  std::vector<Curve> fromAnotherCorner = lines;
  std::rotate(fromAnotherCorner.begin(), fromAnotherCorner.begin() + 2, fromAnotherCorner.end());
  Pieces pieces;
  pieces.add(lines);
  pieces.add(backwards(fromAnotherCorner));
  for (const Curve& line : lines) {
    pieces.add(line);
  }
  pieces.add(square(20, 20, 60));
  const Pattern pattern = joinPieces(pieces, kJoinGap, 0);
  EXPECT_EQ(pattern.contours.size(), 2U);
  EXPECT_TRUE(pattern.problems.empty());
  EXPECT_EQ(pattern.repairs.size(), 2U);
}

TEST(Join, ChainsThatOnlyShareEndsAndMiddleAreNotCopies) {
  std::vector<Curve> zigzag;
  std::vector<Curve> zagzig;
  for (int i = 0; i < 4; ++i) { // both through (50, 0), on either side of the straight way
    const double side = i % 2 == 0 ? 10 : -10;
    const Point from(25.0 * i, 0);
    const Point to(25.0 * (i + 1), 0);
    zigzag.insert(zigzag.end(), {Line{from, {from.x() + 12.5, side}}, Line{{from.x() + 12.5, side}, to}});
    zagzig.insert(zagzig.end(), {Line{from, {from.x() + 12.5, -side}}, Line{{from.x() + 12.5, -side}, to}});
  }
  Pieces pieces;
  pieces.add(zigzag);
  pieces.add(zagzig);
  EXPECT_TRUE(joinPieces(pieces, kJoinGap, 0).repairs.empty());
}

TEST(Join, CurvesWithoutLengthInsideAPieceAreTakenOut) {
  std::vector<Curve> lines = square(0, 0, 100);
  lines.insert(lines.begin() + 1, Line{{100, 0}, {100, 1e-8}});
  lines[2] = Line{{100, 1e-8}, {100, 100}};
  Pieces pieces;
  pieces.add(lines);
  const Pattern pattern = joinPieces(pieces, kJoinGap, 0);
  ASSERT_EQ(pattern.contours.size(), 1U);
  EXPECT_EQ(pattern.contours[0].curves.size(), 4U);
  EXPECT_EQ(pattern.repairs.size(), 1U);
  EXPECT_TRUE(test::isWellJoined(pattern.contours[0].curves, 0));
}

} // namespace
} // namespace arris::pattern
