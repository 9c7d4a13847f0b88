#include "core/control/simulated_axes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <thread>
#include <tuple>
#include <vector>

namespace arris::control {
namespace {

using Eigen::Vector3d;

const Vector3d kPowerUpPlace{700, 1200, 60}; // table

recipe::Machine machineOf(double period, double lead) {
  recipe::Machine machine;
  machine.period = period;
  machine.setPointLead = lead;
  return machine;
}

/// The simulated machine at the simulated pace under the hand of a test, with all outputs on.
struct DrivenMachine {
  explicit DrivenMachine(const Vector3d& standsAt = kPowerUpPlace, recipe::Machine description = {})
      : machine(std::move(description)), axes(machine, Pace::Simulated, standsAt) {
    outputs.driveEnable.fill(true);
    outputs.spindleSpeed = 6000;
    outputs.coolant = true;
  }

  /// Set-points at a constant velocity.
  void go(double seconds, const Vector3d& velocity = Vector3d::Zero()) {
    for (int i = 0; i < std::lround(seconds / machine.period); ++i) {
      setPoint += velocity * machine.period;
      ASSERT_TRUE(axes.write(setPoint, outputs));
    }
  }

  [[nodiscard]] Inputs inputs() {
    return axes.read().inputs;
  }

  recipe::Machine machine;
  SimulatedAxes axes;
  Outputs outputs;
  Vector3d setPoint{0, 0, 0};
};

/// The simulated machine by a clock that the test turns.
struct ClockedMachine {
  explicit ClockedMachine(const recipe::Machine& machine)
      : axes(machine, Pace::Real, kPowerUpPlace, Vector3d::Zero(), [this] { return now; }) {
    outputs.driveEnable.fill(true);
  }

  bool write(double x) {
    return axes.write({x, 0, 0}, outputs);
  }

