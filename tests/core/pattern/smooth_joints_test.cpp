#include "core/base/numbers.h"
#include "core/base/tolerances.h"
#include "core/pattern/smooth_joints.h"
#include "tests/support/contours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace arris::pattern {
namespace {

using base::kPi;
using geometry::Arc;
using geometry::Curve;
using geometry::Line;
using geometry::Point;
using geometry::Vector;

/// Joints are tangential to this after smoothing, rad; lines near the origin keep their direction to it.
constexpr double kTangent = 1e-10;

/// A curve of the given curvature and length from `start` in the direction `heading`.
Curve leg(const Point& start, double heading, double curvature, double length) {
  const Vector tangent(std::cos(heading), std::sin(heading));
  return curvature == 0 ? Curve(Line{start, start + length * tangent}) : Curve(Arc{start, tangent, curvature, length});
}

/// Two legs that meet in the origin with a turn, closed by lines far away at right angles.
std::vector<Curve> kinked(double turn, double before, double lengthBefore, double after, double lengthAfter) {
  const Curve first = geometry::reversed(leg({0, 0}, kPi, -before, lengthBefore));
  const Curve second = leg({0, 0}, turn, after, lengthAfter);
  const Point end = geometry::endPoint(second);
  const Point start = geometry::startPoint(first);
  const Point above = end + 500 * geometry::leftOf(geometry::endTangent(second));
  const Point left = start + 500 * geometry::leftOf(geometry::startTangent(first));
  return {first, second, Line{end, above}, Line{above, left}, Line{left, start}};
}

struct Kink {
  double turn, before, lengthBefore, after, lengthAfter;
};

void expectSmooth(const Kink& k) {
  SCOPED_TRACE(testing::Message() << "kinked(" << k.turn << ", " << k.before << ", " << k.lengthBefore << ", "
                                  << k.after << ", " << k.lengthAfter << ")");
  const std::vector<Curve> drawn = kinked(k.turn, k.before, k.lengthBefore, k.after, k.lengthAfter);
  std::vector<Curve> chain = drawn;
  const double deviation = smoothJoints(chain);
  EXPECT_LE(deviation, base::kSmoothDeviation);
  EXPECT_TRUE(test::isWellJoined(chain, kTangent));
  EXPECT_LT(test::farthest(drawn, chain), deviation + 1e-9);
  EXPECT_LT(test::farthest(chain, drawn), base::kSmoothDeviation);
  EXPECT_NEAR(geometry::totalLength(chain), geometry::totalLength(drawn), 1e-5 * geometry::totalLength(drawn));
}

TEST(SmoothJoints, MakesEveryKindOfRoundingTangential) {
  std::mt19937_64 random(99);
  const auto between = [&](double least, double most) {
    return least + (most - least) * static_cast<double>(random() >> 11U) * 0x1p-53;
  };
  const auto curvature = [&]() {
    const double radius = std::exp(between(std::log(0.5), std::log(1e5)));
    return random() % 3 == 0 ? 0 : (random() % 2 == 0 ? 1 : -1) / radius;
  };
  const auto length = [&](double k) {
    return std::min(std::exp(between(std::log(0.05), std::log(300))), k == 0 ? 1e9 : 4 / std::abs(k));
  };
  for (int i = 0; i < 1000; ++i) {
    const double turn = std::exp(between(std::log(2e-11), std::log(3.4e-3))) * (random() % 2 == 0 ? 1 : -1);
    const double before = curvature();
    const double after = curvature();
    expectSmooth({turn, before, length(before), after, length(after)});
  }
}

TEST(SmoothJoints, TakesAsLongAnArcAsTheDeviationAllows) {
  std::vector<Curve> chain = kinked(1e-3, 0, 1000, 0, 1000);
  const double deviation = smoothJoints(chain);
  ASSERT_EQ(chain.size(), 6U) << "one arc between the two lines";
  const Arc& arc = std::get<Arc>(chain[1]);
  EXPECT_NEAR(arc.sweep(), 1e-3, 1e-15);
  EXPECT_GT(deviation, 0.9 * base::kSmoothDeviation);
  EXPECT_NEAR(deviation, arc.length / 2 * 1e-3 / 4, 1e-9) << "an arc passes its corner at a quarter of cut times turn";
}

TEST(SmoothJoints, KeepsRadiiWithinReason) {
  std::vector<Curve> chain = kinked(1e-7, 0, 1000, 0, 1000);
  (void)smoothJoints(chain);
  ASSERT_EQ(chain.size(), 6U);
  EXPECT_NEAR(std::get<Arc>(chain[1]).radius(), 1e6, 1);
}

TEST(SmoothJoints, LeavesCornersAndTangentsAlone) {
  for (const double turn : {0.0, 0.9e-11, 3.6e-3, 0.1, 2.0, -2.0}) {
    const std::vector<Curve> drawn = kinked(turn, 0, 100, 0.02, 30);
    std::vector<Curve> chain = drawn;
    EXPECT_EQ(smoothJoints(chain), 0) << turn;
    EXPECT_TRUE(test::areSame(chain, drawn, 0)) << turn;
  }
}

// 2,000 chords of a circle of radius 400 mm, equally long: half of each goes to the arc at either end.
TEST(SmoothJoints, ChordsOfACircleBecomeArcsOfThatCircle) {
  std::vector<Curve> chain;
  constexpr int kCount = 2000;
  const auto corner = [](int i) {
    return Point(400 * std::cos(2 * kPi * i / kCount), 400 * std::sin(2 * kPi * i / kCount));
  };
  for (int i = 0; i < kCount; ++i) {
    chain.emplace_back(Line{corner(i), corner((i + 1) % kCount)});
  }
  const double deviation = smoothJoints(chain);
  EXPECT_LE(deviation, base::kSmoothDeviation);
  ASSERT_EQ(chain.size(), static_cast<std::size_t>(kCount)) << "nothing is left of the lines";
  for (const Curve& curve : chain) {
    EXPECT_NEAR(std::get<Arc>(curve).radius(), 400 * std::cos(kPi / kCount), 1e-6);
  }
  EXPECT_TRUE(test::isWellJoined(chain, 1e-12));
}

} // namespace
} // namespace arris::pattern
