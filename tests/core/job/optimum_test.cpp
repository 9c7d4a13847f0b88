// The planned time against the time-optimal one under the same limits, calculated independently on a fine grid.

#include "tests/support/fine_grid_optimum.h"
#include "tests/support/panes.h"
#include "tests/support/random_panes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace arris::job {
namespace {

double optimumOf(const Job& job, double step) {
  const auto works = [](const motion::Segment& segment) { return segment.number > 0; };
  const auto first = std::find_if(job.track.begin(), job.track.end(), works);
  const auto last = std::find_if_not(first, job.track.end(), works);
  return test::fineGridOptimum(job.track, static_cast<std::size_t>(first - job.track.begin()),
                               static_cast<std::size_t>(last - job.track.begin()), job.limits, step);
}

TEST(FineGrid, GivesTheTimesOfTheMethodForTheTriangle) {
  for (const auto& [degrees, duration] : {std::pair{0.0, 75.614}, {15.0, 75.388}, {45.0, 74.611}}) {
    const Job job = planJob(test::triangle600(degrees), recipe::Recipe{}, recipe::Machine{}, toolpath::Leads::Without);
    EXPECT_NEAR(optimumOf(job, 0.01), duration, 0.01);
  }
}

// A roll of 5° under the default recipe: the case in which the plain optimum could not brake, 69.076 s on its pane.
class Optimum : public testing::TestWithParam<int> {};

TEST_P(Optimum, IsReachedWithinATenthOfAPercent) {
  std::uint64_t seed = 1000 * static_cast<std::uint64_t>(GetParam()) + 500;
  const Job job = test::randomJob(seed);
  SCOPED_TRACE(fmt::format("seed {}", seed - 1));
  const double optimum = optimumOf(job, 0.02);
  EXPECT_LE(job.working, optimum * 1.001);
  EXPECT_GE(job.working, optimum * 0.999);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Optimum, testing::Range(0, 40));

} // namespace
} // namespace arris::job
