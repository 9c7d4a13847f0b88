#include "core/control/simulated_axis.h"
#include "tests/support/dice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace arris::control {
namespace {

constexpr double kPlantPeriods[] = {0.00025, 0.001, 0.0015, 0.004, 0.02}; // s

recipe::Machine machineWithPeriod(double period) {
  recipe::Machine machine;
  machine.period = period;
  return machine;
}

/// A way at rest first, then with accelerations that change now and then, none above `most`, no faster than 60 mm/s.
class WanderingWay {
public:
  WanderingWay(std::uint64_t seed, double from, double most) : m_dice(seed), m_place(from), m_most(most) {}

  double after(double time) {
    while (time > 0) {
      if (m_left <= 0) {
        choose();
      }
      const double part = std::min(time, m_left);
      m_place += (m_speed + m_acceleration * part / 2) * part;
      m_speed += m_acceleration * part;
      m_left -= part;
      time -= part;
    }
    return m_place;
  }

private:
  void choose() {
    const double speed = m_dice.between(-60, 60);
    m_acceleration = std::copysign(m_dice.between(0.1, 1) * m_most, speed - m_speed);
    m_left = std::abs((speed - m_speed) / m_acceleration);
  }

  test::Dice m_dice;
  double m_place, m_most;
  double m_speed = 0, m_acceleration = 0, m_left = 0.3;
};

TEST(SimulatedAxis, FollowsSmoothMotionWithinFiveHundredths) {
  for (const double period : kPlantPeriods) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      for (const double most : {20.0, 500.0}) {
        const recipe::Machine machine = machineWithPeriod(period);
        SimulatedAxis axis(machine, 0, 700);
        WanderingWay way(seed, 700, most);
        double worst = 0;
        for (double time = 0; time < 20; time += period) {
          const double setPoint = way.after(period);
          axis.step(setPoint, AxisMode::Follows);
          worst = std::max(worst, std::abs(setPoint - axis.place()));
        }
        // At 20 ms the parabolas through so few set-points meet in corners that the machine's acceleration cannot take.
        EXPECT_LT(worst, period > 0.004 && most > 20 ? 0.5 : 0.05)
            << period << " s, seed " << seed << ", " << most << " mm/s²";
        if (most == 20) {
          // The impulse response of a critically damped loop has one sign, so nothing exceeds the error of a constant
          // acceleration but by the corner that two parabolas make where the acceleration changes.
          EXPECT_LT(worst, most / std::pow(kServoFrequency, 2) * (1 + kServoFrequency * period / std::numbers::e));
        }
      }
    }
  }
}

TEST(SimulatedAxis, LiesBehindByTheAccelerationOverOmegaSquared) {
  for (const double period : kPlantPeriods) {
    for (const double acceleration : {20.0, -20.0, 200.0}) {
      SimulatedAxis axis(machineWithPeriod(period), 1, 1000);
      double setPoint = 1000;
      for (int i = 1; i * period <= 0.5; ++i) {
        setPoint = 1000 + acceleration * std::pow(i * period, 2) / 2;
        axis.step(setPoint, AxisMode::Follows);
      }
      EXPECT_NEAR(setPoint - axis.place(), acceleration / std::pow(2 * std::numbers::pi * 40, 2), 1e-9) << period;
    }
  }
}

TEST(SimulatedAxis, LiesNotBehindAtAConstantSpeed) {
  SimulatedAxis axis(recipe::Machine{}, 0, 0);
  for (int i = 1; i <= 1000; ++i) {
    axis.step(i * 0.06, AxisMode::Follows);
  }
  EXPECT_NEAR(axis.place(), 60, 1e-9);
  EXPECT_NEAR(axis.speed(), 60, 1e-6);
}

TEST(SimulatedAxis, NeverExceedsItsSaturationsWhateverIsCommanded) {
  for (const double period : kPlantPeriods) {
    for (int axisNumber = 0; axisNumber < 3; ++axisNumber) {
      test::Dice dice(static_cast<std::uint64_t>(axisNumber));
      const recipe::Machine machine = machineWithPeriod(period);
      const double maxSpeed = 1.1 * machine.maxSpeed[axisNumber] / 60;
      const double maxAccel = 1.2 * machine.maxAccel[axisNumber];
      SimulatedAxis axis(machine, axisNumber, 50);
      double setPoint = 50;
      AxisMode mode = AxisMode::Follows;
      double fastest = 0;
      for (int i = 0; i < 40000; ++i) {
        if (dice.chance(0.01)) {
          setPoint = dice.between(0, machine.travel[axisNumber]);
          mode = dice.chance(0.7) ? AxisMode::Follows : AxisMode::Brakes;
        }
        const double place = axis.place();
        const double speed = axis.speed();
        axis.step(setPoint + (dice.chance(0.1) ? dice.between(-5, 5) : 0), mode);
        ASSERT_LE(std::abs(axis.speed()), maxSpeed);
        ASSERT_LE(std::abs(axis.speed() - speed), maxAccel * period * (1 + 1e-9));
        ASSERT_LE(std::abs(axis.place() - place), maxSpeed * period * (1 + 1e-9));
        fastest = std::max(fastest, std::abs(axis.speed()));
      }
      EXPECT_GT(fastest, 0.5 * maxSpeed) << "it did get near them";
    }
  }
}

