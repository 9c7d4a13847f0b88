// The checks of the promises can fail: paths that are wrong by little are found, at the place and by the amount.

#include "core/base/numbers.h"
#include "tests/support/panes.h"
#include "tests/support/swept_glass.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace arris::job {
namespace {

using geometry::Point;
using geometry::Vector;
using test::Breach;
using toolpath::PathSegment;
using toolpath::Role;

/// A rectangle of 400 × 300 with a bulging side and a rounded corner (radius 60): lines, arcs and sharp corners. The
/// longest line, and so the start, is the lower side.
Job paneWithArcs() {
  using geometry::arcBetween;
  using geometry::Line;
  return planJob(
      test::paneOf({Line{{0, 0}, {400, 0}}, arcBetween({400, 0}, {400, 300}, 0.3), Line{{400, 300}, {60, 300}},
                    arcBetween({60, 300}, {0, 240}, base::kPi / 2), Line{{0, 240}, {0, 0}}}),
      {}, {});
}

std::vector<PathSegment>& segmentsOf(Job& job) {
  return job.toolpath.chains.front().segments;
}

/// The first arc or line along the contour that runs round or beside this place.
PathSegment& contourPiece(Job& job, bool arc) {
  const auto found = std::find_if(segmentsOf(job).begin() + 2, segmentsOf(job).end(), [arc](const PathSegment& piece) {
    return piece.role == Role::Contour && std::holds_alternative<geometry::Arc>(piece.shape) == arc;
  });
  return *found;
}

void shift(PathSegment& piece, const Vector& by) {
  Eigen::Isometry2d motion = Eigen::Isometry2d::Identity();
  motion.translate(by);
  piece.shape = geometry::transformed(piece.shape, motion);
}

/// Unit direction from the middle of the piece to the glass, which the wheel has on its right (clockwise).
Vector toGlass(const PathSegment& piece) {
  const auto middle = geometry::evaluate(piece.shape, geometry::parameterLength(piece.shape) / 2);
  return -geometry::leftOf(middle.first.normalized());
}

double worst(const std::vector<Breach>& breaches) {
  double most = 0;
  for (const Breach& breach : breaches) {
    most = std::max(most, std::abs(breach.amount));
  }
  return most;
}

TEST(SweptGlass, FindsNothingWrongWithAPlannedPane) {
  const Job job = paneWithArcs();
  ASSERT_TRUE(job.canBeGround());
  EXPECT_TRUE(test::grindsAllAndOnlyTheEdge(job));
}

TEST(SweptGlass, FindsALineThatRunsTwoMicrometresIntoTheGlass) {
  Job job = paneWithArcs();
  PathSegment& piece = contourPiece(job, false);
  shift(piece, 2e-3 * toGlass(piece));
  const std::vector<Breach> breaches = test::gouges(job);
  ASSERT_EQ(breaches.size(), 1U);
  EXPECT_NEAR(breaches.front().amount, -2e-3, 1e-6);
  EXPECT_FALSE(test::grindsAllAndOnlyTheEdge(job));
}

TEST(SweptGlass, FindsALineThatRunsTwoMicrometresOffTheGlass) {
  Job job = paneWithArcs();
  PathSegment& piece = contourPiece(job, false);
  shift(piece, -2e-3 * toGlass(piece));
  EXPECT_TRUE(test::gouges(job).empty());
  EXPECT_NEAR(worst(test::idling(job)), 2e-3, 1e-6);
  EXPECT_NEAR(worst(test::untouched(job)), 2e-3, 1e-6);
}

TEST(SweptGlass, ToleratesHalfAMicrometreEitherWay) {
  for (const double by : {0.5e-3, -0.5e-3}) {
    Job job = paneWithArcs();
    PathSegment& piece = contourPiece(job, false);
    shift(piece, by * toGlass(piece));
    EXPECT_TRUE(test::grindsAllAndOnlyTheEdge(job));
  }
}

TEST(SweptGlass, FindsAnArcWhoseRadiusIsTwoMicrometresOff) {
  for (const double by : {2e-3, -2e-3}) {
    Job job = paneWithArcs();
    PathSegment& piece = contourPiece(job, true);
    auto& arc = std::get<geometry::Arc>(piece.shape);
    const double radius = arc.radius() + by;
    const Point centre = arc.center();
    const Vector from = (arc.start - centre).normalized();
    const double sweep = arc.sweep();
    piece.shape =
        geometry::Arc{centre + radius * from, arc.tangent, (sweep > 0 ? 1 : -1) / radius, radius * std::abs(sweep)};
    EXPECT_EQ(test::gouges(job).size(), by < 0 ? 1U : 0U);
    EXPECT_EQ(test::idling(job).empty(), by < 0);
    EXPECT_EQ(test::untouched(job).empty(), by < 0);
  }
}

TEST(SweptGlass, FindsATransitionThatCutsItsCorner) {
  Job job = paneWithArcs();
  const auto piece = std::find_if(segmentsOf(job).begin(), segmentsOf(job).end(),
                                  [](const PathSegment& s) { return s.role == Role::Transition; });
  piece->shape = geometry::Line{geometry::startPoint(piece->shape), geometry::endPoint(piece->shape)};
  const std::vector<Breach> breaches = test::gouges(job);
  ASSERT_EQ(breaches.size(), 1U);
  EXPECT_EQ(breaches.front().what, "transition");
  // From tangent point to tangent point at 90°: R/√2 from the corner.
  EXPECT_NEAR(breaches.front().amount, 75 / std::sqrt(2.0) - 75, 1e-6);
}

TEST(SweptGlass, FindsAnEdgeThatTheWheelLeavesOut) {
  Job job = paneWithArcs();
  for (const bool arc : {false, true}) {
    PathSegment& piece = contourPiece(job, arc);
    const PathSegment dropped = piece;
    segmentsOf(job).erase(segmentsOf(job).begin() + (&piece - segmentsOf(job).data()));
    const std::vector<Breach> breaches = test::untouched(job);
    EXPECT_GT(breaches.size(), 20U);
    // The foot of the dropped piece's middle on the glass is left by the length of the way to its neighbours.
    const Point middle = geometry::pointAt(dropped.shape, geometry::parameterLength(dropped.shape) / 2);
    const Point foot = middle + 75 * toGlass(dropped);
    EXPECT_TRUE(
        std::any_of(breaches.begin(), breaches.end(), [&](const Breach& b) { return (b.where - foot).norm() < 2; }));
  }
}

TEST(SweptGlass, FindsALeadThatCrossesTheGlass) {
  Job job = paneWithArcs();
  PathSegment& lead = segmentsOf(job).front();
  const Point meets = geometry::endPoint(lead.shape);
  lead.shape = geometry::Line{meets + 300 * toGlass(segmentsOf(job)[1]), meets};
  const std::vector<Breach> breaches = test::gouges(job);
  ASSERT_FALSE(breaches.empty());
  EXPECT_EQ(breaches.front().what, "lead-in");
  EXPECT_LT(breaches.front().amount, -75);
}

TEST(SweptGlass, FindsAPathThatLeavesOutAHoleUnlessThatIsAccepted) {
  Job job = paneWithArcs();
  const geometry::Box box = geometry::bounds(job.contours.front().curves);
  job.recipe.wheelRadius = 75;
  pattern::Contour hole;
  hole.kind = pattern::ContourKind::CutOut;
  hole.curves = {geometry::arcAbout(box.center(), 100, 0, -2 * base::kPi)};
  job.contours.push_back(hole);
  const std::vector<Breach> breaches = test::untouched(job);
  EXPECT_GT(breaches.size(), 400U); // 628 mm, a sample each 1.5 mm
  for (const Breach& breach : breaches) {
    EXPECT_NEAR((breach.where - box.center()).norm(), 100, 1e-9);
  }
  EXPECT_TRUE(test::untouched(job, test::Unentered::Accepted).empty());
}

TEST(SweptGlass, DoesNotAskForWhatNoWheelOfThatRadiusReaches) {
  Job job = paneWithArcs();
  pattern::Contour hole;
  hole.kind = pattern::ContourKind::CutOut;
  hole.curves = {geometry::arcAbout(geometry::bounds(job.contours.front().curves).center(), 70, 0, -2 * base::kPi)};
  job.contours.push_back(hole);
  EXPECT_TRUE(test::grindsAllAndOnlyTheEdge(job));
}

} // namespace
} // namespace arris::job
