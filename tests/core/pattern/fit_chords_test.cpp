#include "core/base/numbers.h"
#include "core/base/tolerances.h"
#include "core/pattern/pattern.h"
#include "tests/support/contours.h"
#include "tests/support/smooth_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

// Chopped curves: what was drawn in chords is worked as the curve.

namespace arris::pattern {
namespace {

using base::Code;
using base::kPi;
using geometry::Arc;
using geometry::Curve;
using geometry::Line;
using geometry::Point;
using geometry::Vector;

constexpr double kClose = 0.05;   ///< gap
constexpr double kSmooth = 0.01;  ///< the usual tolerance
constexpr double kCorner = 0.004; ///< rad, a little more than what counts as tangential

std::vector<Point> circlePoints(int count, double radius) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * kPi * i / count;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

Contour only(const Pattern& pattern) {
  EXPECT_EQ(pattern.contours.size(), 1U);
  EXPECT_FALSE(base::hasErrors(pattern.problems)) << base::describeWithPlace(pattern.problems.front());
  return pattern.contours.empty() ? Contour() : pattern.contours.front();
}

Contour fitted(const std::vector<Point>& points, double smooth = kSmooth) {
  return only(test::joined(test::closedLines(points), kClose, smooth));
}

/// The corners of a contour, and how much each turns.
std::vector<Point> cornersOf(const Contour& contour) {
  std::vector<Point> corners;
  for (std::size_t i = 0; i < contour.curves.size() && contour.curves.size() > 1; ++i) {
    const Curve& before = contour.curves[(i + contour.curves.size() - 1) % contour.curves.size()];
    if (std::abs(geometry::turn(geometry::endTangent(before), geometry::startTangent(contour.curves[i]))) > 1e-10) {
      corners.push_back(geometry::startPoint(contour.curves[i]));
    }
  }
  return corners;
}

double distanceFrom(const Point& p, const std::vector<Curve>& chain) {
  double nearest = HUGE_VAL;
  for (const Curve& curve : chain) {
    nearest = std::min(nearest, geometry::nearest(curve, p).distance);
  }
  return nearest;
}

double farthestPoint(const std::vector<Point>& points, const std::vector<Curve>& chain) {
  double most = 0;
  for (const Point& p : points) {
    most = std::max(most, distanceFrom(p, chain));
  }
  return most;
}

void expectFaithful(const Contour& contour, const std::vector<Point>& points) {
  const std::vector<Curve> chords = test::closedLines(points);
  EXPECT_TRUE(test::isWellJoined(contour.curves, base::kTangentTurn));
  EXPECT_LE(contour.fitDeviation, kSmooth);
  EXPECT_LE(test::farthest(contour.curves, chords), contour.fitDeviation + 1e-6);
  EXPECT_LE(test::farthest(chords, contour.curves), contour.fitDeviation + 1e-6);
}

TEST(Chopped, ACircleIsTheCircle) {
  for (const auto& [count, radius] : {std::pair(2000, 400.0), {100, 10.0}, {40, 2.0}, {10000, 1000.0}}) {
    const double sagitta = radius * (1 - std::cos(kPi / count));
    const Contour contour = fitted(circlePoints(count, radius));
    ASSERT_EQ(contour.curves.size(), 1U) << count;
    const Arc& circle = std::get<Arc>(contour.curves[0]);
    EXPECT_NEAR(circle.radius(), radius - sagitta / 2, 1e-3 * sagitta + 1e-9) << "half-way between vertices and chords";
    EXPECT_NEAR(circle.sweep(), 2 * kPi, 1e-12);
    EXPECT_NEAR(contour.fitDeviation, sagitta / 2, 1e-3 * sagitta + 1e-9);
  }
}

TEST(Chopped, ACircleDrawnTooCoarselyStaysAPolygonAndNamesTheTolerance) {
  const std::vector<Point> corners = circlePoints(32, 10);
  const Pattern coarse = test::joined(test::closedLines(corners), kClose, kSmooth);
  EXPECT_EQ(only(coarse).curves.size(), 32U);
  EXPECT_EQ(coarse.contours[0].fitDeviation, 0);
  const std::vector<base::Problem> notes = test::problemsOf(coarse, Code::ChordsTooCoarse);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].contour, 1);
  EXPECT_TRUE(notes[0].where.has_value());
  double needed = 0;
  for (const base::Value& value : notes[0].values) {
    needed = value.name == "needed_mm" ? std::get<double>(value.value) : needed;
  }
  EXPECT_NEAR(needed, 10 * (1 - std::cos(kPi / 32)), 2e-4);
  const Pattern joinedAtThat = test::joined(test::closedLines(corners), kClose, needed);
  EXPECT_EQ(only(joinedAtThat).curves.size(), 1U);
  EXPECT_TRUE(joinedAtThat.problems.empty());
}