TEST(SimulatedAxis, ComesToRestWithoutOscillationWhereverItsSetPointJumps) {
  for (const double period : kPlantPeriods) {
    for (const double jump : {0.001, 0.03, -0.1, 1.0, -10.0, 100.0, -600.0}) {
      SimulatedAxis axis(machineWithPeriod(period), 0, 700);
      double beyond = 0; // as a share of the jump
      int passes = 0;
      double before = -1;
      for (double time = 0; time < 6; time += period) {
        axis.step(700 + jump, AxisMode::Follows);
        const double after = (axis.place() - 700 - jump) / jump;
        if (std::abs(after) > 1e-6) {
          passes += after * before < 0;
          before = after;
        }
        beyond = std::max(beyond, after);
      }
      EXPECT_LE(beyond, std::abs(jump) < 1 ? 0.3 : 1e-9) << jump << " mm, " << period << " s";
      EXPECT_LE(passes, 2) << jump << " mm, " << period << " s";
      for (double time = 0; time < 1; time += period) {
        axis.step(700 + jump, AxisMode::Follows);
        ASSERT_NEAR(axis.place(), 700 + jump, 1e-9);
        ASSERT_NEAR(axis.speed(), 0, 1e-6);
      }
    }
  }
}

TEST(SimulatedAxis, BrakesByFrictionWhereItsDriveIsOffAndStays) {
  for (const double speed : {60.0, -60.0}) {
    const recipe::Machine machine;
    SimulatedAxis axis(machine, 0, 700);
    double setPoint = 700;
    while (std::abs(setPoint - 700) < 60) {
      axis.step(setPoint += speed * machine.period, AxisMode::Follows);
    }
    const double place = axis.place();
    const double start = axis.speed();
    const auto brake = [&] { axis.step(setPoint += speed * machine.period, AxisMode::Brakes); };
    for (double time = 0; time < 0.1; time += machine.period) {
      brake();
    }
    EXPECT_NEAR(axis.speed(), start - std::copysign(500 * 0.1, speed), 1); // mm/s
    for (double time = 0; time < 0.1; time += machine.period) {
      brake();
    }
    EXPECT_EQ(axis.speed(), 0);
    EXPECT_NEAR(axis.place() - place, std::copysign(60 * 60 / (2 * 500.0), speed), 0.01);
    const double rest = axis.place();
    for (int i = 0; i < 1000; ++i) {
      brake();
    }
    EXPECT_EQ(axis.place(), rest);
  }
}

TEST(SimulatedAxis, IsAtOnceWhereItWasWhenItIsStuck) {
  SimulatedAxis axis(recipe::Machine{}, 0, 700);
  double setPoint = 700;
  for (int i = 0; i < 1000; ++i) {
    axis.step(setPoint += 0.06, AxisMode::Follows);
  }
  const double place = axis.place();
  for (int i = 0; i < 1000; ++i) {
    axis.step(setPoint += 0.06, AxisMode::Stuck);
    ASSERT_EQ(axis.place(), place);
    ASSERT_EQ(axis.speed(), 0);
  }
}

struct SwitchSide {
  double homeAt;
  bool low; ///< the nearer end of the travel of 1500 mm
};

TEST(SimulatedAxis, TheReferenceSwitchIsOnFromItsPlaceToTheNearerEnd) {
  for (const auto& [homeAt, low] : {SwitchSide{0, true}, {30, true}, {750, true}, {751, false}, {1500, false}}) {
    recipe::Machine machine;
    machine.homeAt.x() = homeAt;
    const auto onAt = [&](double place) { return SimulatedAxis(machine, 0, place).onReference(); };
    EXPECT_TRUE(onAt(homeAt)) << homeAt;
    EXPECT_EQ(onAt(homeAt - 0.001), low) << homeAt;
    EXPECT_EQ(onAt(homeAt + 0.001), !low) << homeAt;
    EXPECT_EQ(onAt(-15), low) << homeAt;
    EXPECT_EQ(onAt(1515), !low) << homeAt;
  }
}

TEST(SimulatedAxis, LimitSwitchesLieTenMillimetresOutsideTheTravel) {
  const recipe::Machine machine;
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = [&](double place) { return SimulatedAxis(machine, axis, place); };
    const double travel = machine.travel[axis];
    EXPECT_TRUE(at(-10).onLimitLow());
    EXPECT_FALSE(at(-9.999).onLimitLow());
    EXPECT_FALSE(at(travel + 9.999).onLimitHigh());
    EXPECT_TRUE(at(travel + 10).onLimitHigh());
    EXPECT_FALSE(at(-10).onLimitHigh());
    EXPECT_FALSE(at(travel + 10).onLimitLow());
  }
}

TEST(SimulatedAxis, StopsDeadTwentyMillimetresOutsideTheTravel) {
  for (const auto& [target, end] : {std::pair{-300.0, -20.0}, {1800.0, 1520.0}}) {
    for (const AxisMode mode : {AxisMode::Follows, AxisMode::Brakes}) {
      SimulatedAxis axis(recipe::Machine{}, 0, target < 0 ? 60 : 1440);
      double setPoint = axis.place();
      const double step = target < 0 ? -0.2 : 0.2;
      while (std::abs(axis.place() - end) > 5) { // at 200 mm/s friction takes 40 mm
        axis.step(setPoint += step, AxisMode::Follows);
      }
      for (int i = 0; i < 1000; ++i) {
        axis.step(target, mode);
        ASSERT_TRUE(axis.place() >= -20 && axis.place() <= 1520);
      }
      EXPECT_EQ(axis.place(), end);
      EXPECT_EQ(axis.speed(), 0);
    }
  }
}

} // namespace
} // namespace arris::control
