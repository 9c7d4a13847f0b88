#include "core/base/numbers.h"
#include "core/geometry/spline.h"
#include "tests/support/spline_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace arris::geometry {
namespace {

using base::kPi;

std::vector<Curve> fitted(const std::vector<Bezier>& pieces) {
  ArcFitter fitter(kFitTolerance, 1000000);
  EXPECT_TRUE(follow(pieces, fitter));
  return fitter.takeChain();
}

std::vector<Curve> fitted(const Spline& spline) {
  EXPECT_EQ(flawOf(spline), "");
  return fitted(bezierPieces(spline));
}

/// Where the chain turns by more than half a degree.
std::vector<Point> cornersOf(const std::vector<Curve>& chain) {
  std::vector<Point> corners;
  for (std::size_t i = 1; i < chain.size(); ++i) {
    if (std::abs(turn(endTangent(chain[i - 1]), startTangent(chain[i]))) > 0.01) {
      corners.push_back(startPoint(chain[i]));
    }
  }
  return corners;
}

TEST(Spline, OfAnyKindIsFollowedWithinTheToleranceBothWays) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Spline spline = test::randomSpline(seed);
    const std::vector<Curve> chain = fitted(spline);
    const double from = spline.knots[static_cast<std::size_t>(spline.degree)];
    const double to = spline.knots[spline.points.size()];
    const test::Apart apart =
        test::apart([&](double u) { return test::basisPoint(spline, u); }, from, std::nextafter(to, from), chain);
    EXPECT_LE(apart.curveFromChain, kFitTolerance) << seed;
    EXPECT_LE(apart.chainFromCurve, kFitTolerance) << seed;
    EXPECT_LT(test::jointsOf(chain).gap, 1e-11) << seed;
  }
}

TEST(Spline, WithSimpleKnotsHasTangentialJoints) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Spline spline = test::randomSpline(seed);
    if (spline.degree < 2) {
      continue;
    }
    for (std::size_t i = 0; i < spline.knots.size(); ++i) {
      spline.knots[i] = static_cast<double>(i);
    }
    EXPECT_LT(test::jointsOf(fitted(spline)).turn, 1e-11) << seed;
  }
}

TEST(Spline, TurnedRoundGivesTheSameChainTurnedRound) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Spline spline = test::randomSpline(seed);
    Spline back = spline;
    std::reverse(back.points.begin(), back.points.end());
    std::reverse(back.weights.begin(), back.weights.end());
    std::reverse(back.knots.begin(), back.knots.end());
    std::transform(back.knots.begin(), back.knots.end(), back.knots.begin(), std::negate<>());
    const std::vector<Curve> chain = fitted(spline);
    const std::vector<Curve> other = fitted(back);
    ASSERT_EQ(chain.size(), other.size()) << seed;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      EXPECT_LT((startPoint(chain[i]) - endPoint(other[chain.size() - 1 - i])).norm(), 1e-6) << seed;
    }
  }
}

TEST(Spline, ThatIsACircleBecomesItsArcs) {
  for (const int pieces : {3, 4}) { // 7 and 9 control points
    const std::vector<Curve> chain = fitted(test::circleAsSpline({500, 300}, 80, pieces));
    EXPECT_NEAR(signedArea(chain), kPi * 6400, 1e-6) << pieces;
    for (const Curve& curve : chain) {
      EXPECT_NEAR(std::get<Arc>(curve).radius(), 80, 1e-6) << pieces;
    }
  }
}

// Half a circle of degree 3 in four control points: its weights are 1, ⅓, ⅓, 1.
TEST(Spline, OfFourPointsThatIsHalfACircleBecomesItsArcs) {
  Spline spline;
  spline.points = {{80, 0}, {80, 160}, {-80, 160}, {-80, 0}};
  spline.weights = {1, 1.0 / 3, 1.0 / 3, 1};
  spline.knots = {0, 0, 0, 0, 1, 1, 1, 1};
  for (const Curve& curve : fitted(spline)) {
    EXPECT_NEAR(std::get<Arc>(curve).radius(), 80, 1e-3);
    EXPECT_LT(std::abs(pointAt(curve, parameterLength(curve) / 2).norm() - 80), kFitTolerance);
  }
}

