#include "core/base/numbers.h"
#include "core/pattern/pattern.h"
#include "tests/support/contours.h"
#include "tests/support/random_panes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace arris::pattern {
namespace {

using base::Code;
using base::kPi;
using geometry::Arc;
using geometry::Curve;
using geometry::Line;
using geometry::Point;
using geometry::Vector;

constexpr double kGap = 0.05;

std::vector<Curve> stadium() {
  return {Line{{0, 0}, {100, 0}}, geometry::arcAbout({100, 20}, 20, -kPi / 2, kPi), Line{{100, 40}, {0, 40}},
          geometry::arcAbout({0, 20}, 20, kPi / 2, kPi)};
}

double number(const base::Problem& problem, std::string_view name) {
  for (const base::Value& value : problem.values) {
    if (value.name == name) {
      return std::visit(
          [](const auto& v) -> double {
            if constexpr (std::is_arithmetic_v<std::decay_t<decltype(v)>>) {
              return static_cast<double>(v);
            }
            return std::nan("");
          },
          value.value);
    }
  }
  return std::nan("");
}

TEST(Join, MakesTheSameContourWhateverTheOrderAndTheDirection) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const std::vector<Curve> outline = test::randomPane(seed).pattern.contours[0].curves;
    const Pattern expected = test::joined(outline, kGap);
    ASSERT_EQ(expected.contours.size(), 1U) << seed;
    EXPECT_TRUE(expected.problems.empty()) << seed;
    EXPECT_TRUE(expected.repairs.empty()) << seed;
    EXPECT_LT(test::farthest(outline, expected.contours[0].curves), 1e-6 + expected.contours[0].fitDeviation) << seed;
    for (std::uint64_t order = 0; order < 4; ++order) {
      const Pattern found = test::joined(test::shuffled(outline, order), kGap);
      ASSERT_EQ(found.contours.size(), 1U) << seed;
      EXPECT_TRUE(test::areSame(found.contours[0].curves, expected.contours[0].curves, 1e-9)) << seed;
    }
  }
}

TEST(Join, ClosesGapsInTheMiddleAndTellsThem) {
  std::vector<Curve> pieces = test::closedLines({{0, 0}, {100, 0}, {100, 50}, {0, 50}});
  pieces[1] = Line{{100.03, 0}, {100, 50}};
  const Pattern pattern = test::joined(test::shuffled(pieces, 1), kGap);
  ASSERT_EQ(pattern.contours.size(), 1U);
  EXPECT_FALSE(base::hasErrors(pattern.problems));
  ASSERT_EQ(pattern.repairs.size(), 1U);
  EXPECT_EQ(pattern.repairs[0].code, Code::GapClosed);
  EXPECT_NEAR(number(pattern.repairs[0], "size_mm"), 0.03, 1e-12);
  EXPECT_LT((*pattern.repairs[0].where - Point(100.015, 0)).norm(), 1e-12);
  EXPECT_LT((geometry::endPoint(pattern.contours[0].curves[0]) - Point(100.015, 0)).norm(), 1e-12);
  EXPECT_TRUE(test::isWellJoined(pattern.contours[0].curves, 0));
}

TEST(Join, AnArcKeepsItsSweepWhereItsEndMoves) {
  std::vector<Curve> pieces = stadium();
  pieces[0] = Line{{0, -0.02}, {100, -0.02}};
  const Pattern pattern = test::joined(pieces, kGap);
  ASSERT_EQ(pattern.contours.size(), 1U);
  EXPECT_EQ(pattern.repairs.size(), 2U);
  EXPECT_LT(test::farthest(stadium(), pattern.contours[0].curves), 0.021);
  double sweep = 0;
  for (const Curve& curve : pattern.contours[0].curves) {
    sweep += std::holds_alternative<Arc>(curve) ? std::get<Arc>(curve).sweep() : 0;
  }
  EXPECT_NEAR(sweep, 2 * kPi, 1e-9);
}

TEST(Join, AnArcOfNearlyAFullCircleKeepsItsRadius) {
  // A ring with a narrow mouth, closed by a short line that misses it by 0.02 mm.
  const double half = 0.02;
  const Curve ring = geometry::arcAbout({0, 0}, 100, half, 2 * kPi - 2 * half);
  const Point upper = geometry::startPoint(ring);
  const Point lower = geometry::endPoint(ring);
  const Pattern pattern = test::joined({ring, Line{lower + Vector(0, -0.02), upper}}, kGap);
  ASSERT_EQ(pattern.contours.size(), 1U);
  EXPECT_LT(test::farthest({ring}, pattern.contours[0].curves), 0.03);
}

