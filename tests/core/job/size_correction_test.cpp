// A size correction δ moves the finished contour outwards by δ, sharp corners staying sharp, and not the pane.

#include "core/base/numbers.h"
#include "core/job/job.h"
#include "tests/support/contours.h"
#include "tests/support/panes.h"
#include "tests/support/swept_glass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace arris::job {
namespace {

using geometry::Point;

recipe::Recipe correctedBy(double delta) {
  recipe::Recipe recipe;
  recipe.sizeCorrection = delta;
  recipe.wheelRadius = 50;
  return recipe;
}

/// The path along contour `id`, without leads, transitions and rolls.
std::vector<geometry::Curve> alongContour(const Job& job, int id) {
  std::vector<geometry::Curve> result;
  for (const toolpath::Chain& chain : job.toolpath.chains) {
    for (const toolpath::PathSegment& piece : chain.segments) {
      if (chain.contour == id && piece.role == toolpath::Role::Contour) {
        result.push_back(piece.shape);
      }
    }
  }
  return result;
}

void expectBox(const geometry::Box& box, const Point& least, const Point& greatest) {
  EXPECT_LT((box.min() - least).norm(), 1e-6) << box.min().transpose();
  EXPECT_LT((box.max() - greatest).norm(), 1e-6) << box.max().transpose();
}

class SizeCorrection : public testing::TestWithParam<double> {};

TEST_P(SizeCorrection, EnlargesARectangleByTwiceItWithSharpCorners) {
  const double delta = GetParam();
  const Job job = planJob(test::polygon({{0, 0}, {400, 0}, {400, 300}, {0, 300}}), correctedBy(delta), {});
  ASSERT_TRUE(job.canBeGround());
  const Point corner = job.placement.patternOrigin; // of the drawing
  const Point away = Point::Constant(delta + 50);
  expectBox(geometry::bounds(alongContour(job, 1)), corner - away, corner + Point(400, 300) + away);
  ASSERT_EQ(job.toolpath.corners.size(), 4U);
  for (const toolpath::Corner& c : job.toolpath.corners) {
    EXPECT_NEAR(c.angle, base::kPi / 2, 1e-9);
    const Point fromMiddle = (c.s - corner - Point(200, 150)).cwiseAbs();
    EXPECT_LT((fromMiddle - Point(200 + delta, 150 + delta)).norm(), 1e-6);
  }
}

TEST_P(SizeCorrection, EnlargesACircle) {
  const double delta = GetParam();
  const Job job =
      planJob(test::paneOf({geometry::arcAbout({0, 0}, 200, -base::kPi / 2, 2 * base::kPi)}), correctedBy(delta), {});
  ASSERT_TRUE(job.canBeGround());
  const Point middle = job.placement.patternOrigin;
  const Point away = Point::Constant(250 + delta);
  expectBox(geometry::bounds(alongContour(job, 1)), middle - away, middle + away);
}

TEST_P(SizeCorrection, MakesACutOutSmaller) {
  const double delta = GetParam();
  pattern::Pattern pane = test::polygon({{0, 0}, {600, 0}, {600, 500}, {0, 500}});
  pattern::Contour hole;
  hole.id = 2;
  hole.parent = 1;
  hole.kind = pattern::ContourKind::CutOut;
  hole.curves = {geometry::arcAbout({300, 250}, 120, -base::kPi / 2, -2 * base::kPi)};
  pane.contours.push_back(hole);
  const Job job = planJob(pane, correctedBy(delta), {});
  ASSERT_TRUE(job.canBeGround());
  const Point middle = job.placement.patternOrigin + Point(300, 250);
  const Point away = Point::Constant(120 - delta - 50);
  expectBox(geometry::bounds(alongContour(job, 1)), middle - away, middle + away); // machined first
}

TEST_P(SizeCorrection, MovesThePaneByNothing) {
  const pattern::Pattern pane = test::polygon({{10, 20}, {410, 20}, {410, 320}});
  const Placement plain = planJob(pane, correctedBy(0), {}).placement;
  const Placement corrected = planJob(pane, correctedBy(GetParam()), {}).placement;
  EXPECT_EQ(corrected.place, plain.place);
  EXPECT_EQ(corrected.patternOrigin, plain.patternOrigin);
}

INSTANTIATE_TEST_SUITE_P(Sizes, SizeCorrection, testing::Values(-2.5, -0.3, 0.4, 5.0));

// At a corner of 60° the finished corner moves out by δ/sin 30° on the bisector, at 90° by δ√2.
TEST(SizeCorrection, MovesACornerAlongItsBisector) {
  const Job job = planJob(test::triangle600(), correctedBy(0.4), {});
  ASSERT_TRUE(job.canBeGround());
  for (const toolpath::Corner& corner : job.toolpath.corners) {
    EXPECT_NEAR((corner.s - job.placement.patternOrigin).norm(), 600 / std::sqrt(3.0) + 0.8, 1e-9);
  }
}

} // namespace
} // namespace arris::job
