// What the operator does by hand: homing, jog, origin, buttons, and what is not allowed.

#include "core/control/simulated_axes.h"
#include "tests/support/bench.h"
#include "tests/support/panes.h"
#include "tests/support/run_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace arris::control {
namespace {

using test::Bench;
using test::RunWatch;

job::Job triangleJob() {
  return job::planJob(test::triangle600(), recipe::Recipe{}, recipe::Machine{});
}

void switchOn(Bench& bench) {
  bench.period();
  bench.supervisor.serve();
  ASSERT_TRUE(bench.supervisor.enable());
  ASSERT_TRUE(bench.until([&] { return bench.report().drivesReady; }, 2));
}

void home(Bench& bench) {
  ASSERT_TRUE(bench.supervisor.home());
  ASSERT_TRUE(bench.until(State::Idle, 1e5));
}

TEST(HomingRun, FindsWhereTheAxesAreWhereverTheyStoodAtPowerUp) {
  std::mt19937 dice(7);
  const recipe::Machine machine;
  const job::Job job = triangleJob();
  for (int round = 0; round < 8; ++round) {
    const auto on = [&](double most) { return std::uniform_real_distribution<double>(-5, most + 5)(dice); };
    const Eigen::Vector3d standsAt(on(1500), on(2500), on(120));
    auto axes = std::make_unique<SimulatedAxes>(machine, Pace::Simulated, standsAt, Eigen::Vector3d(3, -2, 1));
    SimulatedAxes* simulated = axes.get();
    Bench bench(machine, std::move(axes));
    RunWatch watch(job, machine);
    bench.onPeriod = [&](const Report& report, const Cycle& cycle) { watch.add(report, cycle); };
    switchOn(bench);
    home(bench);
    bench.runFor(0.5);
    // The place is taken up to one period late at the slow speed, and the encoder counts in steps.
    EXPECT_LT((simulated->place() - bench.report().commanded).cwiseAbs().maxCoeff(),
              1e-3 * machine.homeLatch / 60 + 2e-4);
    EXPECT_EQ(watch.broken(), "");
    EXPECT_TRUE(bench.faults.empty());
  }
}

TEST(HomingRun, WithoutASwitchIsGivenUpWithAFault) {
  const recipe::Machine machine;
  Bench bench(machine);
  switchOn(bench);
  bench.ideal->switchesWork = false;
  ASSERT_TRUE(bench.supervisor.home());
  ASSERT_TRUE(bench.until(State::Faulted, 1000));
  EXPECT_TRUE(bench.report().faults.has(Fault::HomingFailed));
  EXPECT_FALSE(bench.report().homed);
}

TEST(Jog, EndsWhenItIsNoLongerSaid) {
  Bench bench{recipe::Machine{}};
  switchOn(bench);
  home(bench);
  ASSERT_TRUE(bench.supervisor.jogAt({30, 0, 0}));
  bench.runFor(0.15);
  EXPECT_EQ(bench.report().state, State::Jogging);
  EXPECT_GT(bench.report().velocity.x(), 5);
  ASSERT_TRUE(bench.until(State::Idle, 1)); // 0.2 s after the last word it brakes
  EXPECT_EQ(bench.report().velocity, Eigen::Vector3d::Zero());
}

TEST(Jog, StaysInTheTravelWithinTheAccelerationsAndStopsAtItsEnd) {
  const recipe::Machine machine;
  const job::Job job = triangleJob();
  Bench bench(machine);
  RunWatch watch(job, machine);
  bench.onPeriod = [&](const Report& report, const Cycle& cycle) { watch.add(report, cycle); };
  switchOn(bench);
  home(bench);
  std::mt19937 dice(5);
  Eigen::Vector3d least(1e9, 1e9, 1e9);
  Eigen::Vector3d most = -least;
  for (int i = 0; i < 3000; ++i) {
    const auto speed = [&] { return std::uniform_real_distribution<double>(-90, 90)(dice); };
    bench.supervisor.jogAt({speed(), i % 50 < 25 ? -60 : speed(), speed()});
    bench.runFor(0.05);
    least = least.cwiseMin(bench.report().commanded);
    most = most.cwiseMax(bench.report().commanded);
  }
  EXPECT_EQ(watch.broken(), "");
  EXPECT_GE(least.minCoeff(), -1e-6);
  EXPECT_LE((most - machine.travel).maxCoeff(), 1e-6);
  EXPECT_LT(least.y(), 1e-3); // it was driven against the end
  EXPECT_TRUE(bench.faults.empty());
}

TEST(Jog, ByStepsEndsExactlyThere) {
  Bench bench{recipe::Machine{}};
  switchOn(bench);
  home(bench);
  const Eigen::Vector3d from = bench.report().commanded;
  ASSERT_TRUE(bench.supervisor.jogBy({10, 0.001, -100}));
  ASSERT_TRUE(bench.until(State::Jogging, 1));
  ASSERT_TRUE(bench.until(State::Idle, 60));
  EXPECT_LT((bench.report().commanded - from - Eigen::Vector3d(10, 0.001, -100)).norm(), 1e-9);
}

TEST(JogEnable, WhereItIsRequiredIsHeldAllTheWhileAndFreshlyPressed) {
  recipe::Machine machine;
  machine.jogEnableRequired = true;
  Bench bench{machine};
  const job::Job job = triangleJob();
  RunWatch watch(job, machine);
  bench.onPeriod = [&](const Report& report, const Cycle& cycle) { watch.add(report, cycle); };
  bench.ideal->inputs.jogEnable = true; // stuck at power-up
  switchOn(bench);
  home(bench);
  const auto order = [&](bool toPlace) {
    toPlace ? bench.supervisor.jogBy({50, 0, 0}) : bench.supervisor.jogAt({30, 0, 0});
    bench.runFor(0.15);
    bench.supervisor.serve();
    return bench.report().state == State::Jogging;
  };
  EXPECT_FALSE(order(false));
  bench.ideal->inputs.jogEnable = false;
  EXPECT_FALSE(order(true));
  for (const bool toPlace : {false, true}) {
    SCOPED_TRACE(toPlace);
    bench.ideal->inputs.jogEnable = true;
    bench.runFor(0.05);
    ASSERT_TRUE(order(toPlace));
    EXPECT_GT(bench.report().velocity.x(), 5);
    bench.ideal->inputs.jogEnable = false;
    bench.period();
    EXPECT_FALSE(order(toPlace)) << "it brakes, whatever is said";
    EXPECT_EQ(bench.report().state, State::Idle);
    bench.runFor(1);
    EXPECT_EQ(bench.report().state, State::Idle);
  }
  EXPECT_EQ(watch.broken(), "");
  EXPECT_TRUE(bench.faults.empty());
}

TEST(LimitSwitch, ThatIsOnSincePowerUpLetsTheAxisBeJoggedOffItOnly) {
  Bench bench{recipe::Machine{}};
  bench.ideal->inputs.limitHigh[0] = true;
  bench.ideal->inputs.limitLow[1] = true;
  switchOn(bench);
  EXPECT_EQ(bench.report().state, State::NotHomed);
  const auto jogged = [&](const Eigen::Vector3d& by, bool toPlace) -> Eigen::Vector3d {
    const Eigen::Vector3d from = bench.report().commanded;
    EXPECT_TRUE(toPlace ? bench.supervisor.jogBy(by) : bench.supervisor.jogAt(by));
    bench.runFor(0.05);
    EXPECT_TRUE(bench.until(State::NotHomed, 10));
    return bench.report().commanded - from;
  };
  EXPECT_EQ(jogged({5, -5, 0}, true), Eigen::Vector3d::Zero());
  EXPECT_EQ(jogged({5, -5, 0}, false), Eigen::Vector3d::Zero());
  EXPECT_LT((jogged({5, 5, 0}, true) - Eigen::Vector3d(0, 5, 0)).norm(), 1e-9);
  EXPECT_LT((jogged({-5, 5, 1}, true) - Eigen::Vector3d(-5, 5, 1)).norm(), 1e-9);
  EXPECT_LT(jogged({-5, 5, 1}, false).x(), 0);
  EXPECT_TRUE(bench.faults.empty());
}

TEST(LimitSwitch, ThatComesOnDuringAJogByStepsEndsItAndTheAxisIsJoggedBack) {
  Bench bench{recipe::Machine{}};
  switchOn(bench);
  ASSERT_TRUE(bench.supervisor.jogBy({0, 100, 0}));
  bench.runFor(1);
  bench.ideal->inputs.limitHigh[1] = true;
  ASSERT_TRUE(bench.until(State::Faulted, 2));
  EXPECT_TRUE(bench.report().faults.has(Fault::LimitSwitch));
  bench.supervisor.serve();
  ASSERT_TRUE(bench.supervisor.acknowledge());
  ASSERT_TRUE(bench.until(State::Off, 1));
  ASSERT_TRUE(bench.supervisor.enable());
  ASSERT_TRUE(bench.until([&] { return bench.report().drivesReady; }, 2));
  const double from = bench.report().commanded.y();
  ASSERT_TRUE(bench.supervisor.jogBy({0, -3, 0}));
  ASSERT_TRUE(bench.until(State::Jogging, 1));
  ASSERT_TRUE(bench.until(State::NotHomed, 10));
  EXPECT_NEAR(bench.report().commanded.y(), from - 3, 1e-9);
  EXPECT_EQ(bench.faults.size(), 1U);
}

TEST(LimitSwitch, ThatIsOnIsHomedOffButNotRunInto) {
  const recipe::Machine machine; // X is homed towards its low end
  for (const bool high : {true, false}) {
    Bench bench{machine};
    (high ? bench.ideal->inputs.limitHigh : bench.ideal->inputs.limitLow)[0] = true;
    switchOn(bench);
    ASSERT_TRUE(bench.supervisor.home());
    double least = 1e9;
    const double from = bench.report().commanded.x();
    bench.onPeriod = [&](const Report& report, const Cycle&) {
      least = std::min(least, report.commanded.x());
      bench.ideal->inputs.limitHigh[0] = high && report.commanded.x() > from - 5;
    };
    ASSERT_TRUE(bench.until(high ? State::Idle : State::Faulted, 1e4));
    EXPECT_EQ(bench.report().faults.has(Fault::LimitSwitch), !high);
    EXPECT_TRUE(high || from - least < 0.001);
  }
}

TEST(LimitSwitch, ThatIsOnStopsAJobThatMovesTheAxisFartherWithAFault) {
  const job::Job job = triangleJob();
  Bench bench(job.machine);
  bench.getReady(job);
  bench.ideal->inputs.limitHigh[0] = true; // it hangs
  ASSERT_TRUE(bench.until(State::Faulted, 1));
  bench.supervisor.serve();
  ASSERT_TRUE(bench.supervisor.acknowledge());
  ASSERT_TRUE(bench.until(State::Off, 1));
  ASSERT_TRUE(bench.supervisor.enable());
  ASSERT_TRUE(bench.until([&] { return bench.report().drivesReady; }, 2));
  const double from = bench.report().commanded.x();
  ASSERT_TRUE(bench.supervisor.start());
  ASSERT_TRUE(bench.until(State::Faulted, 60));
  EXPECT_TRUE(bench.report().faults.has(Fault::LimitSwitch));
  EXPECT_NEAR(bench.report().commanded.x(), from, 0.001);
}

TEST(Origin, MovesTheTableAndNotTheAxes) {
  Bench bench{recipe::Machine{}};
  switchOn(bench);
  home(bench);
  const Eigen::Vector3d setPoint = bench.report().commanded;
  ASSERT_TRUE(bench.supervisor.setOrigin({100, 50, 0}));
  bench.runFor(0.5);
  EXPECT_LT((bench.report().commanded - setPoint + Eigen::Vector3d(100, 50, 0)).norm(), 1e-12);
  EXPECT_TRUE(bench.faults.empty());
}

TEST(Origin, ThatTakesTheJobOutOfTheTravelStopsItBeforeTheAxesLeaveIt) {
  const job::Job job = triangleJob();
  Bench bench(job.machine);
  bench.getReady(job);
  ASSERT_TRUE(bench.supervisor.setOrigin({700, 0, 0}));
  bench.runFor(0.1);
  bench.supervisor.serve();
  EXPECT_FALSE(bench.supervisor.start()); // said before anything moves
  ASSERT_TRUE(bench.supervisor.refusal());
  EXPECT_EQ(bench.supervisor.refusal()->code, base::Code::OutsideTravel);
}

TEST(Commands, ThatTheStateDoesNotAllowDoNothing) {
  const job::Job job = triangleJob();
  Bench bench(job.machine);
  bench.period();
  bench.supervisor.serve();
  EXPECT_FALSE(bench.supervisor.home()); // drives are off
  EXPECT_FALSE(bench.supervisor.start());
  EXPECT_FALSE(bench.supervisor.jogAt({10, 0, 0}));
  switchOn(bench);
  EXPECT_TRUE(bench.supervisor.load(std::make_shared<const job::Job>(job)));
  EXPECT_FALSE(bench.supervisor.start()); // not homed
  EXPECT_FALSE(bench.supervisor.park());
  EXPECT_FALSE(bench.supervisor.resume());
  EXPECT_FALSE(bench.supervisor.step(10));
  for (const Command& command :
       std::initializer_list<Command>{command::Start{}, command::Resume{}, command::Hold{}, command::Acknowledge{}}) {
    const Eigen::Vector3d at = bench.report().commanded;
    bench.channels.commands.push(command);
    bench.runFor(0.1);
    EXPECT_EQ(bench.report().state, State::NotHomed);
    EXPECT_EQ(bench.report().commanded, at);
  }
  EXPECT_EQ(bench.report().refused, 4);
}

TEST(Buttons, OnlyAFreshPressCounts) {
  const job::Job job = triangleJob();
  Bench bench(job.machine);
  bench.ideal->inputs.cycleStart = true; // stuck at power-up
  bench.getReady(job);
  bench.runFor(3);
  EXPECT_EQ(bench.report().state, State::Idle);
  bench.ideal->inputs.cycleStart = false;
  bench.runFor(0.1);
  bench.ideal->inputs.cycleStart = true;
  bench.runFor(3);
  EXPECT_EQ(bench.report().state, State::Running);
  bench.ideal->inputs.hold = true;
  ASSERT_TRUE(bench.until(State::Held, 20));
  bench.runFor(3);
  EXPECT_EQ(bench.report().state, State::Held); // cycle start is still pressed, and so is hold
  bench.ideal->inputs.cycleStart = false;
  bench.runFor(0.1);
  bench.ideal->inputs.cycleStart = true;
  bench.ideal->inputs.stop = true; // at the same time: stop beats start
  bench.runFor(0.1);
  EXPECT_EQ(bench.report().state, State::Idle);
  bench.runFor(1);
  EXPECT_EQ(bench.report().state, State::Idle);
}

TEST(Buttons, CycleStartGoesOnAfterAHoldAlsoWhereTheWheelHasBackedOff) {
  const job::Job job = triangleJob();
  Bench bench(job.machine);
  RunWatch watch(job, job.machine);
  bench.getReady(job);
  bench.onPeriod = [&](const Report& report, const Cycle& cycle) { watch.add(report, cycle); };
  ASSERT_TRUE(bench.supervisor.start());
  ASSERT_TRUE(bench.until([&] { return bench.report().place.segment >= 5 && bench.report().speed > 50; }, 200));
  ASSERT_TRUE(bench.supervisor.hold());
  ASSERT_TRUE(bench.until([&] { return bench.report().aside == Aside::BackedOff; }, 20));
  const program::JobPlace held = bench.report().place;
  bench.runFor(1);
  bench.ideal->inputs.cycleStart = true;
  ASSERT_TRUE(bench.until(State::Running, 2));
  ASSERT_TRUE(bench.until(
      [&] {
        return bench.report().isInMotion && bench.report().segment > 0 && bench.report().place.segment >= 0 &&
               !(bench.report().place == held);
      },
      60));
  // It comes back onto the path before the place where it was held: by the overlap.
  const Report& back = bench.report();
  ASSERT_EQ(back.place.segment, held.segment);
  EXPECT_NEAR(held.lambda - back.place.lambda, job.recipe.overlap, 0.2);
  ASSERT_TRUE(bench.until([&] { return bench.supervisor.jobState() == JobState::Ended; }, 300));
  EXPECT_EQ(watch.broken(), "");
}

TEST(Hold, BacksTheWheelOffTheGlassAlongTheNormalAfterTwoSeconds) {
  const job::Job job = triangleJob();
  Bench bench(job.machine);
  bench.getReady(job);
  ASSERT_TRUE(bench.supervisor.start());
  ASSERT_TRUE(bench.until([&] { return bench.report().place.segment >= 5 && bench.report().speed > 50; }, 200));
  ASSERT_TRUE(bench.supervisor.hold());
  ASSERT_TRUE(bench.until(State::Held, 20));
  const Report held = bench.report();
  bench.runFor(1.9);
  EXPECT_EQ(bench.report().commanded, held.commanded);
  bench.runFor(2);
  EXPECT_EQ(bench.report().aside, Aside::BackedOff);
  const Eigen::Vector3d moved = bench.report().commanded - held.commanded;
  EXPECT_NEAR(moved.norm(), 5, 1e-9);
  EXPECT_EQ(bench.report().place, held.place);
  const auto& on = job.track[static_cast<std::size_t>(held.place.segment)];
  EXPECT_NEAR(motion::evaluate(on, held.place.lambda).first.dot(moved), 0, 1e-9);
}

TEST(Steps, GoBackFiveHundredMillimetresAndForthBesideThePath) {
  const job::Job job = triangleJob();
  Bench bench(job.machine);
  RunWatch watch(job, job.machine);
  bench.getReady(job);
  bench.onPeriod = [&](const Report& report, const Cycle& cycle) { watch.add(report, cycle); };
  ASSERT_TRUE(bench.supervisor.start());
  ASSERT_TRUE(bench.until([&] { return bench.report().place.segment >= 8; }, 200));
  ASSERT_TRUE(bench.supervisor.hold());
  ASSERT_TRUE(bench.until(State::Held, 20));
  const auto wayTo = [&](const program::JobPlace& place) {
    double way = motion::arcLength(job.track[static_cast<std::size_t>(place.segment)], place.lambda);
    for (int i = 0; i < place.segment; ++i) {
      const motion::Segment& segment = job.track[static_cast<std::size_t>(i)];
      way += motion::arcLength(segment, motion::parameterLength(segment));
    }
    return way;
  };
  const double from = wayTo(bench.report().place);
  bench.supervisor.serve();
  ASSERT_TRUE(bench.supervisor.step(-500));
  ASSERT_TRUE(bench.until(State::Stepping, 10));
  ASSERT_TRUE(bench.until(State::Held, 200));
  EXPECT_NEAR(from - wayTo(bench.report().place), 500, 0.01);
  bench.supervisor.serve();
  ASSERT_TRUE(bench.supervisor.step(20));
  ASSERT_TRUE(bench.until(State::Stepping, 10));
  ASSERT_TRUE(bench.until(State::Held, 200));
  EXPECT_NEAR(from - wayTo(bench.report().place), 480, 0.01);
  EXPECT_EQ(watch.broken(), "");
}

TEST(OutlineTrace, GoesRoundAtHeightWithoutSpindle) {
  const job::Job job = triangleJob();
  Bench bench(job.machine);
  bench.getReady(job);
  double least = 1e9;
  bool turned = false;
  bench.onPeriod = [&](const Report& report, const Cycle&) {
    least = std::min(least, report.commanded.z());
    turned = turned || report.outputs.spindleSpeed > 0;
  };
  ASSERT_TRUE(bench.supervisor.trace());
  ASSERT_TRUE(bench.until(State::Positioning, 1));
  ASSERT_TRUE(bench.until(State::Idle, 500));
  EXPECT_NEAR(least, 77, 1e-9);
  EXPECT_FALSE(turned);
  EXPECT_EQ(bench.supervisor.panesDone(), 0);
}

TEST(Panes, AreGroundOneAfterTheOtherByOneCommandEach) {
  const job::Job job = triangleJob();
  Bench bench(job.machine);
  bench.getReady(job);
  for (int pane = 1; pane <= 3; ++pane) {
    ASSERT_TRUE(bench.supervisor.start());
    ASSERT_TRUE(bench.until([&] { return bench.supervisor.panesDone() == pane; }, 500));
    bench.runFor(5);
    EXPECT_EQ(bench.report().state, State::Idle); // the next does not begin by itself
    bench.supervisor.serve();
  }
}

TEST(SpindleByHand, IsSwitchedOffByStopAtRest) {
  Bench bench(recipe::Machine{});
  switchOn(bench);
  home(bench);
  ASSERT_TRUE(bench.supervisor.spindleByHand(3000));
  ASSERT_TRUE(bench.supervisor.coolantByHand(true));
  ASSERT_TRUE(bench.until([&] { return bench.report().outputs.spindleSpeed == 3000; }, 1));
  ASSERT_TRUE(bench.until([&] { return bench.report().outputs.coolant; }, 1));
  bench.supervisor.stop();
  ASSERT_TRUE(bench.until([&] { return bench.report().outputs.spindleSpeed == 0; }, 1));
  EXPECT_FALSE(bench.report().outputs.coolant);
  EXPECT_EQ(bench.report().state, State::Idle);
}

TEST(JogEnable, ThatIsRequiredIsToldWithEveryPeriod) {
  recipe::Machine machine;
  machine.jogEnableRequired = true;
  auto axes = std::make_unique<SimulatedAxes>(machine, Pace::Simulated, Eigen::Vector3d(100, 100, 100));
  SimulatedAxes* simulated = axes.get();
  Bench bench(machine, std::move(axes));
  switchOn(bench);
  EXPECT_FALSE(bench.report().mayJog);
  simulated->press(Button::JogEnable, true);
  ASSERT_TRUE(bench.until([&] { return bench.report().mayJog; }, 1));
  simulated->press(Button::JogEnable, false);
  ASSERT_TRUE(bench.until([&] { return !bench.report().mayJog; }, 1));
}

TEST(Report, TellsWhereTheSegmentEndsThatTheWheelIsOnAndItsFeed) {
  const job::Job job = triangleJob();
  Bench bench(job.machine);
  bench.getReady(job);
  int segment = -1;
  int checked = 0;
  bench.onPeriod = [&](const Report& report, const Cycle&) {
    if (report.isInMotion && report.kind == program::Kind::Job && report.segment != segment) {
      segment = report.segment;
      const motion::Segment& on = job.track[static_cast<std::size_t>(report.place.segment)];
      const Eigen::Vector3d end = motion::evaluate(on, motion::parameterLength(on)).point;
      EXPECT_LT((report.segmentEnd - end).norm(), 1e-9) << segment;
      EXPECT_DOUBLE_EQ(report.feed, on.feed) << segment;
      ++checked;
    }
  };
  ASSERT_TRUE(bench.supervisor.start());
  ASSERT_TRUE(bench.until([&] { return bench.supervisor.jobState() == JobState::Ended; }, 5000));
  EXPECT_EQ(checked, static_cast<int>(job.track.size()));
}

} // namespace
} // namespace arris::control
