// The figures of Ren et al., "Corner Transition Toolpath Generation Based on Velocity-Blending Algorithm for Glass Edge
// Grinding", recomputed from the equations: the digits below come from there, not from this program.

#include "core/base/numbers.h"
#include "core/job/job.h"
#include "tests/support/panes.h"

#include <gtest/gtest.h>

namespace arris::job {
namespace {

using base::degrees;
using base::radians;
using recipe::AccelerationRule;

/// The distance that lies between two figures that agree to the last digit printed.
constexpr double lastDigit(int decimals) {
  double unit = 0.5;
  for (int i = 0; i < decimals; ++i) {
    unit /= 10;
  }
  return unit * 1.0001;
}

recipe::Recipe combined() {
  recipe::Recipe recipe;
  recipe.accelerationRule = AccelerationRule::Combined;
  return recipe;
}

Job plan(const pattern::Pattern& pattern, const recipe::Recipe& recipe) {
  Job job = planJob(pattern, recipe, recipe::Machine{});
  for (const base::Problem& problem : job.problems) {
    EXPECT_NE(base::severityOf(problem), base::Severity::Error) << base::describeWithPlace(problem);
  }
  return job;
}

TEST(PapersCase, EveryFigureOfTheSixtyDegreeCornerComesOutOfTheTriangle) {
  const Job job = plan(test::triangle600(), combined());
  ASSERT_EQ(job.toolpath.corners.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const toolpath::Corner& corner = job.toolpath.corners[i];
    const CornerResult& result = job.cornerResults[i];
    EXPECT_NEAR(degrees(corner.angle), 60, 1e-9);
    EXPECT_NEAR(corner.transitionSpeed, 20, 1e-9);
    EXPECT_NEAR(corner.blendAcceleration, 1.53960, lastDigit(5));
    EXPECT_NEAR(corner.blendTime, 12.99038, lastDigit(5));
    EXPECT_NEAR(corner.leg, 129.9038, lastDigit(4));
    EXPECT_NEAR((corner.a - corner.c).norm(), 129.9038, lastDigit(4));
    EXPECT_NEAR(corner.widest, 93.75, 1e-9);
    EXPECT_NEAR(corner.tipDepth, 0.26, 1e-9);
    EXPECT_NEAR(base::squared(75 + corner.tipDepth), 5664.07, lastDigit(2));
    EXPECT_TRUE(corner.relief);
    EXPECT_TRUE(corner.reliefEq13);
    EXPECT_NEAR(result.plannedSpeed, 20, 1e-9);
    EXPECT_NEAR(result.plannedTime, 12.99038, lastDigit(5));
    EXPECT_NEAR(result.decelerationLength, 56.5685, lastDigit(4));
    EXPECT_NEAR(result.accelerationLength, 56.5685, lastDigit(4));
    EXPECT_NEAR((result.decelerationPoint - corner.a).norm(), 56.5685, lastDigit(4));
    EXPECT_NEAR((result.accelerationPoint - corner.c).norm(), 56.5685, lastDigit(4));
    EXPECT_NEAR((result.decelerationPoint - result.accelerationPoint).norm(), 186.472, lastDigit(3));
  }
}

TEST(PapersCase, TheTransitionFollowsEquationOne) {
  const Job job = plan(test::triangle600(), combined());
  const toolpath::Corner& corner = job.toolpath.corners.front();
  // X2 points from A to S, Y2 along the incoming edge.
  const geometry::Vector y2 = (corner.q - corner.a).normalized();
  const geometry::Vector x2 = (corner.s - corner.a).normalized();
  double start = -1;
  int rows = 0;
  for (Sampler sampler(job); !sampler.done();) {
    const Sample row = sampler.next();
    if (row.corner != corner.id || row.phase != Phase::Transition) {
      continue;
    }
    if (start < 0) { // from λ = v_trans t
      start = row.setPoint.time - row.setPoint.lambda / corner.transitionSpeed;
    }
    const double t = row.setPoint.time - start;
    const geometry::Vector p = row.setPoint.position.head<2>() - corner.a;
    EXPECT_NEAR(p.dot(x2), 2.0 / 3 * t * t, 1e-8);
    EXPECT_NEAR(p.dot(y2), 20 * t - 2 / std::sqrt(3.0) * t * t, 1e-8);
    EXPECT_NEAR(row.distance, std::sqrt(75 * 75 + base::squared(1.5396007 * t * (t - 12.9903811)) * 0.75), 1e-4);
    ++rows;
  }
  EXPECT_EQ(rows, 12990);
}

TEST(PapersCase, TheTransitionPathIsAsLongAsTheMethodSays) {
  const Job job = plan(test::triangle600(), combined());
  for (const motion::Segment& segment : job.track) {
    if (segment.move == motion::Move::Transition) {
      EXPECT_NEAR(motion::arcLength(segment, motion::parameterLength(segment)), 179.28973, lastDigit(5));
    }
  }
}

struct CornerRow {
  double beta, vTrans, leg, a, tm, widest, vector, ld;
};

class OtherCorners : public testing::TestWithParam<CornerRow> {};

TEST_P(OtherCorners, ComeOutOfAPolygonWithThatAngle) {
  const CornerRow& row = GetParam();
  const Job job = plan(test::isosceles(row.beta, 1000), combined());
  const toolpath::Corner* corner = nullptr;
  for (const toolpath::Corner& candidate : job.toolpath.corners) {
    if (std::abs(degrees(candidate.angle) - row.beta) < 1e-6) {
      corner = &candidate;
    }
  }
  ASSERT_NE(corner, nullptr);
  const CornerResult& result = job.cornerResults[static_cast<std::size_t>(corner->id - 1)];
  EXPECT_EQ(corner->treatment, toolpath::Treatment::Transition);
  EXPECT_NEAR(corner->transitionSpeed, row.vTrans, lastDigit(3));
  EXPECT_NEAR(corner->leg, row.leg, lastDigit(3));
  EXPECT_NEAR(corner->blendAcceleration, row.a, row.a * 1e-4);
  EXPECT_NEAR(corner->blendTime, row.tm, lastDigit(4));
  EXPECT_NEAR(corner->widest, row.widest, lastDigit(3));
  EXPECT_TRUE(corner->relief);
  EXPECT_NEAR(result.plannedSpeed, row.vTrans, lastDigit(3));
  EXPECT_NEAR(result.plannedTime, row.tm, lastDigit(4));
  EXPECT_NEAR(result.decelerationLength, row.ld, lastDigit(3));
  EXPECT_NEAR(result.accelerationLength, row.ld, lastDigit(3));
}

INSTANTIATE_TEST_SUITE_P(Table, OtherCorners,
                         testing::Values(CornerRow{30, 10, 279.904, 0.17863, 55.9808, 154.595, 0.3451, 61.872},
                                         CornerRow{45, 15, 181.066, 0.62132, 24.1421, 112.343, 1.1481, 59.662},
                                         CornerRow{60, 20, 129.904, 1.53960, 12.9904, 93.750, 2.6667, 56.569},
                                         CornerRow{90, 30, 75.000, 6.00000, 5.0000, 79.550, 8.4853, 47.730},
                                         CornerRow{120, 40, 43.301, 18.4752, 2.1651, 75.777, 18.4752, 35.355},
                                         CornerRow{140, 46.667, 27.298, 39.8893, 1.1699, 75.145, 27.2859, 25.142}),
                         [](const auto& row) { return "Degrees" + std::to_string(static_cast<int>(row.param.beta)); });

TEST(CornerFigures, HoldForEveryRowWithAndWithoutRelief) {
  for (const CornerRow& row : {CornerRow{30, 10, 279.904, 0.17863, 55.9808, 154.595, 0.3451, 61.872},
                               CornerRow{120, 40, 43.301, 18.4752, 2.1651, 75.777, 18.4752, 35.355},
                               CornerRow{140, 46.667, 27.298, 39.8893, 1.1699, 75.145, 27.2859, 25.142},
                               CornerRow{145, 48.333, 23.647, 49.3947, 0.9785, 75.084, 29.7065, 22.343}}) {
    const toolpath::CornerFigures figures = toolpath::cornerFigures(radians(row.beta), recipe::Recipe{});
    EXPECT_NEAR(figures.transitionSpeed, row.vTrans, lastDigit(3));
    EXPECT_NEAR(figures.leg, row.leg, lastDigit(3));
    EXPECT_NEAR(figures.acceleration, row.a, row.a * 1e-4);
    EXPECT_NEAR(figures.time, row.tm, lastDigit(4));
    EXPECT_NEAR(figures.widest, row.widest, lastDigit(3));
    EXPECT_NEAR(figures.accelerationVector, row.vector, lastDigit(4));
    EXPECT_NEAR(figures.eq15, row.ld, lastDigit(3));
    EXPECT_EQ(figures.relief, row.beta < 145);
  }
}

TEST(CornerFigures, PrintedEquationThirteenRefusesFromEightyNinePointEightDegreesOn) {
  EXPECT_TRUE(toolpath::cornerFigures(radians(89.7), recipe::Recipe{}).reliefEq13);
  EXPECT_FALSE(toolpath::cornerFigures(radians(89.9), recipe::Recipe{}).reliefEq13);
}

TEST(CornerFigures, ReliefEndsAtOneHundredFortyPointFourEightDegrees) {
  EXPECT_TRUE(toolpath::cornerFigures(radians(140.47), recipe::Recipe{}).relief);
  EXPECT_FALSE(toolpath::cornerFigures(radians(140.49), recipe::Recipe{}).relief);
}

struct FixedPoint {
  double degrees, duration;
};

class TriangleUnderPerAxis : public testing::TestWithParam<FixedPoint> {};

TEST_P(TriangleUnderPerAxis, TakesTheTimeOfTheMethod) {
  const Job job =
      planJob(test::triangle600(GetParam().degrees), recipe::Recipe{}, recipe::Machine{}, toolpath::Leads::Without);
  ASSERT_TRUE(job.canBeGround());
  EXPECT_NEAR(job.working, GetParam().duration, lastDigit(3));
}

INSTANTIATE_TEST_SUITE_P(Rotated, TriangleUnderPerAxis,
                         testing::Values(FixedPoint{0, 75.614}, FixedPoint{15, 75.388}, FixedPoint{45, 74.611}),
                         [](const auto& row) { return "By" + std::to_string(static_cast<int>(row.param.degrees)); });

} // namespace
} // namespace arris::job
