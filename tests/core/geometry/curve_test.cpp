#include "core/base/numbers.h"
#include "core/geometry/curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace arris::geometry {
namespace {

using base::kPi;
using base::radians;

struct Case {
  std::string name;
  Curve curve;
};

Parabola transition(double cornerDegrees, double leg) {
  const double turned = kPi - radians(cornerDegrees);
  const Point a(3, -7);
  const Point q = a + Vector(leg, 0);
  return {a, q, q + leg * Vector(std::cos(turned), std::sin(turned))};
}

std::vector<Case> linesAndArcs() {
  return {{"line", Line{{-4, 2}, {11, -6}}},
          {"short line", Line{{1000, 1000}, {1000.001, 1000.0005}}},
          {"left arc", arcAbout({10, 20}, 30, 0.3, 1.7)},
          {"right arc", arcAbout({10, 20}, 30, 0.3, -1.7)},
          {"more than half a circle", arcAbout({-5, 0}, 12, 2, 4.4)},
          {"full circle", arcAbout({0, 0}, 7, -kPi / 2, 2 * kPi)},
          {"all but straight", arcBetween({0, 0}, {100, 20}, 1e-7)},
          {"all but straight, right", arcBetween({0, 0}, {100, 20}, -1e-9)}};
}

std::vector<Case> allKinds() {
  std::vector<Case> cases = linesAndArcs();
  cases.push_back({"transition of 60 degrees", transition(60, 129.9038)});
  cases.push_back({"transition of 170 degrees", transition(170, 5)});
  cases.push_back({"transition of 10 degrees", transition(10, 800)});
  return cases;
}

/// Points along the curve, dense enough that neighbours are nearer than `step`.
std::vector<Point> samples(const Curve& curve, int count) {
  std::vector<Point> points;
  for (int i = 0; i <= count; ++i) {
    points.push_back(pointAt(curve, parameterLength(curve) * i / count));
  }
  return points;
}

double sampledDistance(const std::vector<Point>& points, const Point& p) {
  double best = std::numeric_limits<double>::infinity();
  for (const Point& q : points) {
    best = std::min(best, (p - q).norm());
  }
  return best;
}

class EveryCurve : public testing::TestWithParam<Case> {};

class LineOrArc : public testing::TestWithParam<Case> {};

std::string nameOf(const testing::TestParamInfo<Case>& info) {
  std::string name = info.param.name;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == ' ' || c == ','; }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Curve, EveryCurve, testing::ValuesIn(allKinds()), nameOf);
INSTANTIATE_TEST_SUITE_P(Curve, LineOrArc, testing::ValuesIn(linesAndArcs()), nameOf);

TEST_P(EveryCurve, HasTheDerivativesThatDifferencesShow) {
  const Curve& curve = GetParam().curve;
  const double length = parameterLength(curve);
  const double h = length * 1e-4;
  for (const double lambda : {0.2 * length, 0.5 * length, 0.93 * length}) {
    const Evaluation e = evaluate(curve, lambda);
    const Point before = pointAt(curve, lambda - h);
    const Point after = pointAt(curve, lambda + h);
    EXPECT_LT((e.first - (after - before) / (2 * h)).norm(), 1e-7 + 1e-12 / h); // points have 13 digits
    const Vector second = (evaluate(curve, lambda + h).first - evaluate(curve, lambda - h).first) / (2 * h);
    EXPECT_LT((e.second - second).norm(), 1e-7 * (1 + e.second.norm()));
  }
}

TEST_P(EveryCurve, BeginsAndEndsWhereItSaysAndInThatDirection) {
  const Curve& curve = GetParam().curve;
  const double length = parameterLength(curve);
  EXPECT_LT((startPoint(curve) - pointAt(curve, 0)).norm(), 1e-12);
  EXPECT_LT((endPoint(curve) - pointAt(curve, length)).norm(), 1e-12);
  EXPECT_LT((startTangent(curve) - evaluate(curve, 0).first).norm(), 1e-12);
  EXPECT_LT((endTangent(curve) - evaluate(curve, length).first).norm(), 1e-12);
}

