#include "core/files/whole_file.h"
#include "tests/support/ground_watch.h"
#include "tests/ui/support/steps.h"
#include "ui/presenters/machine_link.h"

#include <QTest>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <map>
#include <thread>

namespace arris::ui {
namespace {

using control::JobState;
using Offer = ResumeOffer::State;

files::StateFolder folderIn(const test::Scratch& scratch) {
  return {scratch / "state"};
}

PlanPointer planNamed(const std::string& name) {
  const PlannerSteps steps = test::paneSteps();
  auto plan = std::make_shared<Plan>();
  plan->import = std::make_shared<const Import>(steps.read(name, {}, {}).value());
  plan->job = steps.plan(plan->import->pattern, {}, {}, {});
  return plan;
}

files::ResumePoint pointIn(const job::Job& job) {
  files::ResumePoint point;
  point.patternFile = "triangle.dxf";
  point.patternHash = "0123456789abcdef";
  point.recipe = job.recipe;
  point.machine = job.machine;
  point.place = {6, 40};
  point.pane = 2;
  point.panes = 3;
  point.ended = files::Ended::Fault;
  return point;
}

void leave(const files::ResumePoint& point, const test::Scratch& scratch) {
  std::filesystem::create_directories(folderIn(scratch).root);
  ASSERT_TRUE(files::writeWholeFile(folderIn(scratch).resumePoint(), files::writeResumePoint(point)));
}

MachineSetup fastWith(const test::Scratch& scratch) {
  MachineSetup setup = test::fastMachine(scratch);
  setup.steps = test::paneSteps();
  return setup;
}

void getHome(MachineLink& machine) {
  machine.enable();
  ASSERT_TRUE(QTest::qWaitFor([&] { return machine.allowed().home; }, test::kPatience));
  machine.home();
  ASSERT_TRUE(QTest::qWaitFor([&] { return machine.allowed().move; }, test::kPatience));
}

bool offerBecomes(const ResumeOffer& offer, Offer state) {
  return QTest::qWaitFor([&] { return offer.state() == state; }, test::kPatience);
}

TEST(ResumeOffer, IsNoneWhereNothingWasBrokenOff) {
  const test::Scratch scratch;
  MachineLink machine(fastWith(scratch));
  EXPECT_EQ(machine.resumeOffer().state(), Offer::None);
}

/// Two machines one after the other on one folder, the first gone in the middle of a run.
TEST(ResumeOffer, GoesOnWithAPaneSoThatTheWholeContourIsGround) {
  const test::Scratch scratch;
  const PlanPointer plan = planNamed("triangle.dxf");
  test::GroundWatch watch(plan->job);
  std::int64_t ticks = 0;
  std::int64_t last = 0;
  std::uint32_t programs = 0;
  MachineSetup setup = fastWith(scratch);
  std::map<std::int64_t, Eigen::Vector3d> ordered;
  setup.watcher = [&](control::Report report) { // as if one machine had gone on all the time
    ordered[report.tick] = report.commanded;
    if (const auto at = ordered.find(report.measuredTick); at != ordered.end()) {
      constexpr double kBehind = 0.1; // mm: encoders count, and axes follow
      const bool isThere = (report.measured - at->second).norm() < kBehind;
      report.measured = isThere ? at->second : report.measured;
      ordered.erase(ordered.begin(), at);
    }
    report.tick += ticks;
    report.measuredTick += report.measuredTick >= 0 ? ticks : 0;
    report.program += report.program > 0 ? programs : 0;
    last = report.tick;
    watch.add(report);
  };
  const Eigen::Vector3d origin(12.5, 20, -1);
  double ground = 0;
  {
    MachineLink first(setup);
    getHome(first);
    first.setOrigin(origin);
    ASSERT_TRUE(QTest::qWaitFor([&] { return first.report().origin == origin; }, test::kPatience));
    first.load(plan, 4);
    first.start();
    ASSERT_TRUE(QTest::qWaitFor([&] { return first.progress() > 0.35; }, test::kPatience));
    ASSERT_LT(first.progress(), 0.9);
    ground = first.progress();
  }
  ordered.clear();
  ticks = last + 10'000;
  programs = 1000;
  MachineLink second(setup);
  ResumeOffer& offer = second.resumeOffer();
  ASSERT_EQ(offer.state(), Offer::Offered);
  EXPECT_EQ(offer.job()->point.panes, 4);
  EXPECT_EQ(offer.job()->point.ended, files::Ended::Stopped);
  offer.takeUp();
  ASSERT_TRUE(offerBecomes(offer, Offer::None));
  ASSERT_TRUE(second.loaded());
  EXPECT_TRUE(second.goesOnWithAPane());
  EXPECT_EQ(second.order().wanted(), 4);
  EXPECT_GE(second.progress(), ground);
  getHome(second);
  ASSERT_TRUE(QTest::qWaitFor([&] { return second.allowed().start; }, test::kPatience));
  EXPECT_EQ(second.report().origin, origin); // where the glass lies
  second.start();
  ASSERT_TRUE(QTest::qWaitFor([&] { return second.jobState() == JobState::Ended; }, test::kPatience));
  EXPECT_EQ(watch.missing(true), "");
  EXPECT_EQ(second.order().pane(), 1);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !std::filesystem::exists(folderIn(scratch).resumePoint()); }, 5000));
}

