#include "core/control/simulated_services.h"

#include <gtest/gtest.h>

#include <cmath>

namespace arris::control {
namespace {

constexpr double kServicePeriod = 0.001;

/// Seconds until the spindle is at the speed commanded, 10 at most.
double timeToSpeed(SimulatedSpindle& spindle, double command) {
  int periods = 0;
  do {
    spindle.step(command);
    ++periods;
  } while (!spindle.atSpeed() && periods < 10000);
  return periods * kServicePeriod;
}

TEST(SimulatedSpindle, IsAtSpeedOneAndAHalfSecondsAfterItWasSwitchedOn) {
  for (const double command : {500.0, 6000.0, 60000.0}) {
    SimulatedSpindle spindle(kServicePeriod);
    EXPECT_NEAR(timeToSpeed(spindle, command), 1.5, 1.5 * kServicePeriod);
    EXPECT_NEAR(spindle.speed(), 0.98 * command, 1e-3 * command);
  }
}

TEST(SimulatedSpindle, TakesTheTimeOfAFirstOrderToAnotherSpeed) {
  SimulatedSpindle spindle(kServicePeriod);
  for (int i = 0; i < 20000; ++i) {
    spindle.step(3000);
  }
  EXPECT_NEAR(timeToSpeed(spindle, 6000), 1.5 * std::log(3000 / 120.0) / std::log(50), 1.5 * kServicePeriod);
  EXPECT_NEAR(timeToSpeed(spindle, 5950), kServicePeriod, 1e-12) << "within 2 % of it as it is";
}

TEST(SimulatedSpindle, CoastsDownInFourSecondsAndIsNeverAtSpeedThen) {
  SimulatedSpindle spindle(kServicePeriod);
  timeToSpeed(spindle, 6000);
  const double speed = spindle.speed();
  for (int i = 0; i < 4000; ++i) {
    const double before = spindle.speed();
    spindle.step(0);
    EXPECT_LT(spindle.speed(), before);
    EXPECT_FALSE(spindle.atSpeed());
  }
  EXPECT_NEAR(spindle.speed(), 0.02 * speed, 1e-6 * speed);
}

TEST(DelayedSignal, ComesAndGoesAfterItsDelaysAndPassesOverShorterChanges) {
  for (const double period : {0.00025, 0.001, 0.005, 0.02}) {
    DelayedSignal signal(0.5, 0.2);
    const auto hold = [&](bool cause, double seconds) {
      for (int i = 0; i < std::lround(seconds / period); ++i) {
        signal.step(cause, period);
      }
      return signal.is();
    };
    EXPECT_FALSE(hold(true, 0.48));
    EXPECT_FALSE(hold(false, 0.02));
    EXPECT_FALSE(hold(true, 0.48));
    EXPECT_TRUE(hold(true, 0.02));
    EXPECT_TRUE(hold(false, 0.18));
    EXPECT_TRUE(hold(true, 0.02));
    EXPECT_TRUE(hold(false, 0.18));
    EXPECT_FALSE(hold(false, 0.02));
  }
}

TEST(DelayedSignal, WithoutDelayGoesAtOnce) {
  DelayedSignal signal(0.05, 0);
  for (int i = 0; i < 50; ++i) {
    EXPECT_FALSE(signal.is());
    signal.step(true, 0.001);
  }
  EXPECT_TRUE(signal.is());
  signal.step(false, 0.001);
  EXPECT_FALSE(signal.is());
}

} // namespace
} // namespace arris::control
