#include "core/geometry/meetings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace arris::geometry {
namespace {

/// An arc that passes through (0, `height`) in the middle, where it runs along X.
Arc archAt(double height, double radius) {
  const double half = 50;
  const Arc right{{0, height}, {1, 0}, 1 / radius, half};
  const Evaluation end = evaluate(right, half);
  return {{-end.point.x(), end.point.y()}, {end.first.x(), -end.first.y()}, 1 / radius, 2 * half};
}

TEST(Meetings, WithAnArcOfAnyRadiusAreExact) {
  for (const double radius : {1e2, 1e4, 1e6, 1e9, 1e12, 1e15}) {
    for (const double beside : {-75.0, 0.0, 75.0}) {
      const Arc arc = archAt(3, radius);
      const Track track(Line{{0.5, -200}, {0.5, 200}});
      const Track::Meetings meetings = track.meetBeside(arc, beside);
      double nearest = 1e300;
      for (std::size_t i = 0; i < meetings.count; ++i) {
        const double r = radius - beside;
        const double expected = 3 + beside + 0.25 / (r + std::sqrt(r * r - 0.25));
        nearest = std::min(nearest, std::abs(track.at(meetings.s[i]).y() - expected));
      }
      EXPECT_LT(nearest, 1e-6 / radius + 1e-12) << radius << " " << beside;
    }
  }
}

TEST(Meetings, BesideAnArcGoPastItsCentre) {
  const Arc arc = arcAbout({0, 0}, 5, 0, 1);
  const Track::Meetings meetings = Track(Line{{0, 0}, {100, 0}}).meetBeside(arc, 25); // a circle of radius 20
  ASSERT_EQ(meetings.count, 2u);
  EXPECT_NEAR(std::abs(meetings.s[0] - meetings.s[1]), 40, 1e-9);
}

TEST(Distance, OfCurvesThatCrossIsNoneHoweverFlatTheyAre) {
  for (const double radius : {1e2, 1e4, 1e6, 1e9, 1e12, 1e14, 1e16}) {
    const Arc arch = archAt(3, radius);
    EXPECT_LT(distance(arch, Line{{0.5, -200}, {0.7, 200}}, 0.001), 1e-9) << radius;
    for (const double other : {1e2, 1e6, 1e12, 1e16}) {
      const Arc across{{1, -60}, {0, 1}, 1 / other, 120};
      EXPECT_LT(distance(arch, across, 0.001), 1e-9) << radius << " " << other;
      EXPECT_LT(distance(across, arch, 0.001), 1e-9) << radius << " " << other;
    }
  }
}

} // namespace
} // namespace arris::geometry