TEST(Join, AnArcThatAllButClosesIsACircle) {
  const Pattern pattern = test::joined({geometry::arcAbout({5, 5}, 50, 1, 2 * kPi - 0.0004)}, kGap);
  ASSERT_EQ(pattern.contours.size(), 1U);
  ASSERT_EQ(pattern.contours[0].curves.size(), 1U);
  EXPECT_NEAR(geometry::signedArea(pattern.contours[0].curves), 2500 * kPi, 1e-9);
  EXPECT_LT((geometry::startPoint(pattern.contours[0].curves[0]) - Point(5, -45)).norm(), 1e-9);
  EXPECT_EQ(pattern.repairs.size(), 1U);
}

TEST(Join, TakesTheNearestEndsFirst) {
  // At (100, 0) three ends lie within the tolerance of each other; the two nearest belong together.
  const Pattern pattern = test::joined(
      {Line{{0, 0}, {100, 0}}, Line{{100.001, 0}, {100, 60}}, Line{{100, 60}, {0, 0}}, Line{{100.03, 0}, {200, 0}}},
      kGap);
  ASSERT_EQ(pattern.contours.size(), 1U);
  EXPECT_EQ(pattern.loose.size(), 1U);
  EXPECT_EQ(test::problemsOf(pattern, Code::BranchingChain).size(), 1U);
}

TEST(Join, ShortChordsAreNotTakenForGaps) {
  std::vector<Point> corners;
  constexpr int kCount = 3000;
  for (int i = 0; i < kCount; ++i) { // chords of 0.02 mm, less than half of the gap that is closed
    const double angle = 2 * kPi * i / kCount;
    corners.emplace_back(10 * std::cos(angle), 10 * std::sin(angle));
  }
  const Pattern pattern = test::joined(test::shuffled(test::closedLines(corners), 5), kGap);
  ASSERT_EQ(pattern.contours.size(), 1U);
  EXPECT_TRUE(pattern.repairs.empty());
  EXPECT_FALSE(base::hasErrors(pattern.problems));
  EXPECT_NEAR(geometry::signedArea(pattern.contours[0].curves), 100 * kPi, 1e-3);
}

TEST(Join, RemovesPiecesWithoutLengthAndDoublesInEitherDirection) {
  std::vector<Curve> pieces = stadium();
  pieces.emplace_back(Line{{50, 0}, {50, 0}});
  pieces.push_back(geometry::reversed(pieces[0]));
  pieces.push_back(geometry::reversed(pieces[1]));
  pieces.push_back(pieces[1]);
  pieces.emplace_back(Line{{0.0004, 0}, {100, 0.0004}}); // a copy to the accuracy of the program
  for (std::uint64_t order = 0; order < 5; ++order) {
    const Pattern pattern = test::joined(test::shuffled(pieces, order), kGap);
    ASSERT_EQ(pattern.contours.size(), 1U);
    EXPECT_FALSE(base::hasErrors(pattern.problems));
    std::map<Code, int> repairs;
    for (const base::Problem& repair : pattern.repairs) {
      ++repairs[repair.code];
      EXPECT_TRUE(repair.where.has_value());
      EXPECT_FALSE(std::isnan(number(repair, "size_mm")));
    }
    EXPECT_EQ(repairs[Code::ZeroLengthRemoved], 1);
    EXPECT_EQ(repairs[Code::DuplicateRemoved], 4);
    EXPECT_LT(test::farthest(stadium(), pattern.contours[0].curves), 0.001);
  }
}

TEST(Join, DoubledCirclesAreOne) {
  const Pattern pattern = test::joined(
      {geometry::arcAbout({0, 0}, 30, -kPi / 2, 2 * kPi), geometry::arcAbout({0, 0}, 30, -kPi / 2, -2 * kPi)}, kGap);
  EXPECT_EQ(pattern.contours.size(), 1U);
  EXPECT_EQ(pattern.repairs.size(), 1U);
}

