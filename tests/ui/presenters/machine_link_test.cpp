#include "core/control/broken_job.h"
#include "core/files/run_record.h"
#include "core/files/whole_file.h"
#include "tests/ui/support/steps.h"
#include "ui/presenters/machine_link.h"
#include "ui/text/machine_texts.h"

#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <fstream>

namespace arris::ui {
namespace {

using control::JobState;
using control::State;

class Machine : public testing::Test {
protected:
  Machine() : m_machine(test::fastMachine(m_scratch)), m_planner({}, test::paneSteps()) {
    QObject::connect(&m_planner, &Planner::planned, &m_planner, [this](const PlanPointer& plan) { m_plan = plan; });
  }

  bool becomes(State state) {
    return QTest::qWaitFor([&] { return m_machine.report().state == state; }, test::kPatience);
  }

  bool becomes(JobState state) {
    return QTest::qWaitFor([&] { return m_machine.jobState() == state; }, test::kPatience);
  }

  void getReady() {
    m_planner.openPattern("triangle.dxf");
    ASSERT_TRUE(QTest::qWaitFor([this] { return m_plan != nullptr; }, test::kPatience));
    m_machine.enable();
    ASSERT_TRUE(QTest::qWaitFor([this] { return m_machine.allowed().home; }, test::kPatience));
    m_machine.home();
    ASSERT_TRUE(becomes(State::Idle));
  }

  test::Scratch m_scratch;
  MachineLink m_machine;
  Planner m_planner;
  PlanPointer m_plan;
};

TEST_F(Machine, GrindsAPaneAndLeavesARecordOfIt) {
  getReady();
  m_machine.load(m_plan, 2);
  m_machine.start();
  ASSERT_TRUE(becomes(JobState::Running));
  ASSERT_TRUE(becomes(JobState::Ended));
  EXPECT_EQ(m_machine.panesDone(), 1);
  EXPECT_EQ(m_machine.panesOrdered(), 2);
  ASSERT_TRUE(becomes(State::Idle));
  ASSERT_TRUE(QTest::qWaitFor([&] { return files::readRecord(m_machine.record()).has_value(); }, test::kPatience));
  m_machine.start(); // the next one
  ASSERT_TRUE(becomes(JobState::Running));
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_machine.panesDone() == 2; }, test::kPatience));
}

TEST_F(Machine, KeepsTheLoadedJobAsItWasWhateverIsPlannedMeanwhile) {
  getReady();
  m_machine.load(m_plan, 1);
  const PlanPointer loaded = m_plan;
  m_machine.start();
  ASSERT_TRUE(becomes(JobState::Running));
  recipe::Recipe other;
  other.feed = 1200;
  m_planner.setRecipe(other);
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_plan != loaded; }, test::kPatience));
  m_machine.load(m_plan, 1); // refused while the machine works
  EXPECT_EQ(m_machine.loaded(), loaded);
  EXPECT_DOUBLE_EQ(m_machine.loaded()->job.recipe.feed, 3600);
}

TEST_F(Machine, LoadsNothingWhereItsRunsCouldLeaveNothingToResumeFromAndSaysSo) {
  std::ofstream(m_scratch / "state") << "a file where the folder should be";
  getReady();
  QSignalSpy changed(&m_machine, &MachineLink::changed);
  m_machine.load(m_plan, 1);
  EXPECT_EQ(m_machine.loaded(), nullptr);
  ASSERT_TRUE(m_machine.complaint());
  EXPECT_EQ(m_machine.complaint()->code, base::Code::CannotWrite);
  EXPECT_GE(changed.count(), 1);
  EXPECT_FALSE(m_machine.allowed().start);
}

