// The checks of the promises can fail: paths that are wrong by little are found, at the place and by the amount.

#include "core/base/numbers.h"
#include "tests/support/dice.h"
#include "tests/support/panes.h"
#include "tests/support/random_glass.h"
#include "tests/support/swept_glass.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

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

PathSegment pathSegment(const geometry::Curve& shape, Role role) {
  PathSegment segment;
  segment.shape = shape;
  segment.role = role;
  return segment;
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

/// By hand, the wheel of 75 mm round the L whose concave corner lies at (500, 500): rolls, and lines that meet or stop
/// `before` (run on past: negative) their crossing at (575, 575).
Job lByHand(double before) {
  using geometry::Line;
  Job job;
  job.contours = test::polygon({{0, 0}, {800, 0}, {800, 500}, {500, 500}, {500, 800}, {0, 800}}).contours;
  const auto add = [&job](const geometry::Curve& shape, Role role) {
    job.toolpath.chains.resize(1);
    segmentsOf(job).push_back(pathSegment(shape, role));
  };
  const double quarter = base::kPi / 2;
  add(Line{{0, -75}, {800, -75}}, Role::Contour);
  add(geometry::arcAbout({800, 0}, 75, -quarter, quarter), Role::Roll);
  add(Line{{875, 0}, {875, 500}}, Role::Contour);
  add(geometry::arcAbout({800, 500}, 75, 0, quarter), Role::Roll);
  add(Line{{800, 575}, {575 + before, 575}}, Role::Contour);
  add(Line{{575, 575 + before}, {575, 800}}, Role::Contour);
  add(geometry::arcAbout({500, 800}, 75, 0, quarter), Role::Roll);
  add(Line{{500, 875}, {0, 875}}, Role::Contour);
  add(geometry::arcAbout({0, 800}, 75, quarter, quarter), Role::Roll);
  add(Line{{-75, 800}, {-75, 0}}, Role::Contour);
  add(geometry::arcAbout({0, 0}, 75, 2 * quarter, quarter), Role::Roll);
  return job;
}

TEST(SweptGlass, FindsNothingWrongWithAnLByHand) {
  EXPECT_TRUE(test::grindsAllAndOnlyTheEdge(lByHand(0)));
}

TEST(SweptGlass, FindsThatThePathStopsShortOfAConcaveCorner) {
  const std::vector<Breach> breaches = test::untouched(lByHand(2));
  ASSERT_FALSE(breaches.empty());
  for (const Breach& breach : breaches) { // the last 2 mm that the wheel reaches on either edge
    const double along = std::max(breach.where.x(), breach.where.y());
    EXPECT_GT(along, 575 - 1e-5);
    EXPECT_LT(along, 577);
    EXPECT_LE(breach.amount, std::hypot(75, 2) - 75 + 1e-9);
  }
}

TEST(SweptGlass, FindsThatThePathRunsPastAConcaveCorner) {
  const std::vector<Breach> breaches = test::gouges(lByHand(-0.002));
  ASSERT_EQ(breaches.size(), 2U);
  EXPECT_NEAR(breaches.front().amount, -0.002, 1e-6);
}

double distanceByTheProgram(const Job& job, const Point& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const pattern::Contour& contour : job.contours) {
    for (const geometry::Curve& curve : contour.curves) {
      nearest = std::min(nearest, geometry::nearest(curve, p).distance);
    }
  }
  return nearest;
}

/// Places all over the pane and round it, and on the normals of its contours within 50 nm of what is allowed.
std::vector<Point> placesOn(const Job& job, test::Dice& dice) {
  geometry::Box box;
  std::vector<Point> places;
  for (const pattern::Contour& contour : job.contours) {
    box.extend(geometry::bounds(contour.curves));
    for (const geometry::Curve& curve : contour.curves) {
      const auto foot = geometry::evaluate(curve, dice.between(0, 1) * geometry::parameterLength(curve));
      const double away = job.recipe.wheelRadius - 1e-3 + (dice.chance(0.5) ? 50e-6 : -50e-6);
      places.emplace_back(foot.point - away * geometry::leftOf(foot.first));
    }
  }
  for (int i = 0; i < 100; ++i) {
    const Point share(dice.between(-0.2, 1.2), dice.between(-0.2, 1.2));
    places.emplace_back(box.min() + share.cwiseProduct(box.sizes()));
  }
  return places;
}

// Clipper's widened glass against the program's own distances: strokes of 0.1 µm are told apart exactly, in hollows
// tighter than the wheel, narrow slots and islands too.
TEST(SweptGlass, AgreesWithTheDistanceFromTheContoursEverywhere) {
  test::Dice dice(1);
  std::size_t found = 0;
  std::size_t all = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Job job = test::planned(test::randomGlass(seed));
    job.toolpath.chains.assign(1, {});
    std::vector<Point> tooNear;
    for (const Point& p : placesOn(job, dice)) {
      segmentsOf(job).push_back(pathSegment(geometry::Line{p, p + Vector(1e-4, 0)}, Role::LeadIn));
      const Point end = p + Vector(1e-4, 0);
      const double nearest = std::min(distanceByTheProgram(job, p), distanceByTheProgram(job, end));
      const bool inGlass = test::distanceFromGlass(job.contours, p) < 0;
      if (inGlass || nearest < job.recipe.wheelRadius - 1e-3) {
        tooNear.push_back(p);
      }
    }
    const std::vector<Breach> breaches = test::gouges(job);
    ASSERT_EQ(breaches.size(), tooNear.size()) << "seed " << seed;
    for (std::size_t i = 0; i < tooNear.size(); ++i) {
      EXPECT_LT((breaches[i].where - tooNear[i]).norm(), 1e-3);
    }
    found += tooNear.size();
    all += segmentsOf(job).size();
  }
  EXPECT_GT(found, all / 4);
  EXPECT_LT(found, 3 * all / 4);
}

} // namespace
} // namespace arris::job