TEST(Join, TellsWhereAChainIsOpenAndHowFar) {
  std::vector<Curve> pieces = test::closedLines({{0, 0}, {100, 0}, {100, 50}, {0, 50}});
  pieces[1] = Line{{100, 0.25}, {100, 50}};
  for (std::uint64_t order = 0; order < 5; ++order) {
    const Pattern pattern = test::joined(test::shuffled(pieces, order), kGap);
    EXPECT_TRUE(pattern.contours.empty());
    EXPECT_EQ(pattern.loose.size(), 4U);
    ASSERT_EQ(pattern.problems.size(), 1U);
    EXPECT_EQ(pattern.problems[0].code, Code::OpenChain);
    EXPECT_NEAR(number(pattern.problems[0], "gap_mm"), 0.25, 1e-12);
    EXPECT_EQ(pattern.problems[0].where, Point(100, 0));
  }
  EXPECT_EQ(test::joined(pieces, 0.3).contours.size(), 1U) << "a larger tolerance closes it";
}

TEST(Join, EveryGapIsToldOnce) {
  std::vector<Curve> pieces = test::closedLines({{0, 0}, {100, 0}, {100, 50}, {0, 50}});
  pieces[1] = Line{{100, 1}, {100, 48}};
  const Pattern pattern = test::joined(pieces, kGap);
  const std::vector<base::Problem> open = test::problemsOf(pattern, Code::OpenChain);
  ASSERT_EQ(open.size(), 2U);
  EXPECT_NEAR(number(open[0], "gap_mm"), 1, 1e-12);
  EXPECT_NEAR(number(open[1], "gap_mm"), 2, 1e-12);
}

TEST(Join, ALonePieceIsNamedWithTheDistanceOfItsEnds) {
  const Pattern pattern = test::joined({Line{{0, 0}, {30, 40}}}, kGap);
  ASSERT_EQ(pattern.problems.size(), 1U);
  EXPECT_EQ(pattern.problems[0].code, Code::StrayPiece);
  EXPECT_NEAR(number(pattern.problems[0], "length_mm"), 50, 1e-12);
}

TEST(Join, NamesThePlaceWherePiecesBranch) {
  std::vector<Curve> pieces = test::closedLines({{0, 0}, {100, 0}, {100, 50}, {0, 50}});
  pieces.emplace_back(Line{{100, 0}, {0, 50}});
  const Pattern pattern = test::joined(pieces, kGap);
  const std::vector<base::Problem> branches = test::problemsOf(pattern, Code::BranchingChain);
  ASSERT_EQ(branches.size(), 2U);
  EXPECT_EQ(branches[0].where, Point(100, 0));
  EXPECT_EQ(branches[1].where, Point(0, 50));
  EXPECT_EQ(number(branches[0], "count"), 3);
  EXPECT_TRUE(test::problemsOf(pattern, Code::OpenChain).empty());
}

TEST(Join, ListsNoMoreOfAKindThanAnybodyReads) {
  std::vector<Curve> pieces;
  for (int i = 0; i < 500; ++i) {
    pieces.emplace_back(Line{{10.0 * i, 0}, {10.0 * i + 1, 0}});
  }
  const Pattern pattern = test::joined(pieces, kGap);
  const std::size_t listed = test::problemsOf(pattern, Code::OpenChain).size();
  EXPECT_LE(listed, 20U);
  const std::vector<base::Problem> more = test::problemsOf(pattern, Code::MoreNotListed);
  ASSERT_EQ(more.size(), 1U);
  EXPECT_EQ(number(more[0], "count"), 500 - static_cast<double>(listed));
}

TEST(Join, NothingIsNoContour) {
  const Pattern pattern = test::joined({}, kGap);
  ASSERT_EQ(pattern.problems.size(), 1U);
  EXPECT_EQ(pattern.problems[0].code, Code::NoContour);
}

// Lines half as long as the gap, all over the place: the worst that closing gaps can meet.
TEST(Join, SurvivesDebris) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0, 1);
  std::vector<Curve> pieces;
  for (int i = 0; i < 3000; ++i) {
    const Point p(place(random), place(random));
    pieces.emplace_back(Line{p, p + 0.03 * Vector(place(random) - 0.5, place(random) - 0.5)});
  }
  const Pattern pattern = test::joined(pieces, kGap);
  EXPECT_TRUE(base::hasErrors(pattern.problems));
  for (const Contour& contour : pattern.contours) {
    for (const Curve& curve : contour.curves) {
      EXPECT_TRUE(geometry::endPoint(curve).allFinite());
      EXPECT_TRUE(geometry::endTangent(curve).allFinite());
    }
  }
}

} // namespace
} // namespace arris::pattern
