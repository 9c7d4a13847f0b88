#include "core/base/numbers.h"
#include "core/files/profile_csv.h"
#include "tests/support/panes.h"
#include "ui/figures/profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace arris::ui {
namespace {

job::Job triangleJob() {
  return job::planJob(test::triangle600(), recipe::Recipe{}, recipe::Machine{});
}

// The value of a curve at an instant; NaN in a gap.
double valueAt(const QPolygonF& curve, double time) {
  const auto after = std::find_if(curve.begin(), curve.end(), [time](const QPointF& p) { return p.x() >= time; });
  if (after == curve.begin() || after->x() == time) {
    return after->y();
  }
  const QPointF& b = *after;
  const QPointF& a = *std::prev(after);
  return a.y() + (b.y() - a.y()) * (time - a.x()) / (b.x() - a.x());
}

TEST(ProfileCurves, MarkEachCornerFromTheFirstBrakingToTheLastAccelerating) {
  const ProfileCurves curves = curvesOf(columnsOf(triangleJob()), {});
  ASSERT_EQ(curves.bands.size(), 9U);
  for (int corner = 1; corner <= 3; ++corner) {
    const auto first = static_cast<std::size_t>(3 * (corner - 1));
    const CornerBand& slowing = curves.bands[first];
    const CornerBand& inCorner = curves.bands[first + 1];
    const CornerBand& leaving = curves.bands[first + 2];
    EXPECT_EQ(slowing.zone, Zone::Slowing);
    EXPECT_EQ(inCorner.zone, Zone::Corner);
    EXPECT_EQ(leaving.zone, Zone::Leaving);
    EXPECT_EQ(slowing.corner, corner);
    EXPECT_EQ(inCorner.corner, corner);
    EXPECT_EQ(leaving.corner, corner);
    EXPECT_NEAR(inCorner.to - inCorner.from, 12.99038, 0.0021); // t_m, between rows of 1 ms
    EXPECT_DOUBLE_EQ(slowing.to, inCorner.from);
    EXPECT_DOUBLE_EQ(inCorner.to, leaving.from);
  }
}

TEST(ProfileCurves, MarkAStopWhereBrakingEnds) {
  const ProfileCurves curves =
      curvesOf(columnsOf(job::planJob(test::polygon({{0, 0}, {1000, 0}, {1000, 400}, {600, 400}, {600, 800}, {0, 800}}),
                                      {}, {})),
               {});
  const auto stop = std::find_if(curves.bands.begin(), curves.bands.end(), [](const CornerBand& band) {
    return band.zone == Zone::Corner && band.from == band.to;
  });
  ASSERT_NE(stop, curves.bands.end());
  EXPECT_NEAR(valueAt(curves.panels[static_cast<std::size_t>(Panel::Speed)], stop->from), 0, 0.1);
}

TEST(ProfileCurves, MarkTheWaysBetweenContours) {
  pattern::Pattern two = test::polygon({{0, 0}, {500, 0}, {500, 500}, {0, 500}});
  pattern::Contour second = test::polygon({{800, 0}, {1300, 0}, {1300, 500}, {800, 500}}).contours.front();
  second.id = 2;
  two.contours.push_back(second);
  const ProfileCurves curves = curvesOf(columnsOf(job::planJob(two, {}, {})), {});
  const auto isAway = [](const CornerBand& band) { return band.zone == Zone::Away; };
  ASSERT_EQ(std::count_if(curves.bands.begin(), curves.bands.end(), isAway), 1);
  const CornerBand way = *std::find_if(curves.bands.begin(), curves.bands.end(), isAway);
  EXPECT_GT(way.from, curves.workFrom);
  EXPECT_LT(way.to, curves.workTo);
  EXPECT_GT(way.to - way.from, 1);
}

TEST(ProfileCurves, WorkReachesFromLeadInToLeadOut) {
  const job::Job job = triangleJob();
  const ProfileCurves curves = curvesOf(columnsOf(job), {});
  EXPECT_NEAR(curves.workTo - curves.workFrom, job.working, 0.0021);
  EXPECT_DOUBLE_EQ(curves.duration, job.duration);
}

TEST(ProfileCurves, RangesAreThoseOfTheWorkAndNotOfTheRapids) {
  const ProfileCurves curves = curvesOf(columnsOf(triangleJob()), {});
  EXPECT_NEAR(curves.range[static_cast<std::size_t>(Panel::Speed)].second, 60, 1e-6);
  // While the wheel passes the corners: from R at A and C to L(t_m/2).
  EXPECT_NEAR(curves.range[static_cast<std::size_t>(Panel::Distance)].first, 75, 1e-3);
  EXPECT_NEAR(curves.range[static_cast<std::size_t>(Panel::Distance)].second, 93.75, 1e-3);
}

TEST(ProfileCurves, AreThinAndStayWithinAFractionOfAPixelOfEveryRow) {
  const ProfileColumns columns = columnsOf(triangleJob());
  const ProfileCurves curves = curvesOf(columns, {});
  const QPolygonF& speed = curves.panels[static_cast<std::size_t>(Panel::Speed)];
  EXPECT_LT(speed.size(), 2000);
  const double greatest = *std::max_element(columns.speed.begin(), columns.speed.end());
  for (std::size_t i = 0; i < columns.time.size(); i += 37) {
    EXPECT_NEAR(valueAt(speed, columns.time[i]), columns.speed[i], greatest / 2000) << "t = " << columns.time[i];
  }
}

TEST(ProfileCurves, HaveNoDistanceWhereNoCornerIsDue) {
  const ProfileColumns columns = columnsOf(triangleJob());
  const QPolygonF distance = curvesOf(columns, {}).panels[static_cast<std::size_t>(Panel::Distance)];
  EXPECT_GE(std::count_if(distance.begin(), distance.end(), [](const QPointF& p) { return std::isnan(p.y()); }), 2);
  for (const QPointF& point : distance) {
    EXPECT_TRUE(std::isnan(point.y()) || point.y() > 74.999);
  }
}

TEST(ProfileCurves, ComeOutTheSameFromTheFileThatWasWritten) {
  const job::Job job = triangleJob();
  const ProfileColumns planned = columnsOf(job);
  std::vector<files::ProfileRow> rows;
  for (std::size_t i = 0; i < planned.time.size(); ++i) {
    files::ProfileRow row;
    row.time = planned.time[i];
    row.position = {planned.x[i], planned.y[i], 0};
    row.velocity = {planned.vx[i], planned.vy[i], 0};
    row.acceleration = {planned.ax[i], planned.ay[i], 0};
    row.speed = planned.speed[i];
    row.contour = planned.contour[i];
    row.corner = planned.corner[i];
    row.phase = planned.zone[i] == Zone::Corner    ? "transition"
                : planned.zone[i] == Zone::Slowing ? "decelerate"
                : planned.zone[i] == Zone::Leaving ? "accelerate"
                                                   : "cruise";
    row.distance = row.corner != 0 ? planned.distance[i] : 0;
    rows.push_back(row);
  }
  const ProfileCurves read = curvesOf(columnsOf(rows), {});
  const ProfileCurves direct = curvesOf(planned, {});
  EXPECT_EQ(read.bands.size(), direct.bands.size());
  EXPECT_EQ(read.range, direct.range);
  for (const Panel panel : {Panel::SpeedX, Panel::AccelerationY, Panel::Speed}) {
    EXPECT_EQ(read.panels[static_cast<std::size_t>(panel)], direct.panels[static_cast<std::size_t>(panel)]);
  }
}

TEST(ProfileCurves, OfNothingAreEmpty) {
  const ProfileCurves curves = curvesOf({}, QStringLiteral("planned"));
  EXPECT_TRUE(curves.bands.empty());
  EXPECT_TRUE(curves.panels.front().isEmpty());
}

TEST(ProfileCurves, HaveValuesBetweenTheirPointsAndNoneInGapsAndBeyond) {
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  const QPolygonF curve{{1, 10}, {2, 20}, {3, kGap}, {5, 50}, {6, 40}};
  EXPECT_DOUBLE_EQ(curveValue(curve, 1), 10);
  EXPECT_DOUBLE_EQ(curveValue(curve, 1.25), 12.5);
  EXPECT_DOUBLE_EQ(curveValue(curve, 2), 20);
  EXPECT_DOUBLE_EQ(curveValue(curve, 5.5), 45);
  EXPECT_DOUBLE_EQ(curveValue(curve, 6), 40);
  for (const double time : {0.9, 2.5, 3.0, 4.9, 6.1, kGap}) {
    EXPECT_TRUE(std::isnan(curveValue(curve, time))) << time;
  }
  EXPECT_TRUE(std::isnan(curveValue({}, 0)));
}

TEST(ProfileCurves, PassEachCornerOfATriangleOnce) {
  const std::vector<CornerPass> passes = cornerPasses(curvesOf(columnsOf(triangleJob()), {}));
  ASSERT_EQ(passes.size(), 3U);
  for (std::size_t i = 0; i < passes.size(); ++i) {
    EXPECT_EQ(passes[i].corner, static_cast<int>(i) + 1);
    EXPECT_LT(passes[i].from, passes[i].middle);
    EXPECT_GT(passes[i].to - passes[i].from, 12.99038); // t_m, and braking before it
  }
}

TEST(CornerPasses, AreNotDividedByAHoldButByTheNextBrakingForTheSameCorner) {
  ProfileCurves curves;
  curves.bands = {{7, Zone::Slowing, 1, 2}, {7, Zone::Corner, 2, 3},    {7, Zone::Corner, 13, 16},
                  {0, Zone::Away, 17, 18},  {7, Zone::Leaving, 20, 21}, {7, Zone::Slowing, 30, 34}};
  const std::vector<CornerPass> passes = cornerPasses(curves);
  ASSERT_EQ(passes.size(), 2U);
  EXPECT_DOUBLE_EQ(passes[0].from, 1);
  EXPECT_DOUBLE_EQ(passes[0].middle, 9); // of 2 to 16
  EXPECT_DOUBLE_EQ(passes[0].to, 21);
  EXPECT_DOUBLE_EQ(passes[1].from, 30);
  EXPECT_DOUBLE_EQ(passes[1].middle, 32); // the corner itself is never reached
  EXPECT_DOUBLE_EQ(passes[1].to, 34);
}

TEST(ThinnedCurve, OfDenseNoiseHasFourPointsAColumnAtMost) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 1);
  QPolygonF curve;
  for (int i = 0; i < 100000; ++i) {
    curve.append({i * 1e-3, noise(random)});
  }
  EXPECT_LE(thinnedCurve(curve, 10, 50, 0.2).size(), 4 * 1001);
}

TEST(ProfileLimits, OfAJobAreItsFeedItsAccelerationsAndTheReliefOfItsTransitions) {
  const ProfileLimits limits = limitsOf(triangleJob());
  EXPECT_EQ(limits.feed, 60);
  EXPECT_EQ(limits.accelX, 20);
  EXPECT_EQ(limits.accelY, 20);
  EXPECT_EQ(limits.wheelRadius, 75);
  ASSERT_EQ(limits.corners.size(), 3U);
  EXPECT_NEAR(*limits.corners[0].reliefRadius, 75.26, 1e-9); // R + d_n / sin 30°
  EXPECT_NEAR(base::degrees(limits.corners[0].angle), 60, 1e-9);
}

} // namespace
} // namespace arris::ui