  double now = 1234.5;
  SimulatedAxes axes;
  Outputs outputs;
};

TEST(SimulatedAxes, LagByExactlyTheLeadAtTheSimulatedPace) {
  for (const auto& [period, lead, periods] :
       {std::tuple{0.001, 0.03, 30}, {0.00025, 0.2, 800}, {0.003, 0.01, 3}, {0.02, 0.03, 2}, {0.02, 0.001, 1}}) {
    SimulatedAxes axes(machineOf(period, lead), Pace::Simulated, kPowerUpPlace);
    EXPECT_EQ(axes.read().tick, -1);
    for (int i = 0; i < 10000; ++i) {
      ASSERT_TRUE(axes.write({0, 0, 0}, {}));
      ASSERT_EQ(axes.read().tick, std::max(i - periods, -1)) << period;
      ASSERT_EQ(axes.queued(), std::min(i + 1, periods)) << period;
    }
    EXPECT_EQ(axes.read().underruns, 0);
  }
}

TEST(SimulatedAxes, ReportWithATickThePlaceForItsSetPoint) {
  DrivenMachine driven;
  driven.go(0.1);
  std::vector<double> setPoints(100, 0.0);
  for (int i = 1; i <= 2000; ++i) {
    driven.setPoint.x() = 10 * std::pow(i * 0.001, 2); // 20 mm/s²
    setPoints.push_back(driven.setPoint.x());
    ASSERT_TRUE(driven.axes.write(driven.setPoint, driven.outputs));
    const Feedback feedback = driven.axes.read();
    const double behind = setPoints[static_cast<std::size_t>(feedback.tick)] - feedback.position.x();
    if (i > 100) {
      ASSERT_NEAR(behind, 20 / std::pow(2 * std::numbers::pi * 40, 2), 0.51e-4);
    }
  }
}

TEST(SimulatedAxes, EncodersReadFromPowerUpInStepsOfATenthOfAMicrometre) {
  const Vector3d startReading{5, -7.5, 0.25};
  SimulatedAxes axes(recipe::Machine{}, Pace::Simulated, kPowerUpPlace, startReading);
  EXPECT_EQ(axes.read().position, startReading);
  EXPECT_EQ(SimulatedAxes(recipe::Machine{}, Pace::Simulated, kPowerUpPlace).read().position, Vector3d::Zero());
  Outputs outputs;
  outputs.driveEnable.fill(true);
  Vector3d setPoint = startReading;
  for (int i = 0; i < 5000; ++i) {
    setPoint += i < 2000 ? Vector3d(0.00123, -0.02, 0.00711) : Vector3d(0, 0, 0);
    axes.write(setPoint, outputs);
    const Vector3d reading = axes.read().position;
    for (int axis = 0; axis < kAxes; ++axis) {
      ASSERT_NEAR(reading[axis] / 1e-4, std::round(reading[axis] / 1e-4), 1e-6);
      ASSERT_NEAR(reading[axis] - startReading[axis], axes.place()[axis] - kPowerUpPlace[axis], 0.5e-4 + 1e-9);
    }
  }
  EXPECT_LE((axes.read().position - setPoint).cwiseAbs().maxCoeff(), 0.5e-4 + 1e-9);
}

TEST(SimulatedAxes, ReadTheSamePlaceForGoodOnceTheyAreAtRest) {
  DrivenMachine driven;
  driven.go(0.1);
  driven.go(1, {60.0123, 30.057, -20});
  driven.go(0.5);
  const Vector3d rest = driven.axes.read().position;
  EXPECT_LE((rest - driven.setPoint).cwiseAbs().maxCoeff(), 1e-4);
  for (int i = 0; i < 5000; ++i) {
    driven.go(0.001);
    ASSERT_EQ(driven.axes.read().position, rest);
  }
}

TEST(SimulatedAxes, TakeASetPointEachPeriodOfTheClockFromTheLeadOn) {
  for (const auto& [period, lead, periods] : {std::tuple{0.001, 0.03, 30}, {0.00025, 0.01, 40}, {0.02, 0.001, 1}}) {
    ClockedMachine clocked(machineOf(period, lead));
    const double start = clocked.now;
    for (int i = 0; i < 3000; ++i) {
      clocked.now = start + i * period;
      ASSERT_TRUE(clocked.write(0));
      ASSERT_EQ(clocked.axes.read().tick, std::max(i - periods, -1)) << period;
      ASSERT_LE(clocked.axes.queued(), periods);
      clocked.now = start + (i + 0.99) * period;
      ASSERT_EQ(clocked.axes.read().tick, std::max(i - periods, -1)) << period;
    }
    EXPECT_EQ(clocked.axes.read().underruns, 0);
  }
}

TEST(SimulatedAxes, StandStillBeforeTheFirstWriteWhateverTheClockSays) {
  ClockedMachine clocked(machineOf(0.001, 0.03));
  clocked.now += 100;
  EXPECT_EQ(clocked.axes.read().underruns, 0);
  clocked.write(0);
  EXPECT_EQ(clocked.axes.read().tick, -1);
  EXPECT_EQ(clocked.axes.queued(), 1);
}

TEST(SimulatedAxes, CountUnderrunsKeepToTheLastSetPointAndGoOnWithTheNext) {
  ClockedMachine clocked(machineOf(0.001, 0.03));
  const double start = clocked.now;
  for (int i = 0; i < 1000; ++i) { // all at once, but for the drive's sake
    ASSERT_TRUE(clocked.write(i < 500 ? 0 : (i - 500) * 0.02));
  }
  clocked.now = start + 1.029; // set-point 999 is due
  EXPECT_EQ(clocked.axes.read().tick, 999);
  EXPECT_EQ(clocked.axes.read().underruns, 0);
  clocked.now = start + 1.036;
  EXPECT_EQ(clocked.axes.queued(), 0);
  EXPECT_EQ(clocked.axes.read().underruns, 7);
  EXPECT_EQ(clocked.axes.read().tick, 999);
  clocked.now = start + 2.036;
  EXPECT_EQ(clocked.axes.read().underruns, 1007);
  EXPECT_NEAR(clocked.axes.read().position.x(), 499 * 0.02, 1e-4);
  ASSERT_TRUE(clocked.write(499 * 0.02));
  EXPECT_EQ(clocked.axes.queued(), 1);
  clocked.now = start + 2.037;
  EXPECT_EQ(clocked.axes.read().tick, 1000);
  EXPECT_EQ(clocked.axes.read().underruns, 1007);
}

TEST(SimulatedAxes, HoldSetPointsForASecondAndTakeNothingWhenFull) {
  ClockedMachine clocked(machineOf(0.001, 0.03));
  const double start = clocked.now;
  int written = 0;
  while (written < 100000 && clocked.write(0)) {
    ++written;
  }
  EXPECT_GE(written, 1000);
  EXPECT_EQ(clocked.axes.queued(), written);
  clocked.outputs.driveEnable.fill(false);
  EXPECT_FALSE(clocked.write(0));
  clocked.now = start + 0.5;
  EXPECT_TRUE(clocked.axes.read().inputs.driveReady[0]) << "the outputs of a refused write are not taken either";
  EXPECT_EQ(clocked.axes.queued(), written - 471);
  EXPECT_TRUE(clocked.write(0));
  clocked.now = start + 100;
  EXPECT_EQ(clocked.axes.read().tick, written) << "every set-point written, none twice";
}

TEST(SimulatedAxes, ADriveIsReadyFiftyMillisecondsAfterItWasEnabled) {
  DrivenMachine driven;
  driven.outputs.driveEnable = {true, false, true};
  driven.go(0.03 + 0.049); // the first 30 ms fill the lead
  EXPECT_EQ(driven.inputs().driveReady, (std::array{false, false, false}));
  driven.go(0.001);
  EXPECT_EQ(driven.inputs().driveReady, (std::array{true, false, true}));
  driven.outputs.driveEnable[2] = false;
  driven.go(0.001);
  EXPECT_EQ(driven.inputs().driveReady, (std::array{true, false, false}));
}

TEST(SimulatedAxes, AnAxisWithoutItsDriveStaysAndComesBackWithinItsLimits) {
  DrivenMachine driven;
  driven.outputs.driveEnable[1] = false;
  driven.go(0.2);
  driven.go(1, {50, 50, 0});
  driven.go(0.5);
  EXPECT_NEAR(driven.axes.place().x(), kPowerUpPlace.x() + 50, 1e-4);
  EXPECT_EQ(driven.axes.place().y(), kPowerUpPlace.y());
  driven.outputs.driveEnable[1] = true;
  double speed = 0;
  for (int i = 0; i < 3000; ++i) {
    const double before = driven.axes.place().y();
    driven.go(0.001);
    const double next = (driven.axes.place().y() - before) / 0.001;
    ASSERT_LE(std::abs(next), 220 + 1e-6);              // 1.1 × 12000 mm/min
    ASSERT_LE(std::abs(next - speed) / 0.001, 600 + 1); // 1.2 × 500 mm/s²
    ASSERT_LE(driven.axes.place().y(), kPowerUpPlace.y() + 50 + 5e-5);
    speed = next;
  }
  EXPECT_NEAR(driven.axes.place().y(), kPowerUpPlace.y() + 50, 1e-4);
}

TEST(SimulatedAxes, FindTheReferenceSwitchesOnBothSides) {
  recipe::Machine machine;
  machine.homeAt = {20, 2480, 110};
  DrivenMachine driven({40, 2460, 90}, machine);
  driven.go(0.2);
  EXPECT_EQ(driven.inputs().reference, (std::array{false, false, false}));
  std::array<bool, kAxes> seen{};
  for (int i = 0; i < 5000; ++i) {
    driven.go(0.001, {-5, 5, 5});
    const Feedback feedback = driven.axes.read();
    for (int axis = 0; axis < kAxes; ++axis) {
      const auto n = static_cast<std::size_t>(axis);
      if (feedback.inputs.reference[n] && !seen[n]) {
        EXPECT_NEAR(feedback.position[axis], axis == 0 ? -20 : 20, 0.005 + 1e-4) << axis; // of a period
        seen[n] = true;
      }
      ASSERT_EQ(feedback.inputs.reference[n], seen[n]) << "it stays on towards the end";
    }
  }
  EXPECT_EQ(seen, (std::array{true, true, true}));
}

TEST(SimulatedAxes, LimitSwitchesAreToldForTheirAxisAndSide) {
  DrivenMachine driven({2, 2498, 60});
  driven.go(0.2);
  driven.go(1.3, {-10, 10, 0});
  EXPECT_EQ(driven.inputs().limitLow, (std::array{true, false, false}));
  EXPECT_EQ(driven.inputs().limitHigh, (std::array{false, true, false}));
}

TEST(SimulatedAxes, SpindleAndCoolantComeAfterTheirTimes) {
  DrivenMachine driven;
  driven.outputs.spindleSpeed = 0;
  driven.outputs.coolant = false;
  driven.go(0.1);
  EXPECT_FALSE(driven.inputs().spindleAtSpeed || driven.inputs().coolantFlows);
  driven.outputs.spindleSpeed = 6000;
  driven.outputs.coolant = true;
  driven.go(0.499);
  EXPECT_FALSE(driven.inputs().coolantFlows);
  driven.go(0.001);
  EXPECT_TRUE(driven.inputs().coolantFlows);
  driven.go(0.99);
  EXPECT_FALSE(driven.inputs().spindleAtSpeed);
  driven.go(0.02);
  EXPECT_TRUE(driven.inputs().spindleAtSpeed);
  driven.outputs.spindleSpeed = 0;
  driven.outputs.coolant = false;
  driven.go(0.199);
  EXPECT_FALSE(driven.inputs().spindleAtSpeed);
  EXPECT_TRUE(driven.inputs().coolantFlows);
  driven.go(0.001);
  EXPECT_FALSE(driven.inputs().coolantFlows);
}

/// In motion, all well and at speed.
struct RunningMachine : DrivenMachine {
  RunningMachine() {
    go(2);
    go(1, velocity);
  }