TEST(Chopped, NothingIsFittedWhereItIsSwitchedOff) {
  EXPECT_EQ(fitted(circlePoints(100, 10), 0).curves.size(), 100U);
}

TEST(Chopped, APolygonIsNoCurve) {
  for (const int count : {3, 4, 6, 8, 12}) {
    const Pattern pattern = test::joined(test::closedLines(circlePoints(count, 50)), kClose, kSmooth);
    EXPECT_EQ(only(pattern).curves.size(), static_cast<std::size_t>(count));
    EXPECT_TRUE(pattern.problems.empty()) << count;
  }
}

TEST(Chopped, ARectangleWithAVertexOnASideIsTheRectangle) {
  for (const double height : {0.0, 1e-9, -1e-6, 1e-4, -1.5e-4}) {
    for (const double at : {1.0, 300.0, 599.5}) {
      const std::vector<Point> corners{{0, 0}, {600, 0}, {600, 400}, {0, 400}};
      std::vector<Point> points = corners;
      points.insert(points.begin() + 1, Point(at, height));
      const Contour contour = fitted(points);
      EXPECT_TRUE(test::areSame(contour.curves, test::closedLines(corners), 1e-9)) << height << " at " << at;
      EXPECT_NEAR(contour.fitDeviation, std::abs(height), 1e-9);
    }
  }
}

TEST(Chopped, SmallCornersAndNotchesAreNoCurves) {
  for (const std::vector<Point>& points :
       {std::vector<Point>{{0, 0}, {100, 0}, {100, 99.98}, {99.98, 100}, {0, 100}},
        std::vector<Point>{{0, 0}, {50, 0}, {50, 0.008}, {50.1, 0.008}, {50.1, 0}, {100, 0}, {100, 100}, {0, 100}},
        std::vector<Point>{{0, 0}, {99.99, 0}, {100, 0.01}, {100, 100}, {0, 100}}}) {
    EXPECT_TRUE(test::areSame(fitted(points).curves, test::closedLines(points), 0));
  }
}

TEST(Chopped, ARoundedRectangleIsLinesAndArcs) {
  for (const double chord : {0.2, 0.5, 1.0}) {
    for (const bool sidesToo : {false, true}) {
      const std::vector<Curve> shape = test::roundedRectangle(100, 80, 20);
      const std::vector<Point> points = test::choppedEvenly(shape, chord, sidesToo);
      const Contour contour = fitted(points);
      ASSERT_EQ(contour.curves.size(), 8U) << chord << sidesToo;
      EXPECT_TRUE(cornersOf(contour).empty());
      expectFaithful(contour, points);
      EXPECT_LT(test::farthest(contour.curves, shape), contour.fitDeviation + 1e-6);
      for (const Curve& curve : contour.curves) {
        if (const auto* arc = std::get_if<Arc>(&curve)) {
          EXPECT_NEAR(arc->radius(), 20, 0.02);
        }
      }
    }
  }
}