TEST(ResumeOffer, KnowsThePanesOfTheOrderFromTheJournal) {
  const test::Scratch scratch;
  files::ResumePoint point = pointIn(planNamed("triangle.dxf")->job);
  point.pane = 3;
  point.panes = 5; // four are wanted, one was a reject
  leave(point, scratch);
  for (const auto& [pane, verdict] : {std::pair{1, files::Verdict::Good}, {2, files::Verdict::Reject}}) {
    ASSERT_TRUE(
        files::appendPane(folderIn(scratch).paneJournal(), {"t", "triangle.dxf", point.patternHash, pane, verdict, 1}));
  }
  MachineLink machine(fastWith(scratch));
  machine.resumeOffer().takeUp();
  ASSERT_TRUE(offerBecomes(machine.resumeOffer(), Offer::None));
  EXPECT_EQ(machine.order().wanted(), 4);
  EXPECT_EQ(machine.order().good(), 1);
  EXPECT_EQ(machine.order().rejects(), 1);
  EXPECT_EQ(machine.order().pane(), 3);
}

TEST(ResumeOffer, ThatIsDamagedIsToldAndSetAside) {
  const test::Scratch scratch;
  std::filesystem::create_directories(folderIn(scratch).root);
  std::ofstream(folderIn(scratch).resumePoint()) << "{\"arris_resume\": 1, ";
  MachineLink machine(fastWith(scratch));
  EXPECT_EQ(machine.resumeOffer().state(), Offer::SetAside);
  ASSERT_FALSE(machine.resumeOffer().problems().empty());
  EXPECT_TRUE(std::filesystem::exists(machine.resumeOffer().aside()));
  EXPECT_FALSE(std::filesystem::exists(folderIn(scratch).resumePoint()));
  getHome(machine); // and nobody is kept from working
  machine.load(planNamed("triangle.dxf"), 1);
  EXPECT_TRUE(machine.allowed().start);
  machine.resumeOffer().dismiss();
  EXPECT_EQ(machine.resumeOffer().state(), Offer::None);
}

TEST(ResumeOffer, OfAnotherStateOfThePatternSaysWhatDiffersAndSetsItAside) {
  const test::Scratch scratch;
  files::ResumePoint point = pointIn(planNamed("triangle.dxf")->job);
  point.patternHash = "fedcba9876543210";
  leave(point, scratch);
  MachineLink machine(fastWith(scratch));
  machine.resumeOffer().takeUp();
  ASSERT_TRUE(offerBecomes(machine.resumeOffer(), Offer::SetAside));
  ASSERT_EQ(machine.resumeOffer().problems().size(), 1U);
  EXPECT_EQ(machine.resumeOffer().problems()[0].code, base::Code::JobOfAnotherPattern);
  EXPECT_EQ(machine.loaded(), nullptr);
  EXPECT_TRUE(std::filesystem::exists(machine.resumeOffer().aside()));
}

