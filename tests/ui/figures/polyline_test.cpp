#include "ui/figures/polyline.h"

#include <QLineF>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace arris::ui {
namespace {

double distanceToSegment(const QPointF& p, const QPointF& a, const QPointF& b) {
  const QPointF way = b - a;
  const double square = QPointF::dotProduct(way, way);
  const double share = square > 0 ? std::clamp(QPointF::dotProduct(p - a, way) / square, 0.0, 1.0) : 0;
  return QLineF(p, a + share * way).length();
}

// Distance from a point to the nearest place of a polyline.
double distanceTo(const QPolygonF& line, const QPointF& p) {
  double best = std::numeric_limits<double>::infinity();
  for (qsizetype i = 1; i < line.size(); ++i) {
    best = std::min(best, distanceToSegment(p, line[i - 1], line[i]));
  }
  return best;
}

QPolygonF randomWalk(unsigned seed, int points) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> turn(-0.6, 0.6);
  std::uniform_real_distribution<double> step(0.01, 3);
  QPolygonF walk{{0, 0}};
  double heading = 0;
  for (int i = 0; i < points; ++i) {
    heading += i % 50 == 0 ? 3.0 : turn(random); // now and then it all but turns back
    const double length = step(random);
    walk.append(walk.back() + length * QPointF(std::cos(heading), std::sin(heading)));
  }
  return walk;
}

TEST(ThinnedPolyline, PassesEveryPointWithinTheTolerance) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const QPolygonF walk = randomWalk(seed, 400);
    for (const double tolerance : {0.05, 0.5, 4.0}) {
      const QPolygonF thin = thinned(walk, tolerance);
      EXPECT_EQ(thin.front(), walk.front());
      EXPECT_EQ(thin.back(), walk.back());
      for (const QPointF& point : walk) {
        EXPECT_LE(distanceTo(thin, point), tolerance * (1 + 1e-9)) << "seed " << seed << ", tolerance " << tolerance;
      }
    }
  }
}

TEST(ThinnedPolyline, OfADenseCircleHasAsFewPointsAsTheToleranceAllows) {
  QPolygonF circle;
  for (int i = 0; i <= 100000; ++i) {
    circle.append(100 * QPointF(std::cos(i * 2e-5 * M_PI), std::sin(i * 2e-5 * M_PI)));
  }
  // A chord may leave the circle by up to twice the tolerance: the radius less its sagitta, centred.
  const double longest = 2 * std::acos(1 - 2 * 0.1 / 100);
  EXPECT_LT(thinned(circle, 0.1).size(), 2 * 2 * M_PI / longest);
}

TEST(ThinnedPolyline, OfAStraightLineHasItsEndsOnly) {
  QPolygonF line;
  for (int i = 0; i <= 1000; ++i) {
    line.append({i * 0.1, i * 0.2});
  }
  EXPECT_EQ(thinned(line, 0.01), (QPolygonF{{0, 0}, {100, 200}}));
}

TEST(ThinnedPolyline, KeepsTheTipOfASpike) {
  EXPECT_EQ(thinned({{0, 0}, {10, 0}, {5, 0}, {5, 3}}, 0.1), (QPolygonF{{0, 0}, {10, 0}, {5, 0}, {5, 3}}));
}

TEST(ThinnedPolyline, OfOnePointOrNoneIsTheSame) {
  EXPECT_TRUE(thinned({}, 1).isEmpty());
  EXPECT_EQ(thinned({{1, 2}}, 1), (QPolygonF{{1, 2}}));
}

TEST(ColumnExtremes, KeepFirstLeastGreatestAndLastOfEveryColumn) {
  const QPolygonF noise{{0.1, 5}, {0.2, -7}, {0.3, 9}, {0.4, 1}, {0.9, 2}, {1.5, 3}};
  EXPECT_EQ(columnExtremes(noise, 1), (QPolygonF{{0.1, 5}, {0.2, -7}, {0.3, 9}, {0.9, 2}, {1.5, 3}}));
}

TEST(ClippedPolyline, IsCutAtTheEdgesAndKnowsHowFarItHadCome) {
  const std::vector<Stretch> parts = clipped({{-5, 5}, {15, 5}, {15, 8}, {5, 8}}, QRectF(0, 0, 10, 10));
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].points, (QPolygonF{{0, 5}, {10, 5}}));
  EXPECT_DOUBLE_EQ(parts[0].startLength, 5);
  EXPECT_EQ(parts[1].points, (QPolygonF{{10, 8}, {5, 8}}));
  EXPECT_DOUBLE_EQ(parts[1].startLength, 28);
}

TEST(ClippedPolyline, IsBrokenWhereAValueIsMissing) {
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Stretch> parts = clipped({{1, 1}, {2, 2}, {3, nothing}, {4, 4}, {5, 5}}, QRectF(0, 0, 10, 10));
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].points, (QPolygonF{{1, 1}, {2, 2}}));
  EXPECT_EQ(parts[1].points, (QPolygonF{{4, 4}, {5, 5}}));
}

TEST(ClippedArea, IsTheCommonPartOfPolygonAndRectangle) {
  const QPolygonF inside = clippedArea({{-5, -5}, {20, -5}, {20, 5}, {-5, 5}}, QRectF(0, 0, 10, 10));
  double doubled = 0;
  for (qsizetype i = 0; i < inside.size(); ++i) {
    const QPointF& a = inside[i];
    const QPointF& b = inside[(i + 1) % inside.size()];
    doubled += a.x() * b.y() - a.y() * b.x();
  }
  EXPECT_DOUBLE_EQ(std::abs(doubled) / 2, 50);
  EXPECT_TRUE(clippedArea({{20, 20}, {30, 20}, {30, 30}}, QRectF(0, 0, 10, 10)).isEmpty());
}

} // namespace
} // namespace arris::ui
