// An L-shape by hand: five sharp corners and a concave one.

#include "core/job/job.h"
#include "tests/support/panes.h"
#include "tests/support/swept_glass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace arris::job {
namespace {

using base::Code;
using geometry::Point;
using toolpath::Corner;
using toolpath::CornerKind;

/// The concave corner lies at (500, 500); R = 75.
Job lShape() {
  return planJob(test::polygon({{0, 0}, {800, 0}, {800, 500}, {500, 500}, {500, 800}, {0, 800}}), {}, {});
}

double valueOf(const base::Problem& problem, std::string_view name) {
  for (const base::Value& value : problem.values) {
    if (value.name == name) {
      return std::get<double>(value.value);
    }
  }
  return std::nan("");
}

TEST(LShape, HasFiveSharpCornersAndOneConcave) {
  const Job job = lShape();
  ASSERT_TRUE(job.canBeGround());
  const std::vector<Corner>& corners = job.toolpath.corners;
  EXPECT_EQ(std::count_if(corners.begin(), corners.end(), [](const Corner& c) { return c.kind == CornerKind::Sharp; }),
            5);
  const auto concave =
      std::find_if(corners.begin(), corners.end(), [](const Corner& c) { return c.kind == CornerKind::Concave; });
  ASSERT_NE(concave, corners.end());
  EXPECT_EQ(corners.size(), 6U);
  EXPECT_LT((concave->s - (job.placement.patternOrigin + Point(500, 500))).norm(), 1e-9);
}

TEST(LShape, TheWheelPathTurnsWhereTheOffsetEdgesMeet) {
  const Job job = lShape();
  ASSERT_TRUE(job.canBeGround());
  const Point kink = job.placement.patternOrigin + Point(575, 575);
  double nearest = 1e9;
  for (const toolpath::PathSegment& piece : job.toolpath.chains.front().segments) {
    const double length = geometry::parameterLength(piece.shape);
    for (const double lambda : {0.0, length / 2, length}) {
      nearest = std::min(nearest, (geometry::pointAt(piece.shape, lambda) - kink).norm());
    }
  }
  EXPECT_LT(nearest, 0.5e-3);
}

TEST(LShape, WarnsOfTheFilletWithItsPlaceAndSize) {
  const Job job = lShape();
  const auto warning = std::find_if(job.problems.begin(), job.problems.end(),
                                    [](const base::Problem& p) { return p.code == Code::ConcaveFillet; });
  ASSERT_NE(warning, job.problems.end());
  EXPECT_EQ(base::severityOf(*warning), base::Severity::Warning);
  ASSERT_TRUE(warning->where);
  EXPECT_LT((*warning->where - (job.placement.patternOrigin + Point(500, 500))).norm(), 1e-9);
  EXPECT_NEAR(valueOf(*warning, "fillet_mm"), 75 * std::sqrt(2.0) - 75, 1e-3); // 31.066
  EXPECT_NEAR(valueOf(*warning, "unground_mm"), 75, 1e-2);
}

TEST(LShape, IsGroundOnAllThatTheWheelReaches) {
  const Job job = lShape();
  ASSERT_TRUE(job.canBeGround());
  EXPECT_TRUE(test::grindsAllAndOnlyTheEdge(job));
}

TEST(LShape, StaysUngroundForTheWheelRadiusOnBothEdgesOfTheConcaveCorner) {
  const Job job = lShape();
  ASSERT_TRUE(job.canBeGround());
  const auto touched = [&](const Point& inDrawing) {
    const Point p = job.placement.patternOrigin + inDrawing;
    const auto& pieces = job.toolpath.chains.front().segments;
    return std::any_of(pieces.begin(), pieces.end(), [&](const toolpath::PathSegment& piece) {
      return !std::holds_alternative<geometry::Parabola>(piece.shape) &&
             geometry::nearest(piece.shape, p).distance <= 75 + 1e-3;
    });
  };
  EXPECT_TRUE(touched({575.5, 500}));
  EXPECT_FALSE(touched({574, 500}));
  EXPECT_TRUE(touched({500, 575.5}));
  EXPECT_FALSE(touched({500, 574}));
}

} // namespace
} // namespace arris::job
