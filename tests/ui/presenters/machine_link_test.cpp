#include "core/files/run_record.h"
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

TEST(Allowed, IsNothingButAcknowledgingInAFaultAndNothingAtAllWhileTheEmergencyStopIsPressed) {
  control::Report report;
  report.state = State::Faulted;
  report.homed = report.drivesReady = true;
  Allowed expected;
  expected.acknowledge = true;
  expected.disable = allowedIn(report, JobState::Aborted, true, false).disable;
  expected.load = true;
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
