#include "core/base/numbers.h"
#include "core/geometry/biarc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace arris::geometry {
namespace {

Vector directionAt(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

TEST(Biarc, TouchesBothStationsAndItselfWhereverItLies) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-1, 1);
  for (int round = 0; round < 5000; ++round) {
    const double size = std::pow(10, 3 * place(random));
    const Point from = 1e5 * Point(place(random), place(random));
    const Vector way = size * directionAt(base::kPi * place(random));
    const double heading = std::atan2(way.y(), way.x());
    const Station start{from, directionAt(heading + 1.5 * place(random))};
    const Station end{from + way, directionAt(heading + 1.5 * place(random))};
    const Biarc biarc = biarcBetween(start, end);
    ASSERT_TRUE(biarc.second) << round;
    EXPECT_LT((startPoint(biarc.first) - start.point).norm(), 1e-9) << round;
    EXPECT_LT((endPoint(*biarc.second) - end.point).norm(), 1e-9) << round;
    EXPECT_LT((endPoint(biarc.first) - startPoint(*biarc.second)).norm(), 1e-9) << round;
    EXPECT_LT(std::abs(turn(startTangent(biarc.first), start.tangent)), 1e-13) << round;
    EXPECT_LT(std::abs(turn(endTangent(biarc.first), startTangent(*biarc.second))), 1e-13) << round;
    EXPECT_LT(std::abs(turn(endTangent(*biarc.second), end.tangent)), 1e-13) << round;
  }
}

TEST(Biarc, IsALineStraightAhead) {
  const Biarc biarc = biarcBetween({{3, 4}, {1, 0}}, {{13, 4}, {1, 0}});
  EXPECT_TRUE(std::holds_alternative<Line>(biarc.first));
  EXPECT_NEAR(parameterLength(biarc.first) + (biarc.second ? parameterLength(*biarc.second) : 0), 10, 1e-12);
}

TEST(Biarc, IsTheOneArcBetweenStationsOfACircle) {
  const Arc arc = arcAbout({100, 50}, 30, 0.3, -1.4);
  const Evaluation start = evaluate(arc, 0);
  const Evaluation end = evaluate(arc, arc.length);
  const Biarc biarc = biarcBetween({start.point, start.first}, {end.point, end.first});
  ASSERT_FALSE(biarc.second);
  EXPECT_NEAR(std::get<Arc>(biarc.first).curvature, arc.curvature, 1e-15);
  EXPECT_NEAR(std::get<Arc>(biarc.first).length, arc.length, 1e-12);
}

// Two all but straight arcs that bend against each other have no curvature together.
TEST(Biarc, OfAHairsBreadthIsFiniteWhateverItsBends) {
  for (const double turn : {1e-15, 1e-13, 3e-13, 1e-12, 1e-11, 1e-9}) {
    for (const double other : {turn, -turn, 0.0}) {
      const Biarc biarc = biarcBetween({{0, 0}, directionAt(turn)}, {{5e-3, 0}, directionAt(other)});
      EXPECT_LT((endPoint(biarc.second.value_or(biarc.first)) - Point(5e-3, 0)).norm(), 1e-15) << turn << ' ' << other;
    }
  }
}

} // namespace
} // namespace arris::geometry