TEST_P(EveryCurve, IsAsLongAsItsChordsTogether) {
  const Curve& curve = GetParam().curve;
  const std::vector<Point> points = samples(curve, 20000);
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    sum += (points[i] - points[i - 1]).norm();
  }
  EXPECT_NEAR(arcLength(curve), sum, 1e-6 * sum);
  EXPECT_NEAR(arcLength(curve, parameterLength(curve) / 2) + arcLength(reversed(curve), parameterLength(curve) / 2),
              arcLength(curve), 1e-9);
}

TEST_P(EveryCurve, ReversedHasTheSamePointsTheOtherWay) {
  const Curve& curve = GetParam().curve;
  const Curve back = reversed(curve);
  const double length = parameterLength(curve);
  ASSERT_NEAR(parameterLength(back), length, 1e-12 * length);
  for (int i = 0; i <= 10; ++i) {
    const double lambda = length * i / 10;
    EXPECT_LT((pointAt(back, length - lambda) - pointAt(curve, lambda)).norm(), 1e-10);
  }
  EXPECT_LT((startTangent(back) + endTangent(curve)).norm(), 1e-12);
}

TEST_P(EveryCurve, MovesRigidlyUnderRotationMirrorAndShift) {
  const Curve& curve = GetParam().curve;
  Eigen::Isometry2d turned = Eigen::Isometry2d::Identity();
  turned.rotate(Eigen::Rotation2Dd(0.7)).pretranslate(Vector(-20, 5));
  Eigen::Isometry2d mirrored = turned;
  mirrored.linear() = mirrored.linear() * Eigen::Vector2d(-1, 1).asDiagonal();
  for (const Eigen::Isometry2d& motion : {turned, mirrored}) {
    const Curve moved = transformed(curve, motion);
    const double length = parameterLength(curve);
    ASSERT_NEAR(parameterLength(moved), length, 1e-12 * (1 + length));
    for (int i = 0; i <= 10; ++i) {
      EXPECT_LT((pointAt(moved, length * i / 10) - motion * pointAt(curve, length * i / 10)).norm(), 1e-10);
    }
  }
}

TEST_P(EveryCurve, HasTheTightestBox) {
  const Curve& curve = GetParam().curve;
  const Box box = bounds(curve);
  Box sampled;
  for (const Point& p : samples(curve, 20000)) {
    sampled.extend(p);
  }
  const double step = parameterLength(curve) / 20000;
  EXPECT_LT((box.min() - sampled.min()).cwiseAbs().maxCoeff(), 1e-12 + step * step); // a vertex lies between samples
  EXPECT_LT((box.max() - sampled.max()).cwiseAbs().maxCoeff(), 1e-12 + step * step);
  EXPECT_TRUE(Box(box.min() - Vector(1e-12, 1e-12), box.max() + Vector(1e-12, 1e-12)).contains(sampled));
}

TEST_P(LineOrArc, PartsAreTheCurveBetweenTheirEnds) {
  const Curve& curve = GetParam().curve;
  const double length = parameterLength(curve);
  const Curve middle = part(curve, 0.2 * length, 0.9 * length);
  ASSERT_NEAR(parameterLength(middle), 0.7 * length, 1e-12 * (1 + length));
  for (int i = 0; i <= 10; ++i) {
    const double lambda = 0.7 * length * i / 10;
    EXPECT_LT((pointAt(middle, lambda) - pointAt(curve, 0.2 * length + lambda)).norm(), 1e-10);
  }
}

TEST_P(LineOrArc, OffsetLiesAtItsDistanceOnTheLeft) {
  const Curve& curve = GetParam().curve;
  for (const double distance : {-2.0, 3.0}) {
    const Curve moved = offset(curve, distance);
    for (int i = 0; i <= 10; ++i) {
      const Evaluation e = evaluate(curve, parameterLength(curve) * i / 10);
      const Point expected = e.point + distance * leftOf(e.first);
      EXPECT_LT((pointAt(moved, parameterLength(moved) * i / 10) - expected).norm(), 1e-9);
    }
  }
}

TEST_P(LineOrArc, NearestPointIsTheNearestOfManySamples) {
  const Curve& curve = GetParam().curve;
  const std::vector<Point> points = samples(curve, 20000);
  const double step = parameterLength(curve) / 20000;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-60, 60);
  for (int i = 0; i < 40; ++i) {
    const Point p = startPoint(curve) + Vector(place(random), place(random));
    const Nearest found = nearest(curve, p);
    EXPECT_NEAR((pointAt(curve, found.lambda) - p).norm(), found.distance, 1e-9);
    const double sampled = sampledDistance(points, p);
    EXPECT_LE(found.distance, sampled + 1e-9);
    EXPECT_GE(found.distance, sampled - step); // half a step beside a sample is at most that much nearer
  }
}

