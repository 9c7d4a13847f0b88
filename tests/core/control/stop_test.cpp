// Stop and hold are obeyed, whatever was ordered before or is under way.

#include "core/control/run_keeper.h"
#include "core/files/whole_file.h"
#include "tests/support/bench.h"
#include "tests/support/panes.h"
#include "tests/support/scratch.h"

#include <gtest/gtest.h>

namespace arris::control {
namespace {

using test::Bench;

job::Job jobToStop() {
  return job::planJob(test::triangle600(), recipe::Recipe{}, recipe::Machine{});
}

void runToGlass(Bench& bench) {
  ASSERT_TRUE(bench.supervisor.start());
  ASSERT_TRUE(bench.until([&] { return bench.report().place.segment >= 5 && bench.report().speed > 50; }, 200));
}

void expectRest(Bench& bench, State state, double seconds) {
  const Eigen::Vector3d at = bench.report().commanded;
  bench.runFor(seconds);
  EXPECT_EQ(bench.report().state, state);
  EXPECT_EQ(bench.report().commanded, at);
}

TEST(StopAndHold, AHoldAfterAResumeThatStillWaitsKeepsTheWheelWhereItIs) {
  Bench bench(recipe::Machine{});
  bench.getReady(jobToStop());
  runToGlass(bench);
  ASSERT_TRUE(bench.supervisor.hold());
  ASSERT_TRUE(bench.until(State::Holding, 1));
  ASSERT_TRUE(bench.supervisor.resume()); // waits until the wheel rests
  bench.supervisor.hold();
  ASSERT_TRUE(bench.until([&] { return bench.report().aside == Aside::BackedOff; }, 30));
  expectRest(bench, State::Held, 5);
}

TEST(StopAndHold, AHoldWhileTheWayBackIsBeingPlannedKeepsTheWheelWhereItIs) {
  Bench bench(recipe::Machine{}, std::launch::async);
  bench.getReady(jobToStop());
  ASSERT_TRUE(bench.supervisor.start());
  while (bench.supervisor.isPlanning()) {
    bench.period();
  }
  ASSERT_TRUE(bench.until([&] { return bench.report().place.segment >= 5 && bench.report().speed > 50; }, 200));
  ASSERT_TRUE(bench.supervisor.hold());
  ASSERT_TRUE(bench.until([&] { return bench.report().aside == Aside::BackedOff; }, 30));
  bench.supervisor.serve();
  ASSERT_TRUE(bench.supervisor.resume());
  bench.supervisor.serve(); // planning begins
  bench.supervisor.hold();
  expectRest(bench, State::Held, 2000);   // long after it was planned
  ASSERT_TRUE(bench.supervisor.resume()); // and once more in earnest
  EXPECT_TRUE(bench.until(State::Running, 1e5));
}

TEST(StopAndHold, AStopThatStaysPressedKeepsEverythingFromStarting) {
  Bench bench(recipe::Machine{});
  bench.getReady(jobToStop());
  bench.ideal->inputs.stop = true;
  bench.runFor(0.1);
  bench.supervisor.serve();
  bench.supervisor.start();
  expectRest(bench, State::Idle, 2);
  bench.ideal->inputs.stop = false;
  bench.runFor(1);
  bench.supervisor.serve();
  EXPECT_EQ(bench.report().state, State::Idle);
  EXPECT_TRUE(bench.supervisor.start());
  EXPECT_TRUE(bench.until(State::Running, 5));
}

TEST(StopAndHold, AStopBeatsAStartThatIsOnItsWay) {
  Bench bench(recipe::Machine{});
  bench.getReady(jobToStop());
  bench.ideal->inputs.stop = true; // pressed and released before the start arrives
  bench.period();
  bench.ideal->inputs.stop = false;
  ASSERT_TRUE(bench.supervisor.start());
  expectRest(bench, State::Idle, 2);
}

TEST(StopAndHold, AStopAfterAJogThatEndedInAnEmergencyStopRaisesTheWheel) {
  Bench bench(recipe::Machine{});
  const job::Job job = jobToStop();
  bench.getReady(job);
  ASSERT_TRUE(bench.supervisor.jogAt({40, 0, 0}));
  bench.runFor(0.15);
  bench.ideal->inputs.emergencyStop = true;
  ASSERT_TRUE(bench.until(State::EmergencyStop, 1));
  bench.ideal->inputs.emergencyStop = false;
  bench.runFor(0.1);
  bench.supervisor.serve();
  ASSERT_TRUE(bench.supervisor.acknowledge());
  ASSERT_TRUE(bench.until(State::Off, 1));
  ASSERT_TRUE(bench.supervisor.enable());
  ASSERT_TRUE(bench.until([&] { return bench.report().drivesReady; }, 2));
  bench.faults.clear();
  runToGlass(bench);
  bench.supervisor.stop();
  ASSERT_TRUE(bench.until(State::Idle, 30));
  EXPECT_NEAR(bench.report().commanded.z(), 77, 1e-6);
  EXPECT_TRUE(bench.faults.empty());
}

TEST(StopAndHold, AStopDuringTheBrakingOfAFaultStillRaisesTheWheel) {
  Bench bench(recipe::Machine{});
  bench.getReady(jobToStop());
  runToGlass(bench);
  bench.ideal->coolantWorks = false;
  ASSERT_TRUE(bench.until(State::Stopping, 1));
  bench.supervisor.stop();
  ASSERT_TRUE(bench.until(State::Faulted, 30));
  EXPECT_NEAR(bench.report().commanded.z(), 77, 1e-6);
}

TEST(Drives, ThatDoNotComeUpAreAFaultThatCanBeAcknowledged) {
  Bench bench(recipe::Machine{});
  bench.ideal->drivesWork = false;
  bench.period();
  bench.supervisor.serve();
  ASSERT_TRUE(bench.supervisor.enable());
  ASSERT_TRUE(bench.until(State::Faulted, 5));
  EXPECT_TRUE(bench.report().faults.has(Fault::DriveNotReady));
  EXPECT_FALSE(bench.report().outputs.driveEnable[0]);
  ASSERT_TRUE(bench.supervisor.acknowledge());
  EXPECT_TRUE(bench.until(State::Off, 1));
}

TEST(Axes, ThatHadNoSetPointInTimeStopTheRunWithAFault) {
  Bench bench(recipe::Machine{});
  bench.getReady(jobToStop());
  runToGlass(bench);
  bench.ideal->underruns = 3;
  ASSERT_TRUE(bench.until(State::Faulted, 30));
  EXPECT_TRUE(bench.report().faults.has(Fault::SetPointLate));
}

TEST(Starting, TwiceAtOnceStartsOnceAndLeavesTheBuffersInOrder) {
  const job::Job job = jobToStop();
  Bench bench(job.machine);
  bench.getReady(job);
  ASSERT_TRUE(bench.supervisor.start());
  EXPECT_FALSE(bench.supervisor.start());
  EXPECT_FALSE(bench.supervisor.load(std::make_shared<const job::Job>(job)));
  EXPECT_FALSE(bench.supervisor.unload());
  ASSERT_TRUE(bench.until([&] { return bench.supervisor.jobState() == JobState::Ended; }, 300));
  EXPECT_TRUE(bench.faults.empty());
}

/// A run of the triangle with everything that it leaves; `disturb` is called once it is on the glass.
void keptRun(const test::Scratch& scratch, const std::function<void(Bench&)>& disturb) {
  const auto job = std::make_shared<const job::Job>(jobToStop());
  Bench bench(job->machine);
  bench.getReady(*job);
  RunKeeper keeper(
      {scratch / "state"}, job, "triangle.dxf", "0123456789abcdef", [] { return std::string("2031-05-06T07:08:09"); },
      files::Axes::Simulated);
  bench.onPeriod = [&](const Report& report, const Cycle&) { keeper.add(report); };
  runToGlass(bench);
  disturb(bench);
  ASSERT_TRUE(bench.until(State::Idle, 300));
  bench.runFor(1);
  EXPECT_TRUE(keeper.takeProblems().empty());
}

TEST(ResumePoint, OfAStoppedJobStaysAndTellsWhereItWas) {
  const test::Scratch scratch;
  program::JobPlace place;
  keptRun(scratch, [&](Bench& bench) {
    bench.supervisor.stop();
    bench.until(State::Stopping, 1);
    bench.until(State::Idle, 30);
    place = bench.report().place;
    bench.supervisor.serve();
  });
  const auto text = files::readFile(scratch / "state/resume.json");
  ASSERT_TRUE(text);
  const auto point = files::readResumePoint(*text, "resume.json");
  ASSERT_TRUE(point.problems.empty());
  EXPECT_EQ(point.value.ended, files::Ended::Stopped);
  EXPECT_EQ(point.value.place, place);
}

TEST(ResumePoint, OfAPaneThatIsDoneIsGone) {
  const test::Scratch scratch;
  keptRun(scratch, [](Bench&) {});
  EXPECT_FALSE(std::filesystem::exists(scratch / "state/resume.json"));
}

TEST(RunKeeper, SaysWhichAxesMoved) {
  const test::Scratch scratch;
  const auto job = std::make_shared<const job::Job>(jobToStop());
  Bench bench(job->machine);
  bench.getReady(*job);
  RunKeeper keeper(
      {scratch / "state"}, job, "triangle.dxf", "0123456789abcdef", [] { return std::string("2031-05-06T07:08:09"); },
      files::Axes::Linuxcnc);
  bench.onPeriod = [&](const Report& report, const Cycle&) { keeper.add(report); };
  runToGlass(bench);
  bench.supervisor.stop();
  ASSERT_TRUE(bench.until(State::Idle, 300));
  const auto text = files::readFile(scratch / "state/resume.json");
  ASSERT_TRUE(text);
  EXPECT_EQ(files::readResumePoint(*text, "resume.json").value.axes, files::Axes::Linuxcnc);
}

TEST(RunKeeper, CountsAPaneOnceHoweverOftenItIsBrokenOff) {
  const test::Scratch scratch;
  const auto job = std::make_shared<const job::Job>(jobToStop());
  Bench bench(job->machine);
  bench.getReady(*job);
  RunKeeper keeper({scratch / "state"}, job, "triangle.dxf", "0123456789abcdef",
                   [] { return std::string("2031-05-06T07:08:09"); }, files::Axes::Simulated, {3, 5});
  bench.onPeriod = [&](const Report& report, const Cycle&) { keeper.add(report); };
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(i == 0 ? bench.supervisor.start() : bench.supervisor.startFrom(bench.report().place));
    ASSERT_TRUE(bench.until([&] { return bench.report().place.segment >= 4 && bench.report().runTick > 500; }, 300));
    bench.supervisor.stop();
    ASSERT_TRUE(bench.until(State::Idle, 30));
    EXPECT_EQ(keeper.pane(), 3);
  }
  ASSERT_TRUE(bench.supervisor.startFrom(bench.report().place));
  ASSERT_TRUE(bench.until([&] { return bench.supervisor.jobState() == JobState::Ended; }, 300));
  EXPECT_EQ(keeper.pane(), 3);
  ASSERT_TRUE(bench.until(State::Idle, 30));
  ASSERT_TRUE(bench.supervisor.start());
  ASSERT_TRUE(bench.until([&] { return bench.report().runTick > 500; }, 300));
  EXPECT_EQ(keeper.pane(), 4);
  bench.supervisor.stop();
  ASSERT_TRUE(bench.until(State::Idle, 30));
  keeper.nothingLeft(); // given up
  ASSERT_TRUE(bench.supervisor.start());
  ASSERT_TRUE(bench.until([&] { return bench.report().runTick > 500; }, 300));
  EXPECT_EQ(keeper.pane(), 5);
}

} // namespace
} // namespace arris::control
