// The window on axes through LinuxCNC, in a HAL session without a machine.

#include "tests/core/control/linuxcnc/hal_session.h"
#include "tests/support/panes.h"
#include "tests/ui/support/artefacts.h"
#include "tests/ui/support/steps.h"
#include "ui/main_window.h"
#include "ui/widgets/hold_button.h"

#include <QLabel>
#include <QPushButton>
#include <QTest>

#include <gtest/gtest.h>
#include <unistd.h>

namespace arris::ui {
namespace {

using control::JobState;
using control::State;
using Axes = files::Axes;

PlannerSteps smallPaneSteps() {
  PlannerSteps steps = plannerSteps();
  steps.read = [](const std::filesystem::path& file, const pattern::ImportOptions& options, const base::Monitor&) {
    return base::Expected<Import>(Import{file, options, test::isosceles(70, 150), "0123456789abcdef"});
  };
  return steps;
}

/// Near the table's zero, and ground in some seconds.
recipe::Recipe smallRecipe() {
  recipe::Recipe recipe;
  recipe.wheelRadius = 20;
  recipe.accelX = recipe.accelY = recipe.accelZ = 400;
  recipe.feed = 9000;
  recipe.place = geometry::Point(100, 100);
  return recipe;
}

/// Homes quickly, and is patient with a computer that is shared. As the window's user left it: on LinuxCNC's axes.
MachineSetup setupIn(const test::Scratch& scratch) {
  MachineSetup setup{{}, {scratch / "state"}, control::Pace::Real};
  setup.machine.homeLatch = 1800;
  setup.machine.setPointLead = 0.2;
  setup.axes = Axes::Linuxcnc;
  setup.moduleFolders = {ARRIS_MODULE_DIR};
  return setup;
}

class LinuxcncWindow : public testing::Test {
protected:
  void SetUp() override {
    if (::access("/usr/bin/halcmd", X_OK) != 0) {
      GTEST_SKIP() << "LinuxCNC is not installed (package linuxcnc-uspace)";
    }
  }

  static QPushButton* button(MainWindow& window, const char* name) {
    return window.findChild<QPushButton*>(QString::fromLatin1(name));
  }

  static void tap(MainWindow& window, const char* name) {
    ASSERT_TRUE(button(window, name) != nullptr) << name;
    ASSERT_TRUE(QTest::qWaitFor([&] { return button(window, name)->isEnabled(); }, test::kPatience)) << name;
    QTest::mouseClick(button(window, name), Qt::LeftButton);
  }

  static bool becomes(MainWindow& window, State state) {
    return QTest::qWaitFor([&] { return window.machine().report().state == state; }, test::kPatience);
  }

  static QString label(MainWindow& window, const char* name) {
    return window.findChild<QLabel*>(QString::fromLatin1(name))->text();
  }

  static std::string faultsOf(MainWindow& window) {
    std::string faults;
    for (const Alarm& alarm : window.machine().alarms()) {
      faults += control::describe(alarm.fault) + "\n";
    }
    return faults;
  }

  static void show(MainWindow& window) {
    window.resize(1024, 700);
    window.show();
  }

  test::Scratch m_scratch;
};

TEST_F(LinuxcncWindow, SaysThatNoSessionRunsAndOpensAllTheSame) {
  MainWindow window(setupIn(m_scratch), smallPaneSteps());
  show(window);
  EXPECT_TRUE(label(window, "alarmText").contains(QStringLiteral("packaging/hal/start.sh")));
  QTest::qWait(300);
  EXPECT_FALSE(button(window, "enable")->isEnabled());
}

TEST_F(LinuxcncWindow, HomesGrindsAPaneWithAHoldInItAndLeavesTheDrivesOff) {
  const test::HalSession session("simulated");
  ASSERT_TRUE(session.runs());
  test::halcmd("setp watchdog.timeout-0 5");
  {
    MainWindow window(setupIn(m_scratch), smallPaneSteps());
    show(window);
    EXPECT_TRUE(label(window, "machineState").endsWith(QStringLiteral("\nAxes through LinuxCNC")));
    EXPECT_FALSE(window.machine().isSimulated());
    window.planner().setRecipe(smallRecipe());
    window.openPattern("small.dxf");
    tap(window, "pageSetup");
    tap(window, "enable");
    tap(window, "home");
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.machine().allowed().move; }, test::kPatience)) << faultsOf(window);
    EXPECT_EQ(test::halcmd("gets arris-x-drive-enable"), "TRUE\n");
    test::keep("setup-linuxcnc", window);
    tap(window, "pageRun");
    tap(window, "loadJob");
    ASSERT_TRUE(window.machine().loaded());
    QTest::mousePress(button(window, "cycleStart"), Qt::LeftButton);
    QTest::qWait(HoldButton::kHoldFor + 200);
    QTest::mouseRelease(button(window, "cycleStart"), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.machine().progress() > 0.2; }, test::kPatience))
        << faultsOf(window);
    EXPECT_NE(test::halcmd("gets arris-spindle-speed"), "0\n");
    tap(window, "feedHold");
    ASSERT_TRUE(becomes(window, State::Held)) << faultsOf(window);
    EXPECT_EQ(window.machine().jobState(), JobState::Interrupted);
    test::keep("run-linuxcnc-held", window);
    tap(window, "resume");
    ASSERT_TRUE(becomes(window, State::Running)) << faultsOf(window);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.machine().jobState() == JobState::Ended; }, test::kPatience))
        << faultsOf(window);
    EXPECT_EQ(window.machine().panesDone(), 1);
    EXPECT_EQ(faultsOf(window), "");
  }
  EXPECT_EQ(test::halcmd("gets arris-x-drive-enable"), "FALSE\n") << "when the window is closed";
}

TEST_F(LinuxcncWindow, BringsTheAxesToRestBeforeItCloses) {
  const test::HalSession session("simulated");
  ASSERT_TRUE(session.runs());
  test::halcmd("setp watchdog.timeout-0 5");
  double lastSpeed = -1;
  {
    MachineSetup setup = setupIn(m_scratch);
    setup.watcher = [&](const control::Report& report) { lastSpeed = report.velocity.norm(); };
    MainWindow window(setup, smallPaneSteps());
    show(window);
    tap(window, "pageSetup");
    tap(window, "enable");
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.machine().allowed().jog; }, test::kPatience));
    window.machine().home();
    ASSERT_TRUE(QTest::qWaitFor([&] { return lastSpeed > 5; }, test::kPatience)) << faultsOf(window);
  }
  EXPECT_EQ(lastSpeed, 0);
  EXPECT_EQ(test::halcmd("gets arris-x-drive-enable"), "FALSE\n");
  EXPECT_EQ(test::halcmd("getp chain.ok-out"), "TRUE\n") << "by Arris, not because it was silent";
}

} // namespace
} // namespace arris::ui