TEST_P(LineOrArc, APointOnTheCurveIsFoundThere) {
  const Curve& curve = GetParam().curve;
  for (int i = 1; i < 20; ++i) {
    const double lambda = parameterLength(curve) * i / 20;
    const Nearest found = nearest(curve, pointAt(curve, lambda));
    EXPECT_NEAR(found.lambda, lambda, 1e-9 * (1 + parameterLength(curve)));
    EXPECT_LT(found.distance, 1e-11);
  }
}

TEST(CurveDistance, IsTheSmallestBetweenSamplesOfBoth) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-40, 40);
  std::uniform_real_distribution<double> angle(0.05, 5.5);
  std::uniform_real_distribution<double> radius(3, 30);
  const auto randomCurve = [&]() -> Curve {
    const Point p(place(random), place(random));
    if (random() % 2 == 0) {
      return Line{p, p + Vector(place(random), place(random))};
    }
    return arcAbout(p, radius(random), angle(random), random() % 2 == 0 ? angle(random) : -angle(random));
  };
  constexpr double kFar = 1e9;
  for (int i = 0; i < 150; ++i) {
    const Curve a = randomCurve();
    const Curve b = randomCurve();
    double sampled = std::numeric_limits<double>::infinity();
    for (const Point& p : samples(a, 1000)) {
      sampled = std::min(sampled, nearest(b, p).distance);
    }
    const double found = distance(a, b, kFar);
    EXPECT_LE(found, sampled + 1e-9) << i;
    EXPECT_GE(found, sampled - parameterLength(a) / 2000 - 1e-9) << i;
    EXPECT_NEAR(found, distance(b, a, kFar), 1e-9) << i;
  }
}

TEST(CurveDistance, OfParallelAndConcentricCurvesIsTheirOffset) {
  EXPECT_NEAR(distance(Line{{0, 0}, {10, 0}}, Line{{3, 2}, {7, 2}}, 100), 2, 1e-12);
  EXPECT_NEAR(distance(arcAbout({1, 1}, 5, 0, 2), arcAbout({1, 1}, 9, 1, 2), 100), 4, 1e-12);
  EXPECT_NEAR(distance(arcAbout({0, 0}, 5, 0, 1), arcAbout({0, 0}, 5, 2, 1), 100), 2 * 5 * std::sin(0.5), 1e-12);
}

TEST(CurveDistance, BetweenATransitionAndALineIsThatOfManySamples) {
  const Curve blend = transition(60, 100);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-150, 150);
  for (int i = 0; i < 12; ++i) {
    const Curve other = i % 2 == 0 ? Curve(Line{{place(random), place(random)}, {place(random), place(random)}})
                                   : Curve(arcAbout({place(random), place(random)}, 40, place(random), 2.5));
    double sampled = std::numeric_limits<double>::infinity();
    for (const Point& p : samples(blend, 5000)) {
      sampled = std::min(sampled, nearest(other, p).distance);
    }
    const double found = distance(blend, other, 1e9);
    EXPECT_NEAR(found, sampled, 200.0 / 5000 / 2) << i; // half a step of the samples
    EXPECT_LE(found, sampled + 2e-6) << i;
  }
}

// Legs of 129.9038 mm at 60°: the wheel of 75 mm at a corner of the 600 mm triangle. Its length is the figure of the
// method, and that of a numerical integration of |q'|.
TEST(ParabolaLength, OfTheSixtyDegreeTransitionIsKnown) {
  const Parabola blend = transition(60, 75 / std::tan(radians(30)));
  EXPECT_NEAR(arcLength(blend), 179.28973, 5e-6);

  constexpr int kSteps = 100000; // Simpson
  const double length = parameterLength(blend);
  double sum = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double weight = i == 0 || i == kSteps ? 1 : i % 2 == 1 ? 4 : 2;
    sum += weight * evaluate(blend, length * i / kSteps).first.norm();
  }
  EXPECT_NEAR(arcLength(blend), sum * length / kSteps / 3, 1e-9);
}