TEST(Spline, KeepsTheCornersOfItsRepeatedKnots) {
  Spline spline;
  spline.points = {{0, 0}, {30, 40}, {70, 40}, {100, 0}, {100, -30}, {60, -50}, {0, -50}};
  spline.knots = {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2};
  EXPECT_THAT(cornersOf(fitted(spline)), testing::ElementsAre(Point(100, 0)));
}

TEST(Spline, OfDegreeOneIsItsPolygon) {
  Spline spline;
  spline.degree = 1;
  spline.points = {{0, 0}, {30, 0}, {30, 40}, {0, 0}};
  spline.knots = {0, 0, 1, 2, 3, 3};
  const std::vector<Curve> chain = fitted(spline);
  ASSERT_GE(chain.size(), 3U);
  EXPECT_NEAR(totalLength(chain), 120, 1e-12);
  EXPECT_EQ(cornersOf(chain).size(), 2U);
  for (const Curve& curve : chain) {
    EXPECT_TRUE(std::holds_alternative<Line>(curve));
  }
}

// (3t² − 2t³, …) with a cusp in the middle where the direction turns back.
TEST(Spline, KeepsACuspAsACorner) {
  Spline spline;
  spline.points = {{0, 0}, {100, 100}, {0, 100}, {100, 0}};
  spline.knots = {0, 0, 0, 0, 1, 1, 1, 1};
  const std::vector<Curve> chain = fitted(spline);
  const std::vector<Point> corners = cornersOf(chain);
  ASSERT_EQ(corners.size(), 1U);
  EXPECT_LT((corners[0] - Point(50, 75)).norm(), kFitTolerance);
  EXPECT_LT(chain.size(), 200U);
}

TEST(Spline, WithDoubledPointsAtItsEndsHasADirectionThere) {
  Spline spline;
  spline.points = {{0, 0}, {0, 0}, {100, 50}, {100, 50}}; // as Inkscape writes lines
  spline.knots = {0, 0, 0, 0, 1, 1, 1, 1};
  const std::vector<Curve> chain = fitted(spline);
  EXPECT_NEAR(totalLength(chain), std::hypot(100, 50), 1e-9);
  EXPECT_LT(test::jointsOf(chain).turn, 1e-11);
}

TEST(Spline, HuggingItsControlPolygonIsFollowedRoundItsBend) {
  Spline spline;
  spline.degree = 2;
  spline.points = {{0, 0}, {100, 0}, {100, 100}};
  spline.weights = {1, 1e7, 1};
  spline.knots = {0, 0, 0, 1, 1, 1};
  const std::vector<Curve> chain = fitted(spline);
  EXPECT_NEAR(bounds(chain).max().x(), 100, kFitTolerance);
  EXPECT_NEAR(totalLength(chain), 200, 0.01);
  EXPECT_LT(chain.size(), 100U);
}

TEST(Spline, ThatNeedsMoreStepsThanAllowedIsGivenUp) {
  ArcFitter fitter(kFitTolerance, 10);
  EXPECT_FALSE(follow(bezierPieces(test::randomSpline(3)), fitter));
  EXPECT_LE(fitter.takeChain().size(), 20U);
}