TEST(Chopped, AStadiumIsTwoLinesAndTwoArcs) {
  const std::vector<Curve> shape{Line{{0, 0}, {100, 0}}, geometry::arcAbout({100, 20}, 20, -kPi / 2, kPi),
                                 Line{{100, 40}, {0, 40}}, geometry::arcAbout({0, 20}, 20, kPi / 2, kPi)};
  const std::vector<Point> points = test::choppedEvenly(shape, 0.5, false);
  const Contour contour = fitted(points);
  EXPECT_EQ(contour.curves.size(), 4U);
  expectFaithful(contour, points);
}

TEST(Chopped, BetweenTrueCornersAnArcIsOneArcAndALineIsAsDrawn) {
  const std::vector<Curve> shape{Line{{-50, 0}, {50, 0}}, geometry::arcAbout({0, 0}, 50, 0, kPi)};
  const Contour contour = fitted(test::choppedEvenly(shape, 0.5, false));
  ASSERT_EQ(contour.curves.size(), 2U);
  EXPECT_TRUE(test::areSame({contour.curves[0]}, {shape[0]}, 0));
  EXPECT_LT(test::farthest(contour.curves, shape), 1e-3);
}

TEST(Chopped, ACornerBetweenChoppedLinesStays) {
  for (const double turn : {0.15, 0.6, -0.15}) {
    std::vector<Curve> shape{Line{{0, 0}, {100, 0}},
                             Line{{100, 0}, Point(100, 0) + 100 * Vector(std::cos(turn), std::sin(turn))}};
    const Point end = geometry::endPoint(shape[1]);
    shape.emplace_back(Line{end, {150, 200}});
    shape.emplace_back(Line{{150, 200}, {0, 200}});
    shape.emplace_back(Line{{0, 200}, {0, 0}});
    std::vector<Point> points = test::choppedEvenly(shape, 0.1, true);
    for (std::size_t i = 0; i < points.size(); ++i) { // not so collinear that they are one line anyway
      points[i].y() += i % 1000 == 0 ? 0 : 2e-5 * std::sin(static_cast<double>(i * i));
    }
    const Contour contour = fitted(points);
    EXPECT_EQ(contour.curves.size(), shape.size()) << turn;
    EXPECT_EQ(cornersOf(contour).size(), shape.size()) << turn;
    EXPECT_LT(test::farthest(contour.curves, shape), 1e-4) << turn;
    EXPECT_LT(distanceFrom({100, 0}, contour.curves), 1e-12) << turn;
  }
}

TEST(Chopped, ChordsBesideATrueArcAreTangentialToIt) {
  const Arc first = geometry::arcAbout({100, 20}, 20, -kPi / 2, 1.2);
  const Arc second = geometry::arcAbout({100, 20}, 20, -kPi / 2 + 1.2, kPi - 1.2);
  std::vector<Curve> pieces{Line{{0, 0}, {100, 0}}};
  const std::vector<Point> points = test::choppedEvenly({first}, 0.4, false);
  for (std::size_t i = 0; i < points.size(); ++i) {
    pieces.emplace_back(Line{points[i], i + 1 < points.size() ? points[i + 1] : second.start});
  }
  pieces.insert(pieces.end(), {second, Line{{100, 40}, {0, 40}}, Line{{0, 40}, {0, 0}}});
  const Contour contour = only(test::joined(test::shuffled(pieces, 3), kClose, kSmooth));
  EXPECT_EQ(cornersOf(contour).size(), 2U);
  EXPECT_LE(contour.curves.size(), 6U);
  EXPECT_TRUE(test::isWellJoined(contour.curves, base::kTangentTurn));
  EXPECT_LT(test::farthest(pieces, contour.curves), kSmooth);
}