TEST(ParabolaLength, OfAStraightOneIsItsLegs) {
  EXPECT_NEAR(arcLength(Parabola{{0, 0}, {3, 0}, {6, 0}}), 6, 1e-12);
}

TEST(Arc, BetweenTwoPointsSweepsWhatWasAskedFor) {
  for (const double sweep : {1e-9, 0.5, kPi, 4.0, 6.2, -1e-9, -2.0, -5.0}) {
    const Arc arc = arcBetween({1, 2}, {4, 6}, sweep);
    EXPECT_LT((endPoint(arc) - Point(4, 6)).norm(), 1e-12) << sweep;
    EXPECT_NEAR(arc.sweep(), sweep, 1e-12) << sweep;
    EXPECT_NEAR(arc.radius(), 2.5 / std::abs(std::sin(sweep / 2)), 1e-9 * arc.radius()) << sweep;
  }
}

TEST(Arc, OfAHugeRadiusKeepsItsDigits) {
  constexpr double kRadius = 1e9;
  const Arc arc{{100, 200}, {1, 0}, 1 / kRadius, 50};
  const Point end = endPoint(arc);
  EXPECT_NEAR(end.x(), 150, 1e-13 * 150);
  EXPECT_NEAR(end.y() - 200, 50 * 50 / (2 * kRadius), 1e-13 * 200); // the sagitta of a parabola
  EXPECT_NEAR(nearest(arc, {125, 210}).distance, 10 - 25 * 25 / (2 * kRadius), 1e-12);
  EXPECT_NEAR(turn(arc.tangent, endTangent(arc)), 50 / kRadius, 1e-22);
  EXPECT_LT((endPoint(reversed(arc)) - arc.start).norm(), 1e-12);
  const Arc moved = std::get<Arc>(offset(arc, -75));
  EXPECT_NEAR(moved.length, 50 + 75 * 50 / kRadius, 1e-12);
}

TEST(Arc, AboutACentreGoesThroughTheExpectedPoints) {
  const Arc arc = arcAbout({1, 2}, 5, kPi / 2, -kPi / 2);
  EXPECT_LT((arc.start - Point(1, 7)).norm(), 1e-12);
  EXPECT_LT((endPoint(arc) - Point(6, 2)).norm(), 1e-12);
  EXPECT_LT((arc.center() - Point(1, 2)).norm(), 1e-12);
  EXPECT_LT(arc.curvature, 0);
}

TEST(Turn, IsExactForTheSmallestAngles) {
  EXPECT_DOUBLE_EQ(turn({1, 0}, {1, 1e-300}), 1e-300);
  EXPECT_DOUBLE_EQ(turn({1, 0}, {0, -2}), -kPi / 2);
  EXPECT_DOUBLE_EQ(turn({1, 0}, {-1, 0}), kPi);
}

TEST(Area, OfACircleAndOfAStadiumIsTheClosedForm) {
  EXPECT_NEAR(signedArea({arcAbout({5, -3}, 2, 1, 2 * kPi)}), 4 * kPi, 1e-12);
  EXPECT_NEAR(signedArea({arcAbout({5, -3}, 2, 1, -2 * kPi)}), -4 * kPi, 1e-12);
  const std::vector<Curve> stadium{Line{{0, 0}, {10, 0}}, arcAbout({10, 3}, 3, -kPi / 2, kPi), Line{{10, 6}, {0, 6}},
                                   arcAbout({0, 3}, 3, kPi / 2, kPi)};
  EXPECT_NEAR(signedArea(stadium), 60 + 9 * kPi, 1e-12);
  EXPECT_NEAR(totalLength(stadium), 20 + 6 * kPi, 1e-12);
  EXPECT_NEAR(bounds(stadium).max().x(), 13, 1e-12);
  EXPECT_NEAR(bounds(stadium).min().x(), -3, 1e-12);
}

TEST(Area, OfAnAllButStraightArcDoesNotDrownInItsRadius) {
  // Segment between the chord of 100 mm and an arc of radius 1e6 mm: chord³/(12 R).
  const std::vector<Curve> segment{arcBetween({0, 0}, {100, 0}, 1e-4), Line{{100, 0}, {0, 0}}};
  EXPECT_NEAR(signedArea(segment), 1e6 / (12 * 1e6), 1e-6);
}

} // namespace
} // namespace arris::geometry
