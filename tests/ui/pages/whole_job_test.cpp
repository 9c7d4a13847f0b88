// A whole job as a person does it, with everything that comes in between; language and unit changed on the way.

#include "tests/ui/support/driven_window.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QLineEdit>
#include <QMessageBox>
#include <QTest>

namespace arris::ui {
namespace {

using control::JobState;
using control::State;

class WholeJob : public test::DrivenWindow {
protected:
  void choose(const char* language) {
    tap("pageSettings");
    auto* box = find<QComboBox>("language");
    box->setCurrentIndex(box->findData(QString::fromLatin1(language)));
    Q_EMIT box->activated(box->currentIndex());
    QTest::qWait(1); // the window is made anew by then
  }

  // With the button of the page, as often as it takes.
  void setOverride(const char* to, const char* by) {
    for (int taps = 0; taps < 20 && label("override") != QString::fromUtf8(to); ++taps) {
      const QString before = label("override");
      tap(by);
      ASSERT_TRUE(QTest::qWaitFor([&] { return label("override") != before; }, test::kPatience));
    }
    EXPECT_EQ(label("override"), QString::fromUtf8(to));
  }

  // Over onto the glass at the lowest override, whatever it is by now.
  void startOnGlass() {
    const int before = m_window.machine().panesDone();
    holdDown("cycleStart");
    ASSERT_TRUE(QTest::qWaitFor([&] { return m_window.machine().report().place.segment >= 4; }, test::kPatience));
    ASSERT_EQ(m_window.machine().panesDone(), before) << "it ran past";
  }

  QPushButton* answer(const char* text) {
    for (auto* question : m_window.findChildren<QMessageBox*>()) {
      for (QAbstractButton* one : question->buttons()) {
        if (one->text() == QString::fromLatin1(text)) {
          return qobject_cast<QPushButton*>(one);
        }
      }
    }
    return nullptr;
  }
};

TEST_F(WholeJob, FromAnEmptyProgramOverHoldOverrideAndFaultToTheSecondPane) {
  const MachineLink& machine = m_window.machine();
  getReady();
  tap("panesMore");
  setOverride("10 %", "overrideDown");
  startOnGlass();
  tap("feedHold");
  ASSERT_TRUE(becomes(State::Held));
  setOverride("20 %", "overrideUp"); // for what is to come
  tap("resume");
  ASSERT_TRUE(becomes(State::Running));
  const double ground = machine.progress();
  tap("pageSetup");
  tap("showSimulation");
  tap("inject4"); // the coolant fails
  ASSERT_TRUE(becomes(State::Faulted));
  EXPECT_TRUE(label("alarmText").contains(QStringLiteral("coolant")));
  EXPECT_EQ(machine.panesDone(), 0);
  tap("mend");
  tap("acknowledge");
  ASSERT_TRUE(becomes(State::Idle));
  EXPECT_EQ(label("alarmText"), QString());
  tap("pageRun");
  EXPECT_EQ(machine.jobState(), JobState::Aborted) << "nothing goes on of itself";
  EXPECT_TRUE(button("cycleStart")->text().contains(QStringLiteral("where it was broken off")));
  setOverride("100 %", "overrideUp");
  holdDown("cycleStart");
  ASSERT_TRUE(becomes(JobState::Ended));
  EXPECT_GE(machine.progress(), ground);
  EXPECT_EQ(machine.panesDone(), 1);
  tap("paneGood");
  EXPECT_TRUE(label("paneCounts").contains(QStringLiteral("Pane 2 of 2: 1 good, 0 rejected")));
  holdDown("cycleStart");
  ASSERT_TRUE(QTest::qWaitFor([&] { return machine.panesDone() == 2; }, test::kPatience));
  tap("paneGood");
  EXPECT_EQ(label("revision"), QStringLiteral("The order is complete."));
  keep("whole-job-complete");
}

TEST_F(WholeJob, RunsOnInAnotherLanguageAndUnitAndItsValuesKeepTheirMeaning) {
  getReady();
  getOntoGlass();
  const PlanPointer loaded = m_window.machine().loaded();
  const recipe::Recipe recipe = m_window.planner().recipe();
  choose("de");
  EXPECT_EQ(m_window.machine().jobState(), JobState::Running);
  EXPECT_EQ(find<QLineEdit>("depth_mm")->text(), QStringLiteral("0,13"));
  tap("unitInch");
  QTest::qWait(1);
  EXPECT_EQ(m_window.machine().jobState(), JobState::Running);
  EXPECT_EQ(find<QLineEdit>("wheel_radius_mm")->text(), QStringLiteral("2,952756")); // 75 / 25.4
  tap("pageRun");
  tap("feedHold"); // of the strip that was made anew
  ASSERT_TRUE(becomes(State::Held));
  QTest::qWait(100);
  const Eigen::Vector3d at = m_window.machine().report().measured;
  EXPECT_EQ(label("placeX").toStdString(), QLocale(QLocale::German).toString(at.x() / 25.4, 'f', 4).toStdString());
  keep("whole-job-german-inches");
  EXPECT_EQ(m_window.machine().loaded(), loaded);
  EXPECT_EQ(m_window.planner().recipe(), recipe);
  EXPECT_FALSE(m_window.machine().isRevision(*m_window.planner().plan()));
  tap("resume");
  m_window.machine().setOverride(1);
  ASSERT_TRUE(becomes(JobState::Ended));
  EXPECT_EQ(m_window.machine().panesDone(), 1);
}

TEST_F(WholeJob, RunsOnWhenItIsNotToBeClosedAndHoldsStillByTheTimeItIs) {
  getReady();
  getOntoGlass();
  m_window.close();
  ASSERT_TRUE(answer("Keep running") != nullptr);
  QTest::mouseClick(answer("Keep running"), Qt::LeftButton);
  QTest::qWait(1);
  EXPECT_TRUE(m_window.isVisible());
  EXPECT_EQ(m_window.machine().jobState(), JobState::Running);
  m_window.close();
  ASSERT_TRUE(answer("Stop and close") != nullptr);
  QTest::mouseClick(answer("Stop and close"), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !m_window.isVisible(); }, test::kPatience));
  EXPECT_FALSE(control::isMoving(m_window.machine().report().state));
  EXPECT_TRUE(std::filesystem::exists(m_scratch / "state/resume.json")) << "it can be gone on with later";
}

} // namespace
} // namespace arris::ui
