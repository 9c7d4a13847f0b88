#include "tests/support/panes.h"
#include "ui/figures/profile_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace arris::ui {
namespace {

const job::Job& triangle() {
  static const job::Job kJob = job::planJob(test::triangle600(), {}, {});
  return kJob;
}

double distance(const QPointF& a, const geometry::Point& b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

TEST(ProfilePath, GoesThroughTheCornersFromAToC) {
  const ProfileCurves curves = curvesOf(columnsOf(triangle()), {});
  const std::vector<PathPiece> path = pathOf(curves);
  std::vector<PathPiece> corners;
  std::copy_if(path.begin(), path.end(), std::back_inserter(corners), [](const PathPiece& p) { return p.inCorner; });
  ASSERT_EQ(corners.size(), 3U);
  EXPECT_EQ(path.size(), 7U); // and before, between and after them
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const toolpath::Corner& corner = triangle().toolpath.corners[i];
    EXPECT_LT(distance(corners[i].points.front(), corner.a), 0.1); // between rows of 1 ms at 20 mm/s
    EXPECT_LT(distance(corners[i].points.back(), corner.c), 0.1);
    EXPECT_EQ(corners[i].points.size(), static_cast<qsizetype>(corners[i].times.size()));
    double farthest = 0;
    for (const QPointF& point : corners[i].points) {
      EXPECT_GE(distance(point, corner.s), 75 - 0.05);
      farthest = std::max(farthest, distance(point, corner.s));
    }
    EXPECT_NEAR(farthest, 93.75, 0.05);
  }
}

// Its length is that of the wheel path, leads included.
TEST(ProfilePath, IsAsLongAsTheWheelPath) {
  double length = 0;
  for (const PathPiece& piece : pathOf(curvesOf(columnsOf(triangle()), {}))) {
    for (qsizetype i = 1; i < piece.points.size(); ++i) {
      const QPointF way = piece.points[i] - piece.points[i - 1];
      length += std::hypot(way.x(), way.y());
    }
  }
  double planned = 0;
  for (const toolpath::PathSegment& segment : triangle().toolpath.chains.front().segments) {
    planned += geometry::arcLength(segment.shape);
  }
  EXPECT_NEAR(length, planned, 0.001 * planned);
}

TEST(ProfilePath, LeavesOutTheWaysFromOneContourToTheNext) {
  pattern::Pattern two = test::polygon({{0, 0}, {300, 0}, {300, 300}, {0, 300}});
  const pattern::Pattern other = test::polygon({{800, 0}, {1100, 0}, {1100, 300}, {800, 300}});
  two.contours.push_back(other.contours.front());
  two.contours.back().id = 2;
  const job::Job job = job::planJob(two, {}, {});
  ASSERT_TRUE(job.canBeGround());
  double left = std::numeric_limits<double>::infinity(); // of the pane on the right
  double right = -left;                                  // of the one on the left
  for (const pattern::Contour& contour : job.contours) {
    const geometry::Box box = geometry::bounds(contour.curves);
    left = box.min().x() > 750 ? std::min(left, box.min().x()) : left;
    right = box.max().x() < 750 ? std::max(right, box.max().x()) : right;
  }
  ASSERT_LT(right, left);
  const double middle = (left + right) / 2;
  int onTheLeft = 0;
  int onTheRight = 0;
  for (const PathPiece& piece : pathOf(curvesOf(columnsOf(job), {}))) {
    const QRectF box = piece.points.boundingRect();
    EXPECT_TRUE(box.right() < middle || box.left() > middle)
        << box.left() << " to " << box.right() << ", not across " << middle;
    ++(box.right() < middle ? onTheLeft : onTheRight);
  }
  EXPECT_EQ(onTheLeft, 9); // four corners, and before, between and after them
  EXPECT_EQ(onTheRight, 9);
}

TEST(ProfilePath, KnowsThePlacesOfTheMethod) {
  const PathSetting setting = pathSettingOf(triangle(), drawingOf(triangle()));
  ASSERT_EQ(setting.corners.size(), 3U);
  std::string names;
  for (const PathPlace& place : setting.corners[2].places) {
    names += (place.name + place.index).toStdString() + ' ';
  }
  EXPECT_EQ(names, "Pd A Q C Pa S ");
  EXPECT_LT(distance(setting.corners[2].places[2].place, triangle().toolpath.corners[2].q), 1e-9);
  EXPECT_TRUE(setting.glass.speedMarks.empty());
}

// A file has no Q and no S, but the rest to a row.
TEST(ProfilePath, FindsThePlacesOfAProfileWithoutAPlan) {
  const ProfileCurves curves = curvesOf(columnsOf(triangle()), {});
  const std::vector<CornerPass> passes = cornerPasses(curves);
  const CornerPlaces found = placesOf(curves, passes[1]);
  const CornerPlaces planned = pathSettingOf(triangle(), drawingOf(triangle())).corners[1];
  ASSERT_EQ(found.places.size(), 4U);
  for (const PathPlace& place : found.places) {
    const auto same = std::find_if(planned.places.begin(), planned.places.end(), [&](const PathPlace& candidate) {
      return candidate.name == place.name && candidate.index == place.index;
    });
    ASSERT_NE(same, planned.places.end());
    const QPointF off = same->place - place.place;
    EXPECT_LT(std::hypot(off.x(), off.y()), 0.2) << place.name.toStdString() << place.index.toStdString();
  }
}

} // namespace
} // namespace arris::ui