TEST_F(Machine, TellsAFaultOnceAndResumesTheJobOnlyAfterItsAcknowledgementAndACycleStart) {
  getReady();
  m_machine.load(m_plan, 1);
  QSignalSpy raised(&m_machine, &MachineLink::alarmRaised);
  m_machine.start();
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_machine.report().place.segment >= 3; }, test::kPatience));
  m_machine.inject(control::SimulatedFault::CoolantLoss);
  ASSERT_TRUE(becomes(State::Faulted));
  EXPECT_EQ(raised.count(), 1);
  ASSERT_EQ(m_machine.alarms().size(), 1U);
  EXPECT_TRUE(m_machine.alarms().front().isActive);
  EXPECT_FALSE(m_machine.allowed().start);
  m_machine.clearFaults();
  m_machine.acknowledge();
  ASSERT_TRUE(becomes(State::Idle));
  EXPECT_FALSE(m_machine.alarms().front().isActive);
  QTest::qWait(20); // nothing restarts by itself
  EXPECT_EQ(m_machine.report().state, State::Idle);
  EXPECT_EQ(m_machine.jobState(), JobState::Aborted);
  m_machine.start();
  ASSERT_TRUE(becomes(JobState::Running));
  ASSERT_TRUE(becomes(JobState::Ended));
}

TEST_F(Machine, JogsByExactlyAStepOneAPress) {
  getReady();
  const auto jogs = [&](const Eigen::Vector3d& way) {
    const Eigen::Vector3d before = m_machine.report().commanded;
    m_machine.jogBy(way);
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return m_machine.report().state == State::Idle && m_machine.report().commanded != before; },
        test::kPatience));
    const Eigen::Vector3d moved = m_machine.report().commanded - before;
    EXPECT_LT((moved - way).cwiseAbs().maxCoeff(), 1e-9) << moved.transpose();
  };
  jogs({10, 0, 0}); // off the end of the travel
  jogs({0, 0, -1});
  jogs({0.01, 0, 0});
  jogs({0, 1, 0});
  jogs({-0.1, 0, 0});
}

TEST_F(Machine, EndsAJogByAStepAtAHoldToo) {
  getReady();
  const double before = m_machine.report().commanded.x();
  m_machine.jogBy({1000, 0, 0});
  ASSERT_TRUE(becomes(State::Jogging));
  m_machine.hold();
  ASSERT_TRUE(becomes(State::Idle));
  const double after = m_machine.report().commanded.x();
  EXPECT_LT(after - before, 999);
  QTest::qWait(20);
  EXPECT_EQ(m_machine.report().commanded.x(), after);
}

TEST_F(Machine, CountsOnlyTheGoodPanesOfAnOrderAndKeepsAJournalOfAll) {
  getReady();
  m_machine.load(m_plan, 2);
  OrderBook& order = m_machine.order();
  const auto grind = [&] {
    const int done = m_machine.panesDone();
    ASSERT_TRUE(QTest::qWaitFor([&] { return m_machine.allowed().start; }, test::kPatience));
    m_machine.start();
    ASSERT_TRUE(QTest::qWaitFor([&] { return m_machine.panesDone() > done; }, test::kPatience));
    ASSERT_TRUE(QTest::qWaitFor([&] { return m_machine.allowed().judge; }, test::kPatience));
  };
  grind();
  EXPECT_EQ(order.open(), OrderBook::Open::Ended);
  EXPECT_EQ(order.good(), 0);
  m_machine.judge(files::Verdict::Reject);
  EXPECT_EQ(order.good(), 0);
  EXPECT_EQ(order.rejects(), 1);
  EXPECT_EQ(order.toGrind(), 3);
  grind();
  m_machine.judge(files::Verdict::Good);
  EXPECT_FALSE(order.isComplete());
  m_machine.judge(files::Verdict::Good); // once
  EXPECT_EQ(order.good(), 1);
  grind(); // nobody says anything of this one
  EXPECT_FALSE(order.isComplete());
  grind();
  EXPECT_TRUE(order.isComplete());
  std::vector<files::PaneEntry> panes;
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        panes = files::readPanes(m_scratch / "state/panes.jsonl").value_or(std::vector<files::PaneEntry>());
        return panes.size() == 3;
      },
      test::kPatience));
  const std::vector<files::Verdict> said{files::Verdict::Reject, files::Verdict::Good, files::Verdict::Good};
  for (std::size_t i = 0; i < panes.size(); ++i) {
    EXPECT_EQ(panes[i].pane, static_cast<int>(i) + 1);
    EXPECT_EQ(panes[i].verdict, said[i]);
    EXPECT_EQ(panes[i].patternFile, "triangle.dxf");
    EXPECT_NEAR(panes[i].duration, m_plan->job.duration, 5); // from wherever the wheel stood
  }
}

