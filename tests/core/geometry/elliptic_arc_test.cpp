#include "core/base/numbers.h"
#include "core/geometry/elliptic_arc.h"
#include "tests/support/spline_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace arris::geometry {
namespace {

using base::kPi;

EllipticArc ellipse(const Point& center, double a, double b, double rotation, double start = 0,
                    double sweep = 2 * kPi) {
  Eigen::AffineCompact2d map = Eigen::AffineCompact2d::Identity();
  map.translate(center);
  map.rotate(Eigen::Rotation2Dd(rotation));
  map.scale(Vector(a, b));
  return {arcAbout(Point::Zero(), 1, start, sweep), map};
}

std::vector<Curve> fitted(const EllipticArc& arc) {
  ArcFitter fitter(kFitTolerance, 100000);
  EXPECT_TRUE(follow(arc, fitter));
  return fitter.takeChain();
}

TEST(EllipticArc, HasTheAreaAndTheLengthOfTheEllipse) {
  const std::vector<Curve> chain = fitted(ellipse({300, -200}, 100, 60, 0.7));
  EXPECT_NEAR(signedArea(chain), kPi * 6000, 510 * kFitTolerance);
  const double eccentricity = 0.8; // √(1 − 0.6²)
  EXPECT_NEAR(totalLength(chain), 4 * 100 * std::comp_ellint_2(eccentricity), 1e-3);
  EXPECT_LT((endPoint(chain.back()) - startPoint(chain.front())).norm(), 1e-12);
  EXPECT_LT(std::abs(turn(endTangent(chain.back()), startTangent(chain.front()))), 1e-13);
}

TEST(EllipticArc, IsFollowedWithinTheToleranceByTangentialArcs) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < 30; ++round) {
    const double a = std::pow(10, 4 * unit(random));
    const double start = 6 * unit(random);
    const double sweep = (round % 2 == 0 ? 1 : -1) * (0.1 + 6 * unit(random));
    const EllipticArc arc =
        ellipse({1000 * unit(random), 50}, a, a * (0.02 + unit(random)), 7 * unit(random), start, sweep);
    const std::vector<Curve> chain = fitted(arc);
    const auto point = [&](double t) -> Point { return arc.map * Point(std::cos(t), std::sin(t)); };
    const double low = std::min(start, start + sweep);
    const test::Apart apart = test::apart(point, low, low + std::abs(sweep), chain);
    EXPECT_LE(apart.curveFromChain, kFitTolerance) << round;
    EXPECT_LE(apart.chainFromCurve, kFitTolerance) << round;
    EXPECT_LT(test::jointsOf(chain).turn, 1e-11) << round;
    EXPECT_LT((startPoint(chain.front()) - point(start)).norm(), 1e-9) << round;
    EXPECT_LT((endPoint(chain.back()) - point(start + sweep)).norm(), 1e-9) << round;
  }
}

TEST(EllipticArc, IsTheSameArcUnderAnEvenMap) {
  Eigen::AffineCompact2d map = Eigen::AffineCompact2d::Identity();
  map.translate(Vector(10, 20));
  map.scale(Vector(-3, 3));
  map.rotate(Eigen::Rotation2Dd(0.4));
  const Arc arc = arcAbout({5, 6}, 7, 0.2, 1.1);
  const std::optional<Arc> circular = asCircular({arc, map});
  ASSERT_TRUE(circular);
  EXPECT_NEAR(circular->sweep(), -1.1, 1e-12);
  EXPECT_NEAR(circular->radius(), 21, 1e-12);
  for (const double share : {0.0, 0.3, 1.0}) {
    const Point expected = map * pointAt(arc, share * arc.length);
    EXPECT_LT((pointAt(*circular, share * circular->length) - expected).norm(), 1e-12);
  }
  map.scale(Vector(1, 1.000001));
  EXPECT_FALSE(asCircular({arc, map}));
}

TEST(EllipticArc, ThinAsAHairKeepsItsTips) {
  const std::vector<Curve> chain = fitted(ellipse({0, 0}, 100, 1e-5, 0));
  EXPECT_NEAR(bounds(chain).max().x(), 100, kFitTolerance);
  EXPECT_NEAR(bounds(chain).min().x(), -100, kFitTolerance);
  EXPECT_LT(chain.size(), 120U);
}

} // namespace
} // namespace arris::geometry
