// What holds for every pane with concave corners, hollows, notches and cut-outs, over seeded random drawings.

#include "core/base/numbers.h"
#include "core/job/job.h"
#include "tests/support/random_glass.h"
#include "tests/support/swept_glass.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

namespace arris::job {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kDrawings = 48;
#else
constexpr int kDrawings = 240;
#endif

/// Of the drawings at least this share must be planned, so that the properties are not those of nothing.
constexpr double kLeastPlanned = 1.0 / 3;
constexpr double kLeastPlannedAccepted = 0.9;

/// Every so many planned drawings one is followed row by row.
constexpr int kFollowed = 6;

/// Each error has its place or line. (That the wheel reaches nothing at all has none, and cannot be: any wheel reaches
/// an outline from outside.)
void expectRefusedWithAPlace(const Job& job) {
  for (const base::Problem& problem : job.problems) {
    EXPECT_TRUE(base::severityOf(problem) != base::Severity::Error || problem.where || problem.line)
        << base::describe(problem);
  }
}

/// How many of the drawings were planned and given to `check`; the others were refused in words.
template <class Check> int forEachPlanned(const test::GlassOptions& options, std::uint64_t firstSeed, Check check) {
  int count = 0;
  for (std::uint64_t seed = firstSeed; seed < firstSeed + kDrawings; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const Job job = test::planned(test::randomGlass(seed, options));
    if (job.canBeGround()) {
      ++count;
      check(job);
    } else {
      expectRefusedWithAPlace(job);
    }
  }
  return count;
}

/// From lead-in to lead-out in one piece, tangentially but for exact stops.
void expectG1(const Job& job) {
  for (const toolpath::Chain& chain : job.toolpath.chains) {
    ASSERT_FALSE(chain.segments.empty());
    EXPECT_EQ(chain.segments.front().role, toolpath::Role::LeadIn);
    EXPECT_EQ(chain.segments.back().role, toolpath::Role::LeadOut);
    for (std::size_t i = 1; i < chain.segments.size(); ++i) {
      const geometry::Curve& before = chain.segments[i - 1].shape;
      const geometry::Curve& after = chain.segments[i].shape;
      const geometry::Point joint = geometry::startPoint(after);
      EXPECT_LT((geometry::endPoint(before) - joint).norm(), 1e-9) << "segment " << i;
      const double bend = (geometry::endTangent(before) - geometry::startTangent(after)).norm();
      EXPECT_TRUE(bend < 1e-9 || chain.segments[i - 1].stopAtEnd) << "segment " << i << " bends by " << bend;
    }
  }
}

void expectDownAndUpClearOfTheBlank(const Job& job) {
  const double clear = job.recipe.wheelRadius + job.recipe.depth + 1 - 1e-6;
  for (const toolpath::Chain& chain : job.toolpath.chains) {
    const geometry::Point down = geometry::startPoint(chain.segments.front().shape);
    const geometry::Point up = geometry::endPoint(chain.segments.back().shape);
    EXPECT_GE(test::distanceFromGlass(job.contours, down), clear) << down.transpose();
    EXPECT_GE(test::distanceFromGlass(job.contours, up), clear) << up.transpose();
  }
}

/// Second differences of the rows at 1 ms against the acceleration of each axis.
void expectWithinAxisLimits(const Job& job) {
  constexpr double kPeriod = 0.001;
  constexpr double kRounding = 1e-6; // mm/s², of a second difference in double precision
  std::array<Sample, 3> last;
  std::size_t rows = 0;
  Eigen::Vector3d worst = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());
  for (Sampler sampler(job, kPeriod); !sampler.done();) {
    last = {last[1], last[2], sampler.next()};
    if (++rows < 3 || sampler.done()) { // the last row may come early
      continue;
    }
    const Eigen::Vector3d second =
        (last[0].setPoint.position - 2 * last[1].setPoint.position + last[2].setPoint.position) /
        base::squared(kPeriod);
    worst = worst.cwiseMax(second.cwiseAbs() - job.limits.acceleration);
  }
  EXPECT_GT(rows, 1000U);
  EXPECT_LE(worst.maxCoeff(), kRounding);
}

TEST(Glass, IsGroundOnAllThatTheWheelReachesAndNowhereElse) {
  for (const bool splines : {false, true}) {
    SCOPED_TRACE(splines ? "with splines" : "lines and arcs");
    const std::uint64_t first = splines ? 100000 : 1;
    const int planned = forEachPlanned({splines, false}, first, [](const Job& job) {
      EXPECT_TRUE(test::grindsAllAndOnlyTheEdge(job));
      expectG1(job);
      expectDownAndUpClearOfTheBlank(job);
    });
    EXPECT_GE(planned, kLeastPlanned * kDrawings);
    RecordProperty(splines ? "planned_with_splines" : "planned", planned);
  }
}

// Then pockets that the wheel does not enter stay; whatever it enters it grinds.
TEST(Glass, WithUnreachedPartsAcceptedIsGroundInEveryRoomThatTheWheelEnters) {
  const int planned = forEachPlanned({false, true}, 1, [](const Job& job) {
    EXPECT_TRUE(test::grindsAllAndOnlyTheEdge(job, test::Unentered::Accepted));
    expectG1(job);
    expectDownAndUpClearOfTheBlank(job);
  });
  EXPECT_GE(planned, kLeastPlannedAccepted * kDrawings);
  RecordProperty("planned", planned);
}

TEST(Glass, IsGroundWithinTheLimitsOfTheAxes) {
  int count = 0;
  const int planned = forEachPlanned({}, 1, [&count](const Job& job) {
    if (count++ % kFollowed == 0) {
      expectWithinAxisLimits(job);
    }
  });
  EXPECT_GE(planned, kLeastPlanned * kDrawings);
}

} // namespace
} // namespace arris::job