TEST_F(Machine, GivesUpAPaneThatWasBrokenOffAndBeginsTheNextAnew) {
  getReady();
  m_machine.load(m_plan, 2);
  m_machine.start();
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_machine.progress() > 0.3; }, test::kPatience));
  m_machine.stop();
  ASSERT_TRUE(becomes(JobState::Aborted));
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_machine.allowed().judge; }, test::kPatience));
  EXPECT_TRUE(m_machine.goesOnWithAPane());
  m_machine.judge(files::Verdict::Good); // it is not even ground
  EXPECT_EQ(m_machine.order().open(), OrderBook::Open::Broken);
  m_machine.judge(files::Verdict::Reject);
  EXPECT_FALSE(m_machine.goesOnWithAPane());
  EXPECT_EQ(m_machine.order().pane(), 2);
  EXPECT_EQ(m_machine.progress(), 0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_machine.allowed().start; }, test::kPatience));
  m_machine.start();
  ASSERT_TRUE(becomes(JobState::Running));
  EXPECT_LT(m_machine.progress(), 0.3);
  ASSERT_TRUE(becomes(JobState::Ended));
}

TEST_F(Machine, TakesANewSizeCorrectionWithTheNextLoadOnlyAndGoesOnWithTheOrder) {
  getReady();
  m_machine.load(m_plan, 3);
  const PlanPointer loaded = m_machine.loaded();
  m_machine.start();
  ASSERT_TRUE(becomes(JobState::Running));
  recipe::Recipe recipe = m_planner.recipe();
  recipe.sizeCorrection = 0.05;
  m_planner.setRecipe(recipe);
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_plan != loaded; }, test::kPatience));
  EXPECT_TRUE(m_machine.isRevision(*m_plan));
  EXPECT_EQ(m_machine.loaded(), loaded);
  EXPECT_EQ(m_machine.loaded()->job.recipe.sizeCorrection, 0);
  ASSERT_TRUE(becomes(JobState::Ended));
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_machine.allowed().load; }, test::kPatience));
  m_machine.load(m_plan);
  EXPECT_EQ(m_machine.loaded()->job.recipe.sizeCorrection, 0.05);
  EXPECT_FALSE(m_machine.isRevision(*m_plan));
  EXPECT_EQ(m_machine.order().good(), 1); // the order goes on
  EXPECT_EQ(m_machine.order().pane(), 2);
  m_machine.load(m_plan); // the same again: a new order
  EXPECT_EQ(m_machine.order().good(), 0);
}

TEST_F(Machine, TellsHowMuchIsGroundAndDoesNotBeginAnewWhereAPaneIsGoneOnWith) {
  getReady();
  m_machine.load(m_plan, 1);
  const program::WorkingWay way(m_plan->job);
  EXPECT_EQ(m_machine.progress(), 0);
  EXPECT_DOUBLE_EQ(m_machine.wayLeft(), way.length());
  m_machine.start();
  ASSERT_TRUE(becomes(JobState::Running));
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_machine.progress() > 0.4; }, test::kPatience));
  m_machine.stop();
  ASSERT_TRUE(becomes(JobState::Aborted));
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_machine.allowed().start; }, test::kPatience));
  const double ground = m_machine.progress();
  EXPECT_NEAR(ground, way.before(m_machine.report().place) / way.length(), 1e-3);
  double least = 1;
  QObject::connect(&m_machine, &MachineLink::reported, &m_planner,
                   [&] { least = std::min(least, m_machine.progress()); });
  m_machine.start();
  ASSERT_TRUE(becomes(JobState::Running));
  ASSERT_TRUE(becomes(JobState::Ended));
  EXPECT_GE(least, ground);
  EXPECT_EQ(m_machine.progress(), 1);
  EXPECT_EQ(m_machine.timeLeft(), 0);
}

TEST_F(Machine, TellsTheTimeLeftAtTheOverrideInEffect) {
  getReady();
  m_machine.load(m_plan, 1);
  for (const double factor : {1.0, 0.5, 1.5}) {
    m_machine.setOverride(factor);
    const double expected = program::Timetable(m_plan->job, factor).left({});
    EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(m_machine.timeLeft() - expected) < 1e-9; }, 5000))
        << factor << ": " << m_machine.timeLeft() << " s instead of " << expected << " s";
  }
}