TEST(Spline, WithAFlawIsRefusedInWords) {
  const Spline good = test::circleAsSpline({0, 0}, 10, 4);
  const auto flawWith = [&good](auto change) {
    Spline spline = good;
    change(spline);
    return flawOf(spline);
  };
  EXPECT_EQ(flawOf(good), "");
  EXPECT_EQ(flawWith([](Spline& s) { s.degree = 0; }), "its degree is 0; up to 25 are read");
  EXPECT_EQ(flawWith([](Spline& s) { s.degree = 26; }), "its degree is 26; up to 25 are read");
  EXPECT_EQ(flawWith([](Spline& s) { s.degree = 9; }), "it has 9 control points and needs 10");
  EXPECT_EQ(flawWith([](Spline& s) { s.knots.pop_back(); }), "it has 11 knots and needs 12");
  EXPECT_EQ(flawWith([](Spline& s) { s.knots[4] = 0.5; }), "its knots fall from 1 to 0.5");
  EXPECT_EQ(flawWith([](Spline& s) { s.knots.assign(12, 1); }), "its knots are all the same");
  EXPECT_EQ(flawWith([](Spline& s) { s.weights.pop_back(); }), "it has 8 weights and needs 9");
  EXPECT_EQ(flawWith([](Spline& s) { s.weights[2] = 0; }), "it has a weight of 0, which is not positive");
  EXPECT_EQ(flawWith([](Spline& s) { s.weights[2] = -1; }), "it has a weight of -1, which is not positive");
  EXPECT_EQ(flawWith([](Spline& s) { s.weights[2] = 1e12; }),
            "its weights reach from 0.7071067811865476 to 1000000000000");
}

/// Second derivative by the parameter (the length of the chords) at the end or start of a cubic piece over `chord`.
Vector second(const Bezier& piece, bool atEnd, double chord) {
  const std::size_t i = atEnd ? 1 : 0;
  const auto point = [&](std::size_t k) -> Point { return piece.points[k].hnormalized(); };
  return 6 * (point(i) - 2 * point(i + 1) + point(i + 2)) / (chord * chord);
}

Vector first(const Bezier& piece, bool atEnd, double chord) {
  const std::size_t i = atEnd ? 2 : 0;
  return 3 * (piece.points[i + 1].hnormalized() - piece.points[i].hnormalized()) / chord;
}

TEST(Interpolation, GoesThroughItsPointsWithContinuousCurvature) {
  for (const bool closed : {false, true}) {
    const std::vector<Point> points = test::randomSpline(17).points;
    const std::vector<Bezier> pieces = bezierPieces(Interpolation{points, {}, {}, closed});
    ASSERT_EQ(pieces.size(), points.size() - (closed ? 0 : 1));
    const auto chord = [&](std::size_t i) { return (points[(i + 1) % points.size()] - points[i]).norm(); };
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      EXPECT_EQ(Point(pieces[i].points.front().hnormalized()), points[i]);
      const std::size_t next = (i + 1) % pieces.size();
      if (!closed && next == 0) {
        continue;
      }
      EXPECT_LT((first(pieces[i], true, chord(i)) - first(pieces[next], false, chord(next))).norm(), 1e-12) << i;
      EXPECT_LT((second(pieces[i], true, chord(i)) - second(pieces[next], false, chord(next))).norm(), 1e-12) << i;
    }
    if (!closed) {
      EXPECT_LT(second(pieces.front(), false, chord(0)).norm(), 1e-12) << "no curvature at the start";
      EXPECT_LT(second(pieces.back(), true, chord(pieces.size() - 1)).norm(), 1e-12) << "none at the end";
    }
  }
}

TEST(Interpolation, LeavesAndArrivesInTheDirectionsGiven) {
  const std::vector<Bezier> pieces =
      bezierPieces(Interpolation{{{0, 0}, {50, 20}, {100, 0}}, Vector(0, 7), Vector(3, 0), false});
  EXPECT_LT(std::abs(turn(stationAt(pieces.front(), 0).tangent, Vector(0, 1))), 1e-12);
  EXPECT_LT(std::abs(turn(stationAt(pieces.back(), 1).tangent, Vector(1, 0))), 1e-12);
}

TEST(Interpolation, OfPointsOfACircleIsNearlyTheCircle) {
  std::vector<Point> points;
  for (int i = 0; i < 24; ++i) {
    points.emplace_back(100 * std::cos(i * kPi / 12), 100 * std::sin(i * kPi / 12));
  }
  points.push_back(points.front()); // the first once more is no further point
  EXPECT_NEAR(signedArea(fitted(bezierPieces(Interpolation{points, {}, {}, true}))), kPi * 1e4, 2);
}

TEST(Interpolation, OfOnePointIsNothing) {
  EXPECT_TRUE(bezierPieces(Interpolation{{{1, 2}, {1, 2}}, {}, {}, true}).empty());
}

} // namespace
} // namespace arris::geometry
