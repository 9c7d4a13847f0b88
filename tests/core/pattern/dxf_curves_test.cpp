#include "core/base/numbers.h"
#include "core/geometry/arc_fitter.h"
#include "core/pattern/pattern.h"
#include "tests/support/contours.h"
#include "tests/support/dxf_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace arris::pattern {
namespace {

using base::Code;
using base::kPi;
using geometry::Curve;
using geometry::Point;
using test::DxfText;

Pattern readCurves(std::string_view groups) {
  return readDxf(DxfText().insUnits(4).addGroups(groups).text(), {});
}

/// The pattern's only contour, and nothing else.
std::vector<Curve> onlyContour(const Pattern& pattern) {
  EXPECT_EQ(pattern.contours.size(), 1U);
  EXPECT_TRUE(pattern.loose.empty());
  EXPECT_FALSE(base::hasErrors(pattern.problems));
  return pattern.contours.size() == 1 ? pattern.contours[0].curves : std::vector<Curve>();
}

TEST(Ellipse, IsAContourOfItsOwn) {
  const std::vector<Curve> curves = onlyContour(readCurves("0 ELLIPSE\n10 50\n20 60\n11 0\n21 100\n40 0.25"));
  EXPECT_NEAR(geometry::signedArea(curves), kPi * 2500, 0.2);
  EXPECT_NEAR(geometry::bounds(curves).max().y(), 160, 1e-3);
  EXPECT_NEAR(geometry::bounds(curves).max().x(), 75, 1e-3);
  EXPECT_TRUE(test::isWellJoined(curves, 1e-10));
}

TEST(Ellipse, WithEqualAxesIsACircle) {
  const std::vector<Curve> curves =
      onlyContour(readCurves("0 ELLIPSE\n10 5\n20 6\n11 3\n21 4\n40 1\n41 0\n42 6.283185"));
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_NEAR(std::get<geometry::Arc>(curves[0]).radius(), 5, 1e-12);
}

// From the top to the left end over a quarter; seen from below, the minor axis points the other way.
TEST(Ellipse, RunsFromItsFirstParameterToItsSecond) {
  for (const double z : {1.0, -1.0}) {
    const Pattern pattern = readCurves(fmt::format("0 ELLIPSE\n10 0\n20 0\n11 100\n21 0\n40 0.5\n41 "
                                                   "1.5707963267948966\n42 3.141592653589793\n210 0\n220 0\n230 {}\n"
                                                   "0 LINE\n10 -100\n20 0\n11 0\n21 0\n0 LINE\n10 0\n20 0\n11 0\n21 {}",
                                                   z, 50 * z));
    EXPECT_NEAR(geometry::signedArea(onlyContour(pattern)), kPi * 5000 / 4, 0.1) << z;
  }
}

TEST(Ellipse, ThatIsTiltedOrHasNoAxisIsRefusedWithItsLine) {
  const auto errorOf = [](std::string_view groups) {
    const Pattern pattern = readCurves(groups);
    EXPECT_EQ(pattern.problems.front().line, test::lineOf(DxfText().insUnits(4).addGroups(groups).text(), "ELLIPSE"));
    return pattern.problems.front().code;
  };
  EXPECT_EQ(errorOf("0 ELLIPSE\n10 0\n20 0\n11 1\n21 0\n31 0.5\n40 0.5"), Code::EntityNotPlanar);
  EXPECT_EQ(errorOf("0 ELLIPSE\n10 0\n20 0\n11 1\n21 0\n40 0.5\n210 0.6\n220 0\n230 0.8"), Code::EntityNotPlanar);
  EXPECT_EQ(errorOf("0 ELLIPSE\n10 0\n20 0\n11 0\n21 0\n40 0.5"), Code::DxfEntityValue);
}

/// The groups of a SPLINE with the points once round a square of side 2: one convention or the other for closed ones.
std::string squareSpline(bool repeated, bool allKnots) {
  std::string groups = "0 SPLINE\n70 11\n71 3";
  for (int i = 0; i < (allKnots ? 11 : 5); ++i) {
    groups += fmt::format("\n40 {}", i);
  }
  const std::vector<Point> corners{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (std::size_t i = 0; i < (repeated ? 7U : 4U); ++i) {
    groups += fmt::format("\n10 {}\n20 {}", 100 * corners[i % 4].x(), 100 * corners[i % 4].y());
  }
  return groups;
}

TEST(Spline, ThatIsClosedIsReadInBothConventions) {
  const std::vector<Curve> repeated = onlyContour(readCurves(squareSpline(true, true)));
  const std::vector<Curve> once = onlyContour(readCurves(squareSpline(false, false)));
  EXPECT_NEAR(geometry::signedArea(repeated), geometry::signedArea(once), 1e-6);
  EXPECT_NEAR(geometry::bounds(once).max().x(), 100 * 11.0 / 12, 1e-3) << "(23 + 23 - 1 - 1) / 48 of a corner";
  EXPECT_TRUE(test::isWellJoined(repeated, 1e-10));
}

TEST(Spline, WithFitPointsAloneGoesThroughThem) {
  const std::string points = "\n11 0\n21 0\n11 100\n21 50\n11 200\n21 0";
  const Pattern pattern = readCurves("0 SPLINE\n70 8\n71 3\n72 0\n73 0\n74 3\n12 0\n22 1\n13 0\n23 -1" + points);
  ASSERT_FALSE(pattern.loose.empty());
  double nearest = 1;
  for (const Curve& curve : pattern.loose) {
    nearest = std::min(nearest, geometry::nearest(curve, Point(100, 50)).distance);
  }
  EXPECT_LT(nearest, geometry::kFitTolerance);
  const Curve& first = pattern.loose.front();
  EXPECT_LT(std::abs(geometry::startTangent(first).x()), 1e-9) << "straight up, as its first group 12, 22 says";
  const std::vector<Curve> closed = onlyContour(readCurves("0 SPLINE\n70 1\n71 3\n74 3" + points));
  EXPECT_TRUE(test::isWellJoined(closed, 1e-10));
}

TEST(Spline, WhoseKnotsMakeNoCurveFallsBackOnItsFitPoints) {
  const std::string controls = "0 SPLINE\n8 BAD\n71 3\n40 0\n40 1\n10 0\n20 0\n10 5\n20 5\n10 9\n20 0\n10 20\n20 0";
  const Pattern refused = readCurves(controls);
  ASSERT_EQ(test::problemsOf(refused, Code::SplineFlawed).size(), 1U);
  EXPECT_EQ(base::describe(refused.problems.front()), "The SPLINE is no curve: it has 2 knots and needs 8.");
  EXPECT_TRUE(refused.problems.front().line.has_value());
  const Pattern read = readCurves(controls + "\n11 0\n21 0\n11 10\n21 5\n11 20\n21 0");
  EXPECT_TRUE(test::problemsOf(read, Code::SplineFlawed).empty());
  EXPECT_FALSE(read.loose.empty());
}

TEST(Spline, OutOfThePlaneIsRefusedWhateverItsHeight) {
  const auto at = [](double first, double last) {
    return fmt::format("0 SPLINE\n71 1\n40 0\n40 0\n40 1\n40 1\n10 0\n20 0\n30 {}\n10 5\n20 5\n30 {}", first, last);
  };
  EXPECT_TRUE(test::problemsOf(readCurves(at(7, 7)), Code::EntityNotPlanar).empty());
  EXPECT_EQ(test::problemsOf(readCurves(at(7, 7.5)), Code::EntityNotPlanar).size(), 1U);
}

TEST(Spline, ThatBreaksApartIsRefused) {
  const Pattern pattern =
      readCurves("0 SPLINE\n71 1\n40 0\n40 0\n40 1\n40 1\n40 2\n40 2\n10 0\n20 0\n10 5\n20 5\n10 9\n20 9\n"
                 "10 20\n20 0");
  ASSERT_EQ(test::problemsOf(pattern, Code::SplineFlawed).size(), 1U);
}

// The frame is a square, the fitted vertices a triangle within it.
TEST(Polyline, FittedWithASplineIsReadByItsFittedVertices) {
  std::string groups = "0 POLYLINE\n66 1\n70 5\n";
  for (const auto& [flags, x, y] :
       {std::tuple(16, 0, 0), {16, 90, 0}, {16, 90, 90}, {16, 0, 90}, {8, 10, 10}, {8, 80, 10}, {8, 80, 80}}) {
    groups += fmt::format("0 VERTEX\n10 {}\n20 {}\n70 {}\n", x, y, flags);
  }
  EXPECT_NEAR(geometry::signedArea(onlyContour(readCurves(groups + "0 SEQEND"))), 2450, 1e-9);
}

TEST(Polyline, SeenFromBelowIsMirrored) {
  const Pattern pattern =
      readCurves("0 LWPOLYLINE\n90 2\n70 1\n10 0\n20 0\n42 1\n10 100\n20 0\n42 0\n210 0\n220 0\n230 -1\n"
                 "0 CIRCLE\n10 300\n20 7\n40 5\n230 -1\n0 ARC\n10 50\n20 0\n40 10\n50 0\n51 90\n230 -1");
  ASSERT_EQ(pattern.contours.size(), 2U);
  const geometry::Box circle = geometry::bounds(pattern.contours[0].curves);
  EXPECT_LT((circle.center() - Point(-300, 7)).norm(), 1e-12);
  const geometry::Box half = geometry::bounds(pattern.contours[1].curves);
  EXPECT_LT((half.min() - Point(-100, -50)).norm(), 1e-12) << "below its chord still";
  ASSERT_EQ(pattern.loose.size(), 1U);
  const geometry::Box quarter = geometry::bounds(pattern.loose[0]);
  EXPECT_LT((quarter.min() - Point(-60, 0)).norm(), 1e-12);
  EXPECT_LT((quarter.max() - Point(-50, 10)).norm(), 1e-12);
}

TEST(Polyline, LosesSegmentsWithoutLengthAndNothingElse) {
  const Pattern pattern =
      readCurves("0 LWPOLYLINE\n90 5\n70 1\n10 0\n20 0\n10 100\n20 0\n10 100\n20 0\n42 1\n10 100\n20 50\n10 0\n"
                 "20 0");
  EXPECT_NEAR(geometry::signedArea(onlyContour(pattern)), 2500 + kPi * 625 / 2, 1e-9) << "its bulge stays";
  ASSERT_EQ(pattern.repairs.size(), 2U);
  for (const base::Problem& repair : pattern.repairs) {
    EXPECT_EQ(repair.code, Code::ZeroLengthRemoved);
  }
}

} // namespace
} // namespace arris::pattern