TEST_F(Machine, TellsAtOnceThatTheJobNoLongerFitsWithAnotherOrigin) {
  getReady();
  m_machine.load(m_plan, 1);
  m_machine.setOrigin({900, 0, 0});
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_machine.report().origin.x() == 900; }, test::kPatience));
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_machine.complaint().has_value(); }, test::kPatience));
  EXPECT_EQ(m_machine.complaint()->code, base::Code::OutsideTravel);
  m_machine.start(); // refused
  QTest::qWait(50);
  EXPECT_EQ(m_machine.report().state, State::Idle);
  EXPECT_TRUE(m_machine.complaint());
  m_machine.setOrigin({10, 20, 0});
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_machine.report().origin.x() == 10; }, test::kPatience));
  EXPECT_TRUE(QTest::qWaitFor([&] { return !m_machine.complaint(); }, test::kPatience));
}

TEST_F(Machine, TurnsTheSpindleByHandAndStopSwitchesItOff) {
  getReady();
  m_machine.spindleByHand(1234);
  m_machine.coolantByHand(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_machine.report().outputs.spindleSpeed == 1234; }, test::kPatience));
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_machine.report().inputs.coolantFlows; }, test::kPatience));
  EXPECT_EQ(m_machine.report().state, State::Idle);
  EXPECT_TRUE(m_machine.allowed().stop);
  m_machine.stop();
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_machine.report().outputs.spindleSpeed == 0; }, test::kPatience));
  EXPECT_FALSE(m_machine.report().outputs.coolant);
  EXPECT_FALSE(m_machine.allowed().stop);
}

TEST(Allowed, IsNoJogWithoutTheJogEnableThatIsRequired) {
  control::Report report;
  report.state = State::Idle;
  report.homed = report.drivesReady = true;
  EXPECT_TRUE(allowedIn(report, JobState::Idle, false, false).jog);
  report.mayJog = false;
  EXPECT_FALSE(allowedIn(report, JobState::Idle, false, false).jog);
}

TEST(Allowed, IsNoOtherOriginWhileAPaneIsBrokenOff) {
  control::Report report;
  report.state = State::Idle;
  report.homed = report.drivesReady = true;
  EXPECT_TRUE(allowedIn(report, JobState::Ended, true, false).origin);
  EXPECT_FALSE(allowedIn(report, JobState::Aborted, true, false).origin);
}

TEST(Allowed, IsNothingButAcknowledgingInAFaultAndNothingAtAllWhileTheEmergencyStopIsPressed) {
  control::Report report;
  report.state = State::Faulted;
  report.homed = report.drivesReady = true;
  Allowed expected;
  expected.acknowledge = true;
  expected.disable = allowedIn(report, JobState::Aborted, true, false).disable;
  expected.load = true;
  expected.judge = true;
  EXPECT_EQ(allowedIn(report, JobState::Aborted, true, false), expected);
  report.state = State::EmergencyStop;
  report.inputs.emergencyStop = true;
  const Allowed pressed = allowedIn(report, JobState::Aborted, true, false);
  EXPECT_FALSE(pressed.acknowledge || pressed.start || pressed.jog || pressed.home || pressed.enable);
}

TEST(Allowed, IsToHoldAndToStopWheneverTheAxesMayMove) {
  for (int state = 0; state < control::kStateCount; ++state) {
    control::Report report;
    report.state = static_cast<State>(state);
    const Allowed allowed = allowedIn(report, JobState::Running, true, false);
    EXPECT_EQ(allowed.stop, control::isMoving(report.state)) << control::name(report.state);
    if (allowed.start || allowed.resume) {
      EXPECT_TRUE(report.state == State::Held || report.state == State::Holding || report.state == State::Idle);
    }
  }
}

TEST(MachineTexts, GiveEverySentenceOfTheTableOfFaultsToTheTranslators) {
  std::size_t i = 0;
  for (const control::FaultInfo& row : control::allFaults()) {
    for (const std::string_view english : {row.text, row.cause, row.remedy}) {
      ASSERT_LT(i, faultSentences().size());
      EXPECT_EQ(faultSentences()[i++], english);
    }
  }
  EXPECT_EQ(i, faultSentences().size());
}

} // namespace
} // namespace arris::ui
