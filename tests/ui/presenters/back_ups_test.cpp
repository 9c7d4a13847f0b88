#include "core/files/counters.h"
#include "core/files/whole_file.h"
#include "tests/ui/support/steps.h"
#include "ui/presenters/back_ups.h"

#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

namespace arris::ui {
namespace {

class BackUpsOfAMachine : public testing::Test {
protected:
  BackUpsOfAMachine() : m_machine(test::fastMachine(m_scratch)), m_backUps(m_machine) {}

  void put(const char* name, const std::string& text) {
    const std::filesystem::path file = m_scratch / "state" / name;
    std::filesystem::create_directories(file.parent_path());
    ASSERT_TRUE(files::writeWholeFile(file, text));
  }

  std::string text(const char* name) {
    return files::readFile(m_scratch / "state" / name).value_or("");
  }

  bool isDone() {
    return QTest::qWaitFor([this] { return !m_backUps.isBusy(); }, test::kPatience);
  }

  test::Scratch m_scratch;
  MachineLink m_machine;
  BackUps m_backUps;
};

const std::string kFeedOf1200 = "{\"arris_recipe\": 1, \"feed_mm_min\": 1200}";
const std::string kFeedOf2400 = "{\"arris_recipe\": 1, \"feed_mm_min\": 2400}";

TEST_F(BackUpsOfAMachine, RestoreOnlyWhatWasConfirmed) {
  put("recipe.json", kFeedOf1200);
  m_backUps.saveBackUp(m_scratch / "kept.tar.gz");
  EXPECT_TRUE(m_backUps.isBusy());
  ASSERT_TRUE(isDone());
  EXPECT_FALSE(m_backUps.sign()) << m_backUps.message().toStdString();
  EXPECT_TRUE(m_backUps.message().contains(QStringLiteral("kept.tar.gz")));
  put("recipe.json", kFeedOf2400);
  QSignalSpy restored(&m_backUps, &BackUps::restored);
  m_backUps.open(m_scratch / "kept.tar.gz");
  ASSERT_TRUE(isDone());
  ASSERT_TRUE(m_backUps.opened());
  m_backUps.giveUp();
  EXPECT_EQ(text("recipe.json"), kFeedOf2400);
  m_backUps.restore(); // nothing waits any more
  EXPECT_FALSE(m_backUps.isBusy());
  m_backUps.open(m_scratch / "kept.tar.gz");
  ASSERT_TRUE(isDone());
  m_backUps.restore();
  ASSERT_TRUE(isDone());
  EXPECT_EQ(text("recipe.json"), kFeedOf1200);
  EXPECT_EQ(restored.count(), 1);
  EXPECT_TRUE(m_backUps.message().contains(QStringLiteral("before-restore-")));
}

TEST_F(BackUpsOfAMachine, RestoreNothingWhileTheMachineMoves) {
  put("recipe.json", kFeedOf1200);
  m_backUps.saveBackUp(m_scratch / "kept.tar.gz");
  ASSERT_TRUE(isDone());
  m_backUps.open(m_scratch / "kept.tar.gz");
  ASSERT_TRUE(isDone());
  put("recipe.json", kFeedOf2400);
  m_machine.enable();
  ASSERT_TRUE(QTest::qWaitFor([this] { return m_machine.allowed().home; }, test::kPatience));
  m_machine.home();
  bool moved = false;
  QObject::connect(&m_machine, &MachineLink::changed, &m_backUps, [&] {
    if (m_machine.report().state == control::State::Homing) {
      moved = true;
      EXPECT_FALSE(m_backUps.mayRestore());
      m_backUps.restore();
      EXPECT_FALSE(m_backUps.isBusy());
    }
  });
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_machine.report().state == control::State::Idle; }, test::kPatience));
  EXPECT_TRUE(moved);
  EXPECT_EQ(text("recipe.json"), kFeedOf2400);
  EXPECT_TRUE(m_backUps.mayRestore());
}

TEST_F(BackUpsOfAMachine, TheCountersGoOnFromThoseThatWereRestored) {
  put("counters.json", files::writeCounters({"2030-01-01T00:00:00", 7200, 0, 0, 5000, 11}));
  m_backUps.saveBackUp(m_scratch / "kept.tar.gz");
  ASSERT_TRUE(isDone());
  m_backUps.open(m_scratch / "kept.tar.gz");
  ASSERT_TRUE(isDone());
  EXPECT_EQ(m_machine.counters().panes, 0); // it began before they were there
  m_backUps.restore();
  ASSERT_TRUE(isDone());
  EXPECT_EQ(m_machine.counters().panes, 11);
  EXPECT_GE(m_machine.counters().drivesOn, 7200);
}

TEST_F(BackUpsOfAMachine, SayWhatIsWrongAndChangeNothing) {
  put("recipe.json", kFeedOf2400);
  ASSERT_TRUE(files::writeWholeFile(m_scratch / "letter.tar.gz", "no archive"));
  m_backUps.open(m_scratch / "letter.tar.gz");
  ASSERT_TRUE(isDone());
  EXPECT_FALSE(m_backUps.opened());
  EXPECT_EQ(m_backUps.sign(), base::Severity::Error);
  EXPECT_TRUE(m_backUps.message().contains(QStringLiteral("it is no archive of Arris")));
  m_backUps.saveBackUp(m_scratch / "absent/kept.tar.gz");
  ASSERT_TRUE(isDone());
  EXPECT_EQ(m_backUps.sign(), base::Severity::Error);
  EXPECT_EQ(text("recipe.json"), kFeedOf2400);
}

TEST_F(BackUpsOfAMachine, SayWhereThereIsNothingToBackUp) {
  m_backUps.saveBackUp(m_scratch / "kept.tar.gz");
  ASSERT_TRUE(isDone());
  EXPECT_EQ(m_backUps.sign(), base::Severity::Warning);
  EXPECT_FALSE(std::filesystem::exists(m_scratch / "kept.tar.gz"));
}

TEST_F(BackUpsOfAMachine, SaveASupportBundleWithTheVersions) {
  m_backUps.saveSupportBundle(m_scratch / "support.tar.gz");
  ASSERT_TRUE(isDone());
  EXPECT_FALSE(m_backUps.sign());
  const auto files = files::readBundle(m_scratch / "support.tar.gz");
  ASSERT_TRUE(files);
  EXPECT_NE(files->front().bytes.find(qVersion()), std::string::npos);
}

TEST(CountersOfTheMachine, DamagedOnesAreToldAndKept) {
  const test::Scratch scratch;
  std::filesystem::create_directories(scratch / "state");
  ASSERT_TRUE(files::writeWholeFile(scratch / "state/counters.json", "half of"));
  const MachineLink machine(test::fastMachine(scratch));
  ASSERT_TRUE(machine.counterDamage());
  EXPECT_EQ(machine.complaint(), machine.counterDamage());
  EXPECT_EQ(files::readFile(scratch / "state/counters.json.damaged"), "half of");
}

} // namespace
} // namespace arris::ui
