#include "core/files/whole_file.h"
#include "tests/ui/support/steps.h"
#include "ui/presenters/alarm_history.h"

#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <fstream>

namespace arris::ui {
namespace {

using control::State;

class History : public testing::Test {
protected:
  History() {
    std::filesystem::create_directories(m_scratch / "state");
  }

  std::filesystem::path log() {
    return m_scratch / "state/alarms.jsonl";
  }

  void putLine(const std::string& line) {
    std::ofstream(log(), std::ios::app) << line << '\n';
  }

  void putAlarm(const std::string& time, const std::string& code, bool acknowledged = false,
                const std::string& text = "It was so.") {
    putLine("{\"time\":\"" + time + "\",\"code\":\"" + code + "\",\"text\":\"" + text + "\",\"values\":{}," +
            "\"acknowledged\":" + (acknowledged ? "true}" : "false}"));
  }

  void begin() {
    m_machine.emplace(test::fastMachine(m_scratch));
    m_history.emplace(*m_machine);
    ASSERT_TRUE(QTest::qWaitFor([this] { return !m_history->isBusy(); }, test::kPatience));
  }

  bool becomes(State state) {
    return QTest::qWaitFor([&] { return m_machine->report().state == state; }, test::kPatience);
  }

  void tripAndRelease() {
    m_machine->inject(control::SimulatedFault::EmergencyStop);
    ASSERT_TRUE(becomes(State::EmergencyStop));
    m_machine->clearFaults();
    ASSERT_TRUE(QTest::qWaitFor([this] { return m_machine->allowed().acknowledge; }, test::kPatience));
  }

  test::Scratch m_scratch;
  std::optional<MachineLink> m_machine;
  std::optional<AlarmHistory> m_history;
};

TEST_F(History, OfEarlierStartsIsThereTheLatestFirst) {
  putAlarm("2031-05-06T07:08:09", "coolant-loss");
  putAlarm("2031-05-06T07:08:10", "vacuum-loss");
  putAlarm("2031-05-06T07:08:09", "coolant-loss", true);
  begin();
  ASSERT_EQ(m_history->all().size(), 2U);
  EXPECT_EQ(m_history->all()[0].alarm.code, "vacuum-loss");
  EXPECT_FALSE(m_history->all()[0].isActive);
  EXPECT_FALSE(m_history->all()[0].alarm.acknowledged);
  EXPECT_TRUE(m_history->all()[1].alarm.acknowledged);
  EXPECT_FALSE(m_history->chosen());
}

TEST_F(History, HasALiveAlarmWithoutAJobOnceInTheLogAndItsAcknowledgement) {
  begin();
  tripAndRelease();
  ASSERT_EQ(m_history->all().size(), 1U);
  EXPECT_TRUE(m_history->all()[0].isActive);
  EXPECT_EQ(m_history->chosen()->alarm.code, "emergency-stop");
  m_history->reload();
  ASSERT_TRUE(QTest::qWaitFor([this] { return !m_history->isBusy(); }, test::kPatience));
  EXPECT_EQ(m_history->all().size(), 1U); // from the log and live, but once
  EXPECT_EQ(files::readAlarms(log())->size(), 1U);
  m_machine->acknowledge();
  EXPECT_FALSE(m_history->all()[0].isActive);
  EXPECT_TRUE(m_history->all()[0].alarm.acknowledged);
  const auto logged = files::readAlarms(log());
  ASSERT_EQ(logged->size(), 1U);
  EXPECT_TRUE(logged->front().acknowledged);
  EXPECT_EQ(logged->front().text, "The emergency stop has tripped.");
}

TEST_F(History, ShowsActiveAlarmsAloneWhereThatIsAskedFor) {
  putAlarm("2031-05-06T07:08:09", "coolant-loss");
  begin();
  m_history->choose(m_history->all()[0].alarm);
  tripAndRelease();
  EXPECT_EQ(m_history->shown().size(), 2U);
  EXPECT_EQ(m_history->chosen()->alarm.code, "coolant-loss"); // what was tapped stays
  m_history->showActiveOnly(true);
  ASSERT_EQ(m_history->shown().size(), 1U);
  EXPECT_EQ(m_history->shown()[0].alarm.code, "emergency-stop");
  EXPECT_EQ(m_history->chosen()->alarm.code, "emergency-stop");
  m_machine->acknowledge();
  EXPECT_TRUE(m_history->shown().empty());
  EXPECT_FALSE(m_history->chosen());
}

TEST_F(History, TellsTwoAxesThatFailInOneSecondApart) {
  putAlarm("2031-05-06T07:08:09", "drive-fault", false, "The drive of X reports a fault.");
  putAlarm("2031-05-06T07:08:09", "drive-fault", false, "The drive of Y reports a fault.");
  begin();
  ASSERT_EQ(m_history->all().size(), 2U);
  for (const PastAlarm& past : m_history->all()) {
    m_history->choose(past.alarm);
    EXPECT_EQ(m_history->chosen()->alarm.text, past.alarm.text);
  }
}

// A fault of one axis often brings others: the first says what is to be done.
TEST_F(History, ChoosesTheFirstOfSeveralThatAreActive) {
  begin();
  m_machine->enable();
  ASSERT_TRUE(QTest::qWaitFor([this] { return m_machine->allowed().home; }, test::kPatience));
  m_machine->inject(control::SimulatedFault::DriveFault);
  ASSERT_TRUE(QTest::qWaitFor([this] { return !m_machine->alarms().empty(); }, test::kPatience));
  m_machine->inject(control::SimulatedFault::EmergencyStop);
  ASSERT_TRUE(QTest::qWaitFor([this] { return m_machine->alarms().size() > 1; }, test::kPatience));
  EXPECT_EQ(m_history->chosen()->alarm.code, m_machine->alarms().front().logged.code);
}

TEST_F(History, CountsDamagedLinesAndTellsThem) {
  putAlarm("2031-05-06T07:08:09", "coolant-loss");
  putLine("{\"time\":\"2031-05");
  putLine("[]");
  begin();
  EXPECT_EQ(m_history->all().size(), 1U);
  EXPECT_TRUE(m_history->isIncomplete());
  EXPECT_TRUE(m_history->summary().contains(QStringLiteral("cannot be read: 2"))) << m_history->summary().toStdString();
}

TEST_F(History, TellsWhereTheLogCannotBeRead) {
  std::filesystem::create_directories(log());
  begin();
  EXPECT_TRUE(m_history->isIncomplete());
  EXPECT_TRUE(m_history->summary().contains(QStringLiteral("cannot be read")));
}

TEST_F(History, TellsAnAlarmThatCannotBeLoggedAndShowsItAllTheSame) {
  std::filesystem::create_directories(log());
  begin();
  tripAndRelease();
  ASSERT_EQ(m_history->all().size(), 1U);
  ASSERT_TRUE(m_machine->complaint());
  EXPECT_EQ(m_machine->complaint()->code, base::Code::CannotWrite);
}

} // namespace
} // namespace arris::ui