// A pane that was broken off in a simulation does not lie on the machine.
TEST(ResumeOffer, OfOtherAxesIsNotTakenUpAndStays) {
  const test::Scratch scratch;
  files::ResumePoint point = pointIn(planNamed("triangle.dxf")->job);
  point.axes = files::Axes::Linuxcnc;
  leave(point, scratch);
  MachineLink machine(fastWith(scratch));
  machine.resumeOffer().takeUp();
  EXPECT_EQ(machine.resumeOffer().state(), Offer::Offered);
  ASSERT_EQ(machine.resumeOffer().problems().size(), 1U);
  EXPECT_THAT(base::describe(machine.resumeOffer().problems()[0]),
              testing::HasSubstr("axes was linuxcnc, now it is simulated"));
  EXPECT_TRUE(std::filesystem::exists(folderIn(scratch).resumePoint()));
}

TEST(ResumeOffer, WhosePatternOrMachineIsNotThereStaysAndCanBeTriedAgain) {
  const test::Scratch scratch;
  files::ResumePoint point = pointIn(planNamed("triangle.dxf")->job);
  point.patternFile = "on a stick that is not plugged in.dxf";
  point.machine.maxSpeed.x() = 6000;
  leave(point, scratch);
  {
    MachineLink machine(fastWith(scratch));
    machine.resumeOffer().takeUp();
    EXPECT_EQ(machine.resumeOffer().state(), Offer::Offered);
    ASSERT_EQ(machine.resumeOffer().problems().size(), 1U);
    EXPECT_THAT(base::describe(machine.resumeOffer().problems()[0]), testing::HasSubstr("max_speed_mm_min was 6000"));
  }
  MachineSetup setup = fastWith(scratch);
  setup.machine.maxSpeed.x() = 6000;
  MachineLink machine(setup);
  machine.resumeOffer().takeUp();
  EXPECT_EQ(machine.resumeOffer().state(), Offer::Planning);
  ASSERT_TRUE(offerBecomes(machine.resumeOffer(), Offer::Offered));
  EXPECT_EQ(machine.resumeOffer().problems().at(0).code, base::Code::CannotOpen);
}

TEST(ResumeOffer, ThatIsDiscardedIsGone) {
  const test::Scratch scratch;
  leave(pointIn(planNamed("triangle.dxf")->job), scratch);
  MachineLink machine(fastWith(scratch));
  machine.resumeOffer().discard();
  EXPECT_EQ(machine.resumeOffer().state(), Offer::None);
  EXPECT_FALSE(std::filesystem::exists(folderIn(scratch).resumePoint()));
}

TEST(ResumeOffer, MakesRoomForAnotherJobWithoutLosingAnything) {
  const test::Scratch scratch;
  const PlanPointer plan = planNamed("triangle.dxf");
  leave(pointIn(plan->job), scratch);
  MachineLink machine(fastWith(scratch));
  getHome(machine);
  machine.load(plan, 1);
  EXPECT_EQ(machine.resumeOffer().state(), Offer::SetAside);
  EXPECT_TRUE(std::filesystem::exists(machine.resumeOffer().aside()));
  EXPECT_FALSE(machine.goesOnWithAPane());
}

TEST(ResumeOffer, IsPlannedInTheBackground) {
  const test::Scratch scratch;
  leave(pointIn(planNamed("triangle.dxf")->job), scratch);
  std::atomic<bool> goesOn = false;
  std::atomic<bool> plans = false;
  std::thread::id planner;
  MachineSetup setup = fastWith(scratch);
  setup.steps.plan = [&, plan = setup.steps.plan](const auto& pattern, const auto& recipe, const auto& machine,
                                                  const auto& monitor) {
    planner = std::this_thread::get_id();
    plans = true;
    while (!goesOn) {
      std::this_thread::yield();
    }
    return plan(pattern, recipe, machine, monitor);
  };
  MachineLink machine(setup);
  machine.resumeOffer().takeUp();
  ASSERT_TRUE(QTest::qWaitFor([&] { return plans.load(); }, test::kPatience));
  getHome(machine); // the window goes on meanwhile
  EXPECT_EQ(machine.resumeOffer().state(), Offer::Planning);
  EXPECT_FALSE(machine.allowed().load);
  goesOn = true;
  ASSERT_TRUE(offerBecomes(machine.resumeOffer(), Offer::None));
  EXPECT_TRUE(machine.loaded());
  EXPECT_NE(planner, std::this_thread::get_id());
}

} // namespace
} // namespace arris::ui
