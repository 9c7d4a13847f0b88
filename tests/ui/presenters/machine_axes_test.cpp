// Whatever axes a machine has: simulated ones, others, or none where real ones are not available.

#include "core/control/absent_axes.h"
#include "tests/support/ideal_axes.h"
#include "tests/ui/support/steps.h"
#include "ui/presenters/machine_link.h"

#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <cmath>

namespace arris::ui {
namespace {

using control::JobState;
using control::State;
using Axes = files::Axes;

bool waitFor(const std::function<bool()>& isSo) {
  return QTest::qWaitFor(isSo, test::kPatience);
}

PlanPointer planOfTriangle() {
  Planner planner({}, test::paneSteps());
  planner.openPattern("triangle.dxf");
  EXPECT_TRUE(waitFor([&] { return planner.plan() && !planner.isBusy(); }));
  return planner.plan();
}

MachineAxes idealAxes(const recipe::Machine& machine) {
  const int lead = static_cast<int>(std::lround(machine.setPointLead / machine.period));
  return {std::make_unique<test::IdealAxes>(machine, Eigen::Vector3d(200, 300, 100), lead), nullptr, std::nullopt,
          control::Pace::Simulated};
}

MachineSetup withoutModule(const test::Scratch& scratch) {
  MachineSetup setup = test::fastMachine(scratch);
  setup.axes = Axes::Linuxcnc;
  setup.moduleFolders = {scratch / "no such folder"};
  return setup;
}

TEST(OtherAxes, GrindAPaneAsSimulatedOnesDo) {
  const test::Scratch scratch;
  const MachineSetup setup = test::fastMachine(scratch);
  MachineLink machine(setup, idealAxes(setup.machine));
  EXPECT_FALSE(machine.isSimulated());
  EXPECT_FALSE(machine.absence());
  machine.enable();
  ASSERT_TRUE(waitFor([&] { return machine.allowed().home; }));
  machine.home();
  ASSERT_TRUE(waitFor([&] { return machine.allowed().move; }));
  machine.load(planOfTriangle(), 1);
  machine.start();
  ASSERT_TRUE(waitFor([&] { return machine.jobState() == JobState::Ended; }));
  EXPECT_TRUE(machine.alarms().empty());
}

TEST(OtherAxes, CannotBeMadeToFailAndHaveNoPanelInTheWindow) {
  const test::Scratch scratch;
  const MachineSetup setup = test::fastMachine(scratch);
  MachineLink machine(setup, idealAxes(setup.machine));
  machine.enable();
  ASSERT_TRUE(waitFor([&] { return machine.allowed().home; }));
  machine.inject(control::SimulatedFault::EmergencyStop);
  machine.press(control::Button::JogEnable, true);
  const std::int64_t before = machine.report().tick;
  ASSERT_TRUE(waitFor([&] { return machine.report().tick > before + 100; }));
  machine.clearFaults();
  EXPECT_TRUE(machine.alarms().empty());
  EXPECT_FALSE(machine.report().inputs.jogEnable);
  EXPECT_EQ(machine.report().state, State::NotHomed);
}

TEST(AbsentMachine, SaysWhyAndIsNotSimulated) {
  const test::Scratch scratch;
  const MachineLink machine(withoutModule(scratch));
  EXPECT_FALSE(machine.isSimulated());
  ASSERT_TRUE(machine.absence());
  EXPECT_EQ(machine.absence()->code, base::Code::DriverNotAvailable);
  EXPECT_EQ(machine.complaint(), machine.absence());
}

TEST(AbsentMachine, MovesNothingHoweverItIsAsked) {
  const test::Scratch scratch;
  MachineLink machine(withoutModule(scratch));
  machine.load(planOfTriangle(), 1);
  EXPECT_TRUE(machine.loaded());
  ASSERT_TRUE(waitFor([&] { return machine.report().tick > 100; })) << "the controller lives";
  for (int round = 0; round < 3; ++round) {
    EXPECT_EQ(machine.allowed(), (Allowed{.load = true, .judge = true}));
    machine.enable();
    machine.home();
    machine.jogAt({10, 0, 0});
    machine.jogBy({1, 0, 0});
    machine.start();
    machine.trace();
    machine.park();
    machine.spindleByHand(3000);
    machine.coolantByHand(true);
    const std::int64_t before = machine.report().tick;
    ASSERT_TRUE(waitFor([&] { return machine.report().tick > before + 500; }));
  }
  EXPECT_EQ(machine.report().state, State::Off);
  EXPECT_EQ(machine.report().outputs.spindleSpeed, 0);
  EXPECT_FALSE(machine.report().outputs.coolant);
  EXPECT_TRUE(machine.alarms().empty());
  EXPECT_EQ(machine.jobState(), JobState::Initialized);
}

TEST(AbsentMachine, SaysSoAgainWhenAnotherComplaintIsOver) {
  const test::Scratch scratch;
  MachineLink machine(withoutModule(scratch));
  machine.complain(base::Problem(base::Code::CannotWrite, {{"file", "a"}, {"reason", "b"}}));
  EXPECT_EQ(machine.complaint()->code, base::Code::CannotWrite);
  machine.load(planOfTriangle(), 1);
  EXPECT_EQ(machine.complaint()->code, base::Code::DriverNotAvailable);
}

} // namespace
} // namespace arris::ui
