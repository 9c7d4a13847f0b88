#include "core/base/numbers.h"
#include "core/geometry/parabola_arcs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace arris::geometry {
namespace {

struct Blend {
  double beta;   ///< degrees
  double radius; ///< of the wheel, mm
  double heading;
};

void PrintTo(const Blend& row, std::ostream* stream) {
  *stream << "beta " << row.beta << " radius " << row.radius << " heading " << row.heading;
}

Parabola transition(const Blend& row) {
  const double leg = row.radius / std::tan(base::radians(row.beta) / 2);
  const double before = base::radians(row.heading);
  const double after = before - (base::kPi - base::radians(row.beta));
  const Point a(700, 1200);
  const Point q = a + leg * Vector(std::cos(before), std::sin(before));
  return {a, q, q + leg * Vector(std::cos(after), std::sin(after))};
}

Point onParabola(const Parabola& p, double u) {
  return (1 - u) * (1 - u) * p.a + 2 * u * (1 - u) * p.q + u * u * p.c;
}

// By golden sections between the neighbours of the nearest of many points.
double distanceToParabola(const Parabola& p, const Point& point) {
  constexpr int kPoints = 40;
  int best = 0;
  const auto distanceAt = [&](double u) { return (onParabola(p, u) - point).norm(); };
  for (int i = 1; i <= kPoints; ++i) {
    best = distanceAt(double(i) / kPoints) < distanceAt(double(best) / kPoints) ? i : best;
  }
  double from = std::max(0.0, double(best - 1) / kPoints);
  double to = std::min(1.0, double(best + 1) / kPoints);
  for (int i = 0; i < 60; ++i) {
    const double third = (to - from) / 3;
    if (distanceAt(from + third) < distanceAt(to - third)) {
      to -= third;
    } else {
      from += third;
    }
  }
  return distanceAt((from + to) / 2);
}

class ParabolaArcs : public testing::TestWithParam<Blend> {};

TEST_P(ParabolaArcs, ArcsStayWithinTheToleranceAndAreTangentialEverywhere) {
  const Parabola parabola = transition(GetParam());
  for (const double tolerance : {5e-4, 0.05}) {
    const std::vector<Arc> arcs = arcsAlong(parabola, tolerance);
    ASSERT_FALSE(arcs.empty());
    Point at = parabola.a;
    Vector direction = (parabola.q - parabola.a).normalized();
    double largest = 0;
    for (const Arc& arc : arcs) {
      EXPECT_GT(arc.length, 0);
      EXPECT_LT((arc.start - at).norm(), 1e-9);
      EXPECT_LT((arc.tangent - direction).norm(), 1e-9);
      for (int i = 0; i <= 4; ++i) {
        largest = std::max(largest, distanceToParabola(parabola, pointAt(arc, arc.length * i / 4)));
      }
      at = endPoint(arc);
      direction = endTangent(arc);
    }
    EXPECT_LT((at - parabola.c).norm(), 1e-9);
    EXPECT_LT((direction - (parabola.c - parabola.q).normalized()).norm(), 1e-9);
    EXPECT_LT(largest, tolerance);
    EXPECT_LT(arcs.size(), 400u);
  }
}

TEST_P(ParabolaArcs, ChordsStayWithinTheTolerance) {
  const Parabola parabola = transition(GetParam());
  const std::vector<Point> points = chordsAlong(parabola, 5e-4);
  EXPECT_EQ(points.front(), parabola.a);
  EXPECT_EQ(points.back(), parabola.c);
  for (std::size_t i = 1; i < points.size(); i += 1 + points.size() / 100) {
    ASSERT_LT(distanceToParabola(parabola, points[i]), 1e-6);
    ASSERT_LT(distanceToParabola(parabola, (points[i - 1] + points[i]) / 2), 5e-4);
  }
}

INSTANTIATE_TEST_SUITE_P(Angles, ParabolaArcs,
                         testing::Values(Blend{60, 75, 0}, Blend{60, 75, 37}, Blend{90, 75, 90}, Blend{140, 75, -15},
                                         Blend{10, 75, 0}, Blend{2, 75, 200}, Blend{60, 0.5, 10}, Blend{170, 0.5, 10},
                                         Blend{30, 500, 45}, Blend{179, 500, 0}));

TEST(ParabolaArcs, ThePapersCornerTakesFewArcs) {
  EXPECT_LE(arcsAlong(transition({60, 75, 0}), 5e-4).size(), 50u);
}

} // namespace
} // namespace arris::geometry
