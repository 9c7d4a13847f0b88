// The page Alarms in the window, driven as a person would.

#include "core/files/whole_file.h"
#include "tests/ui/support/artefacts.h"
#include "tests/ui/support/locales.h"
#include "tests/ui/support/steps.h"
#include "ui/main_window.h"
#include "ui/pages/alarms_page.h"

#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QTest>

#include <gtest/gtest.h>

#include <fstream>

namespace arris::ui {
namespace {

using control::State;

class AlarmsWindow : public testing::Test {
protected:
  AlarmsWindow() {
    std::filesystem::create_directories(m_scratch / "state");
  }

  void putAlarms(int count) {
    std::ofstream log(m_scratch / "state/alarms.jsonl");
    for (int i = 0; i < count; ++i) {
      const control::FaultInfo& row = control::allFaults()[static_cast<std::size_t>(i) % control::kFaultCount];
      log << "{\"time\":\"2031-05-" << 10 + i % 20 << "T07:" << 10 + i % 50 << ':' << 10 + i / 1000 << "\",\"code\":\""
          << row.name << "\",\"text\":\"x\",\"values\":{\"axis\":\"X\",\"value\":123.456},\"acknowledged\":"
          << (i % 3 == 0 ? "false" : "true") << "}\n";
    }
  }

  void open() {
    m_window = std::make_unique<MainWindow>(test::fastMachine(m_scratch), test::paneSteps());
    m_window->resize(1024, 700);
    m_window->show();
  }

  template <typename Widget = QPushButton> Widget* find(const char* name) {
    return m_window->findChild<Widget*>(QString::fromLatin1(name));
  }

  void tap(const char* name) {
    ASSERT_TRUE(find(name) != nullptr) << name;
    ASSERT_TRUE(QTest::qWaitFor([&] { return find(name)->isEnabled(); }, test::kPatience)) << name;
    ASSERT_TRUE(find(name)->isVisible()) << name;
    QTest::mouseClick(find(name), Qt::LeftButton);
  }

  std::string textOf(const char* name) {
    return find<QLabel>(name)->text().toStdString();
  }

  bool becomes(State state) {
    return QTest::qWaitFor([&] { return m_window->machine().report().state == state; }, test::kPatience);
  }

  bool hasRows(int count) {
    return QTest::qWaitFor([&] { return find<QTableView>("alarms")->model()->rowCount() == count; }, test::kPatience);
  }

  void keep(const std::string& name) {
    for (int i = 0; i < 5; ++i) { // layouts settle in turns
      QTest::qWait(1);
    }
    test::keep(name, *m_window);
  }

  void expectShown(const std::string& name) {
    keep(name);
    EXPECT_EQ(m_window->size(), QSize(1024, 700));
    test::expectNothingCutOff(*m_window);
  }

  void trip() {
    m_window->machine().inject(control::SimulatedFault::EmergencyStop);
    ASSERT_TRUE(becomes(State::EmergencyStop));
  }

  test::Scratch m_scratch;
  std::unique_ptr<MainWindow> m_window;
};

TEST_F(AlarmsWindow, ATapOnTheBannerLeadsToTheAlarmInFullAndItIsAcknowledgedThere) {
  open();
  trip();
  QTest::mouseClick(find<QLabel>("alarmText"), Qt::LeftButton);
  ASSERT_TRUE(find<QTableView>("alarms")->isVisible());
  EXPECT_TRUE(find("pageAlarms")->isChecked());
  ASSERT_TRUE(hasRows(1));
  EXPECT_NE(textOf("alarmDetail").find("What to do: Make the machine safe"), std::string::npos);
  EXPECT_NE(textOf("alarmDetail").find("active"), std::string::npos);
  EXPECT_FALSE(find("acknowledgeHere")->isEnabled()); // it is still pressed
  m_window->machine().clearFaults();
  tap("acknowledgeHere");
  ASSERT_TRUE(becomes(State::Off));
  tap("alarmsActive");
  ASSERT_TRUE(hasRows(0));
  EXPECT_EQ(textOf("alarmDetail"), "No alarm is active.");
  tap("alarmsAll");
  ASSERT_TRUE(hasRows(1));
}

TEST_F(AlarmsWindow, ThousandsOfAlarmsAreThereAndTheOneThatIsTappedIsShownInFull) {
  putAlarms(20000);
  open();
  tap("pageAlarms");
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return find<QTableView>("alarms")->model()->rowCount() > 10000; }, test::kPatience));
  auto* table = find<QTableView>("alarms");
  const QModelIndex third = table->model()->index(2, 3);
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(third).center());
  EXPECT_EQ(textOf("alarmDetail").find(third.data().toString().toStdString()), 0U);
  table->scrollToBottom();
  keep("alarms-many-bottom");
  EXPECT_EQ(table->currentIndex().row(), 2);
}