  void goOn(double seconds) {
    go(seconds, velocity);
  }

  Vector3d velocity{30, 20, 0};
};

TEST(SimulatedFaults, NoneIsToldWhileAllIsWell) {
  RunningMachine running;
  Inputs well;
  well.driveReady.fill(true);
  well.spindleAtSpeed = well.coolantFlows = well.vacuumHolds = true;
  well.reference = running.inputs().reference;
  EXPECT_EQ(running.inputs(), well);
}

TEST(SimulatedFaults, ADriveFaultIsToldAndTakesItsAxisOff) {
  RunningMachine running;
  running.axes.inject(SimulatedFault::DriveFault, 1);
  EXPECT_EQ(running.inputs().driveFault, (std::array{false, true, false}));
  const Vector3d place = running.axes.place();
  running.goOn(1);
  EXPECT_EQ(running.inputs().driveReady, (std::array{true, false, true}));
  EXPECT_NEAR(running.axes.place().x() - place.x(), 30, 1e-3);
  EXPECT_NEAR(running.axes.place().y() - place.y(), 20 * 20 / (2 * 500.0), 0.02) << "braked by friction";
  running.axes.clearFaults();
  EXPECT_EQ(running.inputs().driveFault, (std::array{false, false, false}));
  running.go(0.049);
  EXPECT_FALSE(running.inputs().driveReady[1]);
  running.go(0.001);
  EXPECT_TRUE(running.inputs().driveReady[1]);
}

TEST(SimulatedFaults, ALostEncoderIsToldAndItsReadingStays) {
  RunningMachine running;
  running.axes.inject(SimulatedFault::EncoderLoss, 0);
  const Vector3d reading = running.axes.read().position;
  running.goOn(0.5);
  EXPECT_EQ(running.inputs().encoderLost, (std::array{true, false, false}));
  EXPECT_EQ(running.axes.read().position.x(), reading.x());
  EXPECT_NEAR(running.axes.read().position.y(), reading.y() + 10, 1e-3);
  running.axes.clearFaults();
  running.goOn(0.001);
  EXPECT_NEAR(running.axes.read().position.x(), reading.x() + 15.03, 1e-3);
}

TEST(SimulatedFaults, AStuckAxisMovesNoMoreAndNothingTellsSo) {
  RunningMachine running;
  const Inputs before = running.inputs();
  running.axes.inject(SimulatedFault::StuckAxis, 0);
  const Vector3d place = running.axes.place();
  running.goOn(0.5);
  EXPECT_EQ(running.axes.place().x(), place.x());
  EXPECT_NEAR(running.axes.place().y(), place.y() + 10, 1e-3);
  EXPECT_EQ(running.inputs(), before);
}

TEST(SimulatedFaults, SpindleCoolantAndVacuumAreLost) {
  RunningMachine running;
  running.axes.inject(SimulatedFault::SpindleLoss);
  running.axes.inject(SimulatedFault::CoolantLoss);
  running.axes.inject(SimulatedFault::VacuumLoss);
  running.goOn(0.2);
  EXPECT_FALSE(running.inputs().spindleAtSpeed);
  EXPECT_FALSE(running.inputs().coolantFlows);
  EXPECT_FALSE(running.inputs().vacuumHolds);
  EXPECT_TRUE(running.inputs().driveReady[0]);
  running.axes.clearFaults();
  running.go(2);
  EXPECT_TRUE(running.inputs().spindleAtSpeed);
  EXPECT_TRUE(running.inputs().coolantFlows);
  EXPECT_TRUE(running.inputs().vacuumHolds);
}

TEST(SimulatedFaults, TheEmergencyStopTakesDrivesSpindleAndCoolantOff) {
  RunningMachine running;
  const Vector3d place = running.axes.place();
  running.axes.inject(SimulatedFault::EmergencyStop, 2);
  EXPECT_TRUE(running.inputs().emergencyStop);
  running.goOn(0.5);
  EXPECT_EQ(running.inputs().driveReady, (std::array{false, false, false}));
  EXPECT_FALSE(running.inputs().spindleAtSpeed);
  EXPECT_FALSE(running.inputs().coolantFlows);
  EXPECT_TRUE(running.inputs().vacuumHolds) << "the glass must not come loose";
  EXPECT_NEAR(running.axes.place().x() - place.x(), 30 * 30 / (2 * 500.0), 0.03);
  running.axes.clearFaults();
  EXPECT_FALSE(running.inputs().emergencyStop);
}

TEST(SimulatedFaults, LateFeedbackIsAHundredMillisecondsOldForHalfASecond) {
  for (const double period : {0.00025, 0.001, 0.02}) {
    DrivenMachine driven(kPowerUpPlace, machineOf(period, 0.03));
    const auto ticksLate = std::lround(0.1 / period);
    std::vector<Feedback> truth;
    const auto goAndRemember = [&](double seconds) {
      for (int i = 0; i < std::lround(seconds / period); ++i) {
        driven.go(period, {30, 20, 0});
        truth.push_back(driven.axes.read());
      }
    };
    goAndRemember(1);
    // Another machine in the same motion tells what is true meanwhile.
    DrivenMachine late(kPowerUpPlace, driven.machine);
    late.go(1, {30, 20, 0});
    late.axes.inject(SimulatedFault::LateFeedback);
    goAndRemember(0.5);
    for (auto i = std::lround(1 / period); i < std::lround(1.5 / period); ++i) {
      late.go(period, {30, 20, 0});
      const Feedback feedback = late.axes.read();
      const Feedback& then = truth[static_cast<std::size_t>(i - ticksLate)];
      ASSERT_EQ(feedback.tick, then.tick) << period;
      ASSERT_EQ(feedback.position, then.position) << period;
      ASSERT_EQ(feedback.inputs, then.inputs) << period;
    }
    goAndRemember(period);
    late.go(period, {30, 20, 0});
    EXPECT_EQ(late.axes.read().tick, truth.back().tick) << "and then it is in time again";
  }
}

TEST(SimulatedFaults, LostFeedbackStaysAsItWasLast) {
  RunningMachine running;
  const Feedback last = running.axes.read();
  running.axes.inject(SimulatedFault::LostFeedback);
  running.axes.press(Button::Stop, true);
  for (int i = 0; i < 1000; ++i) {
    running.goOn(0.001);
    const Feedback feedback = running.axes.read();
    ASSERT_EQ(feedback.tick, last.tick);
    ASSERT_EQ(feedback.position, last.position);
    ASSERT_EQ(feedback.inputs, last.inputs);
  }
  running.axes.clearFaults();
  EXPECT_EQ(running.axes.read().tick, last.tick + 1000);
}

TEST(SimulatedFaults, OfTheCommandLineAreEachNamedOnce) {
  std::set<SimulatedFault> faults;
  for (const SimulatedFaultName& named : kSimulatedFaultNames) {
    EXPECT_EQ(faultNamed(named.name), named.fault);
    faults.insert(named.fault);
  }
  EXPECT_EQ(faults.size(), static_cast<std::size_t>(SimulatedFault::LostFeedback) + 1);
  EXPECT_EQ(faultNamed("drive-fault"), SimulatedFault::DriveFault);
  EXPECT_EQ(faultNamed("encoder-loss"), SimulatedFault::EncoderLoss);
  EXPECT_EQ(faultNamed("stuck-axis"), SimulatedFault::StuckAxis);
  EXPECT_EQ(faultNamed("spindle-loss"), SimulatedFault::SpindleLoss);
  EXPECT_EQ(faultNamed("coolant-loss"), SimulatedFault::CoolantLoss);
  EXPECT_EQ(faultNamed("emergency-stop"), SimulatedFault::EmergencyStop);
  EXPECT_EQ(faultNamed("late-feedback"), SimulatedFault::LateFeedback);
  EXPECT_EQ(faultNamed("lost-feedback"), SimulatedFault::LostFeedback);
  EXPECT_EQ(faultNamed("vacuum-loss"), SimulatedFault::VacuumLoss);
  for (const auto* const other : {"", "drive", "Drive-Fault", "drive-fault "}) {
    EXPECT_EQ(faultNamed(other), std::nullopt);
  }
}

TEST(SimulatedPanel, ButtonsAndOverrideAreReadAsTheyStand) {
  DrivenMachine driven;
  Inputs panel = driven.inputs();
  const auto press = [&](Button button, bool Inputs::*input, bool down) {
    driven.axes.press(button, down);
    panel.*input = down;
    EXPECT_EQ(driven.inputs(), panel);
  };
  for (const bool down : {true, false}) {
    press(Button::CycleStart, &Inputs::cycleStart, down);
    press(Button::Hold, &Inputs::hold, down);
    press(Button::Stop, &Inputs::stop, down);
    press(Button::JogEnable, &Inputs::jogEnable, down);
  }
  EXPECT_EQ(panel.overridePercent, 0);
  driven.axes.turnOverride(80);
  EXPECT_EQ(driven.inputs().overridePercent, 80);
}

TEST(SimulatedPanel, IsForAnyThread) {
  DrivenMachine driven;
  std::thread operatorThread([&] {
    for (int i = 0; i < 1000; ++i) {
      driven.axes.press(Button::Hold, i % 2 == 0);
      driven.axes.turnOverride(i % 150);
      driven.axes.inject(SimulatedFault::LateFeedback);
      driven.axes.inject(SimulatedFault::DriveFault, i % 3);
      driven.axes.clearFaults();
    }
    driven.axes.press(Button::CycleStart, true);
  });
  for (int i = 0; i < 20000; ++i) {
    driven.go(0.001);
    (void)driven.axes.read();
  }
  operatorThread.join();
  EXPECT_TRUE(driven.inputs().cycleStart);
  EXPECT_FALSE(driven.inputs().hold);
  EXPECT_EQ(driven.inputs().overridePercent, 99);
  EXPECT_EQ(driven.inputs().driveFault, (std::array{false, false, false}));
}

} // namespace
} // namespace arris::control
