// Which axes the window drives: chosen on the page of settings, asked for at the start, and to be seen at all times.

#include "tests/support/ideal_axes.h"
#include "tests/ui/support/artefacts.h"
#include "tests/ui/support/locales.h"
#include "tests/ui/support/long_texts.h"
#include "tests/ui/support/steps.h"
#include "ui/main_window.h"
#include "ui/pages/setup_page.h"
#include "ui/text/translators.h"

#include <QLabel>
#include <QPushButton>
#include <QTest>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace arris::ui {
namespace {

using Axes = files::Axes;

/// One window after the other on one state folder; the module of the LinuxCNC axes is nowhere.
class AxesWindow : public testing::Test {
protected:
  AxesWindow() {
    open({});
  }

  void TearDown() override {
    m_window.reset();
    speak(QStringLiteral("en"));
    QLocale::setDefault(test::kEnglish);
  }

  void open(std::optional<Axes> axes) {
    m_window.reset();
    MachineSetup setup = test::fastMachine(m_scratch);
    setup.axes = axes;
    m_window = std::make_unique<MainWindow>(setup, test::paneSteps());
    m_window->resize(1024, 700);
    m_window->show();
  }

  template <typename Widget = QPushButton> Widget* find(const char* name) {
    return m_window->findChild<Widget*>(QString::fromLatin1(name));
  }

  void tap(const char* name) {
    ASSERT_TRUE(find(name) != nullptr) << name;
    ASSERT_TRUE(find(name)->isEnabled()) << name;
    QTest::mouseClick(find(name), Qt::LeftButton);
    QTest::qWait(1);
  }

  void choose(const char* axes) {
    tap("pageSettings");
    tap("settingsMachine");
    tap(axes);
  }

  QString label(const char* name) {
    return find<QLabel>(name)->text();
  }

  test::Scratch m_scratch;
  std::unique_ptr<MainWindow> m_window;
};

TEST_F(AxesWindow, DrivesSimulatedAxesAtFirstAndSaysSo) {
  EXPECT_TRUE(m_window->machine().isSimulated());
  EXPECT_TRUE(label("machineState").endsWith(QStringLiteral("\nSimulated axes")));
  EXPECT_NE(find("showSimulation"), nullptr);
  choose("axesSimulated");
  EXPECT_TRUE(find("axesSimulated")->isChecked());
  QTest::qWait(5);
  test::keep("settings-axes", *m_window);
  test::expectNothingCutOff(*m_window);
}

TEST_F(AxesWindow, TakesTheAxesThatAreChosenFromTheNextStart) {
  choose("axesLinuxcnc");
  EXPECT_EQ(m_window->preferences().settings().axes, Axes::Linuxcnc);
  EXPECT_TRUE(m_window->machine().isSimulated());
  open({});
  EXPECT_FALSE(m_window->machine().isSimulated());
  choose("axesSimulated");
  open({});
  EXPECT_TRUE(m_window->machine().isSimulated());
}

TEST_F(AxesWindow, TakesThoseThatAreAskedForAtAStartForThisOne) {
  open(Axes::Linuxcnc);
  EXPECT_FALSE(m_window->machine().isSimulated());
  EXPECT_EQ(m_window->preferences().settings().axes, Axes::Simulated);
  choose("axesLinuxcnc");
  open(Axes::Simulated);
  EXPECT_TRUE(m_window->machine().isSimulated());
  open({});
  EXPECT_FALSE(m_window->machine().isSimulated());
}

TEST_F(AxesWindow, KeepsTheChoiceBehindTheCode) {
  m_window->preferences().setCode(QStringLiteral("4711"));
  m_window->preferences().lock();
  EXPECT_FALSE(find("axesLinuxcnc")->isEnabled());
  EXPECT_FALSE(find("axesSimulated")->isEnabled());
  ASSERT_TRUE(m_window->preferences().open(QStringLiteral("4711")));
  EXPECT_TRUE(find("axesLinuxcnc")->isEnabled());
}

TEST_F(AxesWindow, OpensWithoutAxesThatAreNotAvailableSaysWhyAndPlansAllTheSame) {
  open(Axes::Linuxcnc);
  EXPECT_TRUE(label("machineState").endsWith(QStringLiteral("\nLinuxCNC: no axes")));
  EXPECT_TRUE(label("alarmText").contains(QStringLiteral("install linuxcnc-uspace-dev")));
  m_window->openPattern("triangle.dxf");
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_window->planner().curves() != nullptr; }, test::kPatience));
  tap("pageSetup");
  EXPECT_TRUE(label("guide").contains(QStringLiteral("Nothing can be moved")));
  EXPECT_TRUE(label("guide").contains(QStringLiteral("install linuxcnc-uspace-dev")));
  for (const char* button : {"enable", "home", "disable", "trace", "park", "jogXPlus", "acknowledge", "cycleStart"}) {
    EXPECT_FALSE(find(button)->isEnabled()) << button;
  }
  EXPECT_EQ(find("showSimulation"), nullptr);
  EXPECT_EQ(find("inject0"), nullptr);
  QTest::qWait(5);
  test::keep("setup-no-axes", *m_window);
  EXPECT_TRUE(m_window->close()) << "nothing moves";
}

TEST_F(AxesWindow, HasRoomForEverythingWithoutAxesInEveryLanguage) {
  const test::LongTexts longer({"arris::ui::SetupPage", "arris::ui::SettingsPage", "arris::ui::AlarmBanner"});
  for (const QString& language : spokenLanguages()) {
    speak(language);
    open(Axes::Linuxcnc);
    for (const char* page : {"pageSetup", "pageRun", "pageSettings"}) {
      tap(page);
      QTest::qWait(5);
      SCOPED_TRACE(language.toStdString() + " " + page);
      test::expectNothingCutOff(*m_window);
    }
    choose("axesLinuxcnc");
    SCOPED_TRACE(language.toStdString());
    test::expectNothingCutOff(*m_window);
    tap("axesSimulated");
  }
}

TEST_F(AxesWindow, SaysThatAxesArePresentThatAreNotSimulatedAndOffersNoFaultsOfThem) {
  const MachineSetup setup = test::fastMachine(m_scratch);
  auto axes = std::make_unique<test::IdealAxes>(setup.machine, Eigen::Vector3d(200, 300, 100), 10);
  MachineLink machine(setup, {std::move(axes), nullptr, std::nullopt, control::Pace::Simulated});
  const SetupPage page(machine);
  EXPECT_EQ(page.findChild<QPushButton*>(QStringLiteral("showSimulation")), nullptr);
  EXPECT_EQ(page.findChild<QWidget*>(QStringLiteral("simulation")), nullptr);
  EXPECT_TRUE(page.findChild<QLabel*>(QStringLiteral("guide"))->text().contains(QStringLiteral("drives on")));
}

TEST_F(AxesWindow, FallsBackToSimulatedAxesFromADamagedFileButSaysBoth) {
  m_window.reset();
  std::filesystem::create_directories(m_scratch / "state");
  std::ofstream(m_scratch / "state" / "settings.json") << R"({"arris_settings": 1, "axes": "mine"})";
  open({});
  EXPECT_TRUE(m_window->machine().isSimulated());
  EXPECT_TRUE(label("alarmText").contains(QStringLiteral("settings.json")));
  EXPECT_TRUE(label("machineState").endsWith(QStringLiteral("\nSimulated axes")));
}

} // namespace
} // namespace arris::ui