TEST(Chopped, ALoopFromOneCornerBackToItIsSmoothBetween) {
  std::vector<Point> drop;
  for (int i = 0; i < 400; ++i) { // a drop with its tip in the origin
    const double angle = 2 * kPi * i / 400;
    drop.emplace_back(40 * (1 - std::cos(angle)), 60 * std::sin(angle) * std::sin(angle / 2));
  }
  const Contour contour = fitted(drop, 0.05);
  ASSERT_EQ(cornersOf(contour).size(), 1U);
  EXPECT_LT(cornersOf(contour)[0].norm(), 1e-12);
  EXPECT_LT(contour.curves.size(), 60U);
  EXPECT_LE(test::farthest(test::closedLines(drop), contour.curves), 0.05);
}

TEST(Chopped, WhatCannotBeFollowedIsNotFitted) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> off(-0.02, 0.02); // rougher than the tolerance
  std::vector<Point> rough = circlePoints(200, 50);
  for (Point& p : rough) {
    p += Vector(off(random), off(random));
  }
  expectFaithful(fitted(rough), rough);
}

/// Smooth closed shapes in chords of uneven length, rounded as in a file.
struct ChoppedShape {
  std::vector<Point> onCurve; ///< closely along the true curve
  std::vector<Point> chopped;
};

ChoppedShape randomShape(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const test::SmoothShape shape = test::randomSmoothShape(random);
  const double rounding = std::array{0.0, 1e-6, 1e-5, 1e-4}[seed % 4];
  return {shape.points(1000), test::choppedUnevenly(shape, 0.6 * kSmooth, rounding, random)};
}

class RandomCurves : public testing::TestWithParam<std::uint64_t> {};

INSTANTIATE_TEST_SUITE_P(Chopped, RandomCurves, testing::Range<std::uint64_t>(0, 40));

TEST_P(RandomCurves, ComeBackSmoothNearTheTrueCurveAndInFewPieces) {
  const ChoppedShape shape = randomShape(GetParam());
  const Contour contour = fitted(shape.chopped);
  EXPECT_TRUE(cornersOf(contour).empty()) << cornersOf(contour).size() << " corners";
  expectFaithful(contour, shape.chopped);
  EXPECT_LE(farthestPoint(shape.onCurve, contour.curves), kSmooth);
  EXPECT_LE(contour.curves.size(), 20 + shape.chopped.size() / 2);
}

TEST_P(RandomCurves, AreTheSameWhateverTheOrderTheDirectionAndTheStart) {
  ChoppedShape shape = randomShape(GetParam());
  const Contour expected = fitted(shape.chopped);
  std::rotate(shape.chopped.begin(), shape.chopped.begin() + 17, shape.chopped.end());
  EXPECT_TRUE(test::areSame(fitted(shape.chopped).curves, expected.curves, 1e-6)) << "another start";
  std::reverse(shape.chopped.begin(), shape.chopped.end());
  EXPECT_TRUE(test::areSame(fitted(shape.chopped).curves, expected.curves, 1e-6)) << "another direction";
  const std::vector<Curve> lines = test::shuffled(test::closedLines(shape.chopped), GetParam());
  EXPECT_TRUE(test::areSame(only(test::joined(lines, kClose, kSmooth)).curves, expected.curves, 1e-6)) << "any order";
}

TEST_P(RandomCurves, KeepTheCornersThatWereCutIntoThem) {
  ChoppedShape shape = randomShape(GetParam());
  // A wedge towards the middle of the shape, between two vertices.
  const std::size_t at = shape.chopped.size() / 3;
  const Point tip = 0.9 * shape.chopped[at];
  shape.chopped[at] = tip;
  const std::vector<Point> drawn{shape.chopped[at - 1], tip, shape.chopped[at + 1]};
  const Contour contour = fitted(shape.chopped);
  const std::vector<Point> corners = cornersOf(contour);
  EXPECT_EQ(corners.size(), 3U);
  for (const Point& corner : drawn) {
    const auto isIt = [&](const Point& p) { return (p - corner).norm() < 1e-12; };
    EXPECT_TRUE(std::any_of(corners.begin(), corners.end(), isIt)) << corner.transpose();
  }
  expectFaithful(contour, shape.chopped);
}

} // namespace
} // namespace arris::pattern
