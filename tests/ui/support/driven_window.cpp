#include "tests/ui/support/driven_window.h"

#include "tests/ui/support/artefacts.h"
#include "tests/ui/support/locales.h"
#include "ui/figures/style.h"
#include "ui/text/quantities.h"
#include "ui/text/translators.h"
#include "ui/widgets/hold_button.h"
#include "ui/widgets/keypad.h"
#include "ui/widgets/theme.h"

#include <QApplication>
#include <QTest>

namespace arris::test {

using control::JobState;
using control::State;

namespace {

ui::MachineSetup drivenSetup(const Scratch& folder, control::Pace pace) {
  ui::MachineSetup setup = fastMachine(folder);
  setup.pace = pace;
  setup.machine.setPointLead = 0.2; // a busy computer wakes the thread late
  return setup;
}

} // namespace

DrivenWindow::DrivenWindow(control::Pace pace, ui::PlannerSteps steps)
    : m_window(drivenSetup(m_scratch, pace), std::move(steps)) {
  QObject::connect(&m_window.machine(), &ui::MachineLink::changed, &m_window,
                   [this] { m_seen.insert(m_window.machine().report().state); });
  m_window.resize(1024, 700);
  m_window.show();
}

void DrivenWindow::TearDown() {
  if (m_window.preferences().settings() == files::Settings()) {
    return;
  }
  ui::speak(QStringLiteral("en"));
  QLocale::setDefault(kEnglish);
  ui::showLengthsIn(ui::LengthUnit::Millimetre);
  ui::showAppearance(ui::Appearance::Light);
  ui::setKeypadOpens(ui::KeypadOpens::OnTouch);
  ui::applyTheme(*qApp);
}

void DrivenWindow::tap(const char* name) {
  ASSERT_TRUE(button(name) != nullptr) << name;
  const auto canBe = [&] { return button(name)->isEnabled() && button(name)->isVisible(); };
  ASSERT_TRUE(QTest::qWaitFor(canBe, kPatience)) << name;
  m_seen.clear();
  QTest::mouseClick(button(name), Qt::LeftButton);
}

void DrivenWindow::holdDown(const char* name) {
  ASSERT_TRUE(QTest::qWaitFor([&] { return button(name)->isEnabled(); }, kPatience)) << name;
  QTest::mousePress(button(name), Qt::LeftButton);
  QTest::qWait(ui::HoldButton::kHoldFor + 200);
  QTest::mouseRelease(button(name), Qt::LeftButton);
}

void DrivenWindow::settle() {
  ASSERT_TRUE(QTest::qWaitFor([this] { return !m_window.planner().isBusy(); }, kPatience));
  for (int i = 0; i < 5; ++i) { // layouts settle in turns
    QTest::qWait(1);
  }
}

bool DrivenWindow::becomes(State state) {
  const auto isSo = [&] { return m_window.machine().report().state == state || m_seen.contains(state); };
  return QTest::qWaitFor(isSo, kPatience);
}

bool DrivenWindow::becomes(JobState state) {
  return QTest::qWaitFor([&] { return m_window.machine().jobState() == state; }, kPatience);
}

void DrivenWindow::keep(const std::string& name) {
  QTest::qWait(20);
  test::keep(name, m_window);
}

void DrivenWindow::getReady() {
  m_window.openPattern("triangle.dxf");
  tap("pageSetup");
  tap("enable");
  tap("home");
  ASSERT_TRUE(becomes(State::Idle));
  tap("pageRun");
  tap("loadJob");
}

void DrivenWindow::getOntoGlass() {
  m_window.machine().setOverride(0.1);
  holdDown("cycleStart");
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_window.machine().report().place.segment >= 4; }, kPatience));
}

} // namespace arris::test
