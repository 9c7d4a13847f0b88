#include "core/control/absent_axes.h"
#include "tests/support/bench.h"

#include <gtest/gtest.h>

namespace arris::control {
namespace {

TEST(AbsentAxes, NeverGetReadyAndMoveNothingHoweverTheyAreAsked) {
  const recipe::Machine machine;
  test::Bench bench(machine, std::make_unique<AbsentAxes>());
  bool wasReady = false;
  bench.onPeriod = [&](const Report& report, const Cycle&) {
    wasReady = wasReady || report.drivesReady || report.homed || report.measuredTick >= 0;
  };
  bench.runFor(0.1);
  EXPECT_EQ(bench.report().state, State::Off);
  ASSERT_TRUE(bench.supervisor.enable());
  ASSERT_TRUE(bench.until(State::Faulted, 5)) << "as where the drives' supply is off";
  EXPECT_FALSE(bench.faults.empty());
  bench.supervisor.home();
  bench.supervisor.jogAt({10, 0, 0});
  bench.runFor(2);
  EXPECT_EQ(bench.report().state, State::Faulted);
  EXPECT_FALSE(wasReady);
}

} // namespace
} // namespace arris::control