TEST_F(AlarmsWindow, APageThatIsMadeAnewShowsWhatTheOneBeforeShowed) {
  putAlarms(5);
  open();
  tap("pageAlarms");
  ASSERT_TRUE(hasRows(5));
  auto* table = find<QTableView>("alarms");
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(table->model()->index(3, 0)).center());
  const std::string detail = textOf("alarmDetail");
  MachineLink machine(test::fastMachine(m_scratch));
  AlarmsState state(machine);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !state.history.isBusy(); }, test::kPatience));
  state.history.choose(state.history.all()[3].alarm);
  state.part = 2;
  AlarmsPage again(machine, state);
  EXPECT_EQ(again.findChild<QLabel*>(QStringLiteral("alarmDetail"))->text().toStdString(), detail);
  EXPECT_EQ(again.findChild<QTableView*>(QStringLiteral("alarms"))->currentIndex().row(), 3);
  EXPECT_TRUE(again.findChild<QPushButton*>(QStringLiteral("showBackUp"))->isChecked());
}

TEST_F(AlarmsWindow, ShowsInputsAndOutputsAsTheyChange) {
  open();
  tap("pageAlarms");
  tap("showSignals");
  const QAbstractItemModel* inputs = find<QTableView>("inputSignals")->model();
  EXPECT_EQ(inputs->index(0, 1).data().toString(), QStringLiteral("released"));
  m_window->machine().inject(control::SimulatedFault::EmergencyStop);
  EXPECT_TRUE(QTest::qWaitFor([&] { return inputs->index(0, 1).data().toString() == QStringLiteral("tripped"); },
                              test::kPatience));
}

TEST_F(AlarmsWindow, WhatIsRestoredIsNotOverwrittenByWhatTheWindowKeeps) {
  const std::filesystem::path recipe = m_scratch / "state/recipe.json";
  const std::string restored = "{\"arris_recipe\": 1, \"feed_mm_min\": 1200}";
  ASSERT_TRUE(files::writeWholeFile(recipe, restored));
  open();
  BackUps& backUps = m_window->backUps();
  const auto isDone = [&] { return QTest::qWaitFor([&] { return !backUps.isBusy(); }, test::kPatience); };
  backUps.saveBackUp(m_scratch / "kept.tar.gz");
  ASSERT_TRUE(isDone());
  tap("pageAlarms");
  tap("showBackUp");
  backUps.open(m_scratch / "kept.tar.gz");
  ASSERT_TRUE(isDone());
  keep("alarms-restore");
  recipe::Recipe other;
  other.feed = 2400;
  m_window->planner().setRecipe(other);
  m_window->preferences().keepRecipe(other);
  ASSERT_NE(files::readFile(recipe), restored);
  tap("restoreConfirm");
  ASSERT_TRUE(isDone());
  EXPECT_EQ(files::readFile(recipe), restored);
  keep("alarms-restored");
  other.feed = 3000;
  m_window->planner().setRecipe(other);
  m_window.reset(); // it keeps the recipe at the end
  EXPECT_EQ(files::readFile(recipe), restored);
}

TEST_F(AlarmsWindow, StaysWhereItIsWhenTheWindowIsMadeAnew) {
  open();
  tap("pageAlarms");
  tap("showBackUp");
  files::Settings settings = m_window->preferences().settings();
  settings.appearance = files::Settings::Appearance::Dark;
  m_window->preferences().change(settings);
  QTest::qWait(1);
  EXPECT_TRUE(QTest::qWaitFor([&] { return find("showBackUp")->isVisible(); }, test::kPatience));
  EXPECT_TRUE(find("showBackUp")->isChecked());
  tap("showSignals");
  trip();
  keep("alarms-signals-dark");
  tap("showAlarms");
  ASSERT_TRUE(hasRows(1));
  keep("alarms-active-dark");
  settings.appearance = files::Settings::Appearance::Light;
  m_window->preferences().change(settings);
  QTest::qWait(1);
}

class TranslatedAlarmsWindow : public testing::WithParamInterface<std::string>,
                               public test::Language,
                               public AlarmsWindow {
protected:
  TranslatedAlarmsWindow() : Language(GetParam()) {}
};

TEST_P(TranslatedAlarmsWindow, ShowsEverythingOnTheSmallestScreen) {
  const std::string language = "-" + GetParam();
  open();
  tap("pageAlarms");
  expectShown("alarms-empty" + language);
  putAlarms(2 * control::kFaultCount);
  std::ofstream(m_scratch / "state/alarms.jsonl", std::ios::app) << "half a li\n";
  trip();
  tap("pageRun");
  tap("pageAlarms");
  ASSERT_TRUE(QTest::qWaitFor([&] { return find<QTableView>("alarms")->model()->rowCount() > 20; }, test::kPatience));
  expectShown("alarms-active" + language);
  tap("showSignals");
  expectShown("alarms-signals" + language);
  tap("showBackUp");
  expectShown("alarms-back-up" + language);
}

std::vector<std::string> languagesOfAlarms() {
  std::vector<std::string> names = test::languages();
  names.emplace_back("en");
  return names;
}

INSTANTIATE_TEST_SUITE_P(Languages, TranslatedAlarmsWindow, testing::ValuesIn(languagesOfAlarms()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace arris::ui
