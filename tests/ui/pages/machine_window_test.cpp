// The window with the simulated machine, driven as a person would.

#include "tests/ui/support/artefacts.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/locales.h"
#include "tests/ui/support/long_texts.h"
#include "tests/ui/support/steps.h"
#include "ui/main_window.h"
#include "ui/pages/run_page.h"
#include "ui/pages/setup_page.h"
#include "ui/text/machine_texts.h"
#include "ui/views/drawing_view.h"
#include "ui/widgets/hold_button.h"

#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>

#include <gtest/gtest.h>

#include <set>

namespace arris::ui {
namespace {

using control::JobState;
using control::State;

using test::DrivenWindow;

MachineSetup setupOf(const test::Scratch& folder, control::Pace pace) {
  MachineSetup setup = test::fastMachine(folder);
  setup.pace = pace;
  setup.machine.setPointLead = 0.2; // a busy computer wakes the thread late
  return setup;
}

class MachineWindow : public DrivenWindow {
protected:
  using DrivenWindow::DrivenWindow;
};

TEST_F(MachineWindow, TakesANewcomerFromAnEmptyProgramToTheSecondPane) {
  keep("run-empty");
  getReady();
  keep("run-loaded");
  tap("pageSetup");
  keep("setup-ready");
  tap("pageRun");
  holdDown("cycleStart");
  ASSERT_TRUE(becomes(JobState::Ended));
  EXPECT_EQ(m_window.machine().panesDone(), 1);
  ASSERT_TRUE(becomes(State::Idle));
  holdDown("cycleStart");
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_window.machine().panesDone() == 2; }, test::kPatience));
}

// The page Setup says what comes next, never what is not so.
TEST_F(MachineWindow, GuidesThroughTheSetup) {
  const auto expectGuide = [this](const char* words) {
    EXPECT_TRUE(QTest::qWaitFor([&] { return label("guide").startsWith(QLatin1String(words)); }, test::kPatience))
        << label("guide").toStdString();
  };
  expectGuide("Next: switch the drives on");
  tap("pageSetup");
  tap("enable");
  expectGuide("Next: home all axes");
  tap("home");
  ASSERT_TRUE(becomes(State::Idle));
  expectGuide("Next: load the job");
  m_window.openPattern("triangle.dxf");
  tap("pageRun");
  tap("loadJob");
  expectGuide("Ready for the cycle start");
  getOntoGlass();
  expectGuide("Something moves");
  tap("feedHold");
  ASSERT_TRUE(becomes(State::Held));
  expectGuide("Held: go on with RESUME");
  m_window.machine().inject(control::SimulatedFault::EmergencyStop);
  ASSERT_TRUE(becomes(State::EmergencyStop));
  expectGuide("Read the alarm above");
}

TEST_F(MachineWindow, HoldsStepsBackAndResumes) {
  getReady();
  getOntoGlass();
  tap("feedHold");
  ASSERT_TRUE(becomes(State::Held));
  EXPECT_EQ(m_window.machine().jobState(), JobState::Interrupted);
  keep("run-held");
  tap("stepBack");
  ASSERT_TRUE(becomes(State::Stepping));
  ASSERT_TRUE(becomes(State::Held));
  tap("resume");
  ASSERT_TRUE(becomes(State::Running));
  keep("run-running");
  m_window.machine().setOverride(1);
  ASSERT_TRUE(becomes(JobState::Ended));
}

TEST_F(MachineWindow, TellsAFaultOnEveryPageAndGoesOnAfterItsAcknowledgement) {
  getReady();
  getOntoGlass();
  tap("pageSetup");
  tap("showSimulation");
  tap("inject4"); // the coolant fails
  ASSERT_TRUE(becomes(State::Faulted));
  EXPECT_TRUE(m_window.findChild<QLabel*>(QStringLiteral("alarmText"))->text().contains(QStringLiteral("coolant")));
  EXPECT_TRUE(label("guide").startsWith("Read the alarm above")) << label("guide").toStdString();
  keep("setup-fault");
  tap("pageRun");
  EXPECT_TRUE(label("revision").contains("After the alarm CYCLE START goes on")) << label("revision").toStdString();
  keep("run-fault");
  EXPECT_FALSE(button("cycleStart")->isEnabled());
  tap("pageSetup");
  tap("mend");
  tap("acknowledge");
  ASSERT_TRUE(becomes(State::Idle));
  EXPECT_EQ(m_window.findChild<QLabel*>(QStringLiteral("alarmText"))->text(), QString());
  tap("pageRun");
  EXPECT_TRUE(label("revision").contains("broken off: CYCLE START goes on")) << label("revision").toStdString();
  m_window.machine().setOverride(1);
  holdDown("cycleStart"); // from where it was broken off
  ASSERT_TRUE(becomes(JobState::Ended));
}

TEST_F(MachineWindow, MarksWhatHasBeenGroundUpToTheWheelAndNothingAheadOfIt) {
  getReady();
  getOntoGlass();
  const auto* drawing = button("cycleStart")->parentWidget()->parentWidget()->findChild<DrawingView*>();
  tap("feedHold");
  ASSERT_TRUE(becomes(State::Held));
  QTest::qWait(20);
  const control::Report& report = m_window.machine().report();
  const job::Job& job = m_window.machine().loaded()->job;
  const motion::Segment& on = job.track[static_cast<std::size_t>(report.place.segment)];
  ASSERT_TRUE(motion::isAlongContour(on.move));
  const double end = motion::parameterLength(on);
  ASSERT_GT(report.place.lambda, 0.02 * end);
  ASSERT_LT(report.place.lambda, 0.9 * end);
  const QImage seen = drawing->viewport()->grab().toImage();
  const double radius = job.recipe.wheelRadius;
  const auto isMarkedAt = [&](double lambda) {
    const Eigen::Vector3d at = motion::evaluate(on, lambda).point;
    // Beside the middle of the line, where neither dashes nor arrows of the path are.
    const QPointF place = drawing->viewportTransform().map(toQt(at.head<2>())) + QPointF(0, 2);
    return seen.pixelColor(place.toPoint()).green() > seen.pixelColor(place.toPoint()).red() + 60;
  };
  EXPECT_FALSE(isMarkedAt(std::min(0.98 * end, report.place.lambda + 2 * radius)));
  EXPECT_TRUE(isMarkedAt(report.place.lambda / 2)) << report.place.lambda;
}

TEST_F(MachineWindow, DoesNotStartWhereTheButtonIsLetGoTooSoonAndShowsNoEmergencyStop) {
  getReady();
  ASSERT_TRUE(QTest::qWaitFor([&] { return button("cycleStart")->isEnabled(); }, test::kPatience));
  QTest::mousePress(button("cycleStart"), Qt::LeftButton);
  QTest::mouseRelease(button("cycleStart"), Qt::LeftButton);
  QTest::qWait(HoldButton::kHoldFor + 100);
  EXPECT_EQ(m_window.machine().report().state, State::Idle);
  for (const QPushButton* any : m_window.findChildren<QPushButton*>()) {
    const bool isSimulation = any->parentWidget()->objectName() == QStringLiteral("simulation");
    EXPECT_FALSE(!isSimulation && any->text().contains(QStringLiteral("emergency stop"), Qt::CaseInsensitive));
  }
}

TEST_F(MachineWindow, JogsByAStepWithTheSpaceBar) {
  tap("pageSetup");
  tap("enable");
  tap("home");
  ASSERT_TRUE(becomes(State::Idle));
  tap("jogStep3"); // 1 mm
  ASSERT_TRUE(QTest::qWaitFor([&] { return button("jogXPlus")->isEnabled(); }, test::kPatience));
  const Eigen::Vector3d before = m_window.machine().report().commanded;
  button("jogXPlus")->setFocus();
  QTest::keyClick(button("jogXPlus"), Qt::Key_Space);
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_window.machine().report().commanded != before; }, test::kPatience));
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_window.machine().report().state == State::Idle; }, test::kPatience));
  const Eigen::Vector3d way = m_window.machine().report().commanded - before;
  EXPECT_LT((way - Eigen::Vector3d(1, 0, 0)).norm(), 1e-9) << way.transpose();
  EXPECT_EQ(m_window.machine().jobState(), JobState::Idle); // nothing here starts a job
}

TEST_F(MachineWindow, SetsTheOriginHereAndAsTyped) {
  tap("pageSetup");
  tap("enable");
  tap("home");
  ASSERT_TRUE(becomes(State::Idle));
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_window.machine().allowed().move; }, test::kPatience));
  const Eigen::Vector3d at = m_window.machine().report().commanded;
  tap("showByHand");
  tap("originHereX");
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_window.machine().report().origin.x() == at.x(); }, test::kPatience));
  EXPECT_EQ(m_window.machine().report().origin.y(), 0);
  auto* typed = m_window.findChild<QLineEdit*>(QStringLiteral("origin_y_mm"));
  typed->setText(QStringLiteral("12.5"));
  tap("originSet");
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_window.machine().report().origin.y() == 12.5; }, test::kPatience));
  EXPECT_NEAR(m_window.machine().report().origin.x(), at.x(), 1e-6); // as it is shown
  EXPECT_EQ(m_window.machine().report().origin.z(), 0);
  typed->setText(QStringLiteral("wide"));
  EXPECT_FALSE(button("originSet")->isEnabled());
  EXPECT_TRUE(label("originHint").contains(QStringLiteral("not a number")));
}

TEST_F(MachineWindow, JudgesPanesAndCountsTheGoodOnes) {
  getReady();
  tap("panesMore");
  EXPECT_EQ(label("panesWanted"), QStringLiteral("2"));
  EXPECT_FALSE(button("paneGood")->isEnabled());
  holdDown("cycleStart");
  ASSERT_TRUE(becomes(JobState::Ended));
  tap("paneReject");
  EXPECT_TRUE(label("paneCounts").contains(QStringLiteral("Pane 2 of 3: 0 good, 1 rejected")))
      << "rejects are ground anew";
  holdDown("cycleStart");
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_window.machine().panesDone() == 2; }, test::kPatience));
  tap("paneGood");
  EXPECT_TRUE(label("paneCounts").contains(QStringLiteral("Pane 3 of 3: 1 good, 1 rejected")));
  EXPECT_FALSE(button("paneGood")->isEnabled());
}

TEST_F(MachineWindow, ChangesTheSizeForTheNextPaneAndLeavesTheLoadedJobAlone) {
  getReady();
  tap("panesMore");
  const PlanPointer loaded = m_window.machine().loaded();
  getOntoGlass();
  tap("correctionUp");
  tap("correctionUp");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !m_window.planner().isBusy(); }, test::kPatience));
  EXPECT_DOUBLE_EQ(m_window.planner().recipe().sizeCorrection, 0.02);
  EXPECT_EQ(m_window.machine().loaded(), loaded);
  EXPECT_TRUE(label("revision").contains(QStringLiteral("stays as it was loaded")));
  EXPECT_FALSE(button("loadJob")->isEnabled());
  m_window.machine().setOverride(1);
  ASSERT_TRUE(becomes(JobState::Ended));
  ASSERT_TRUE(QTest::qWaitFor([&] { return button("loadJob")->isEnabled(); }, test::kPatience));
  EXPECT_EQ(m_window.machine().loaded(), loaded);
  EXPECT_EQ(loaded->job.recipe.sizeCorrection, 0);
  EXPECT_TRUE(label("revision").contains(QStringLiteral("for the next pane")));
  EXPECT_EQ(button("loadJob")->text(), QStringLiteral("Load for the next pane"));
  tap("loadJob");
  EXPECT_DOUBLE_EQ(m_window.machine().loaded()->job.recipe.sizeCorrection, 0.02);
  EXPECT_TRUE(label("paneCounts").contains(QStringLiteral("Pane 2 of 2: 1 good")));
}

TEST_F(MachineWindow, SaysInWordsWhyNothingIsLoadedInAnInterruption) {
  getReady();
  getOntoGlass();
  tap("feedHold");
  ASSERT_TRUE(becomes(JobState::Interrupted));
  EXPECT_FALSE(button("loadJob")->isEnabled());
  EXPECT_TRUE(label("revision").contains(QStringLiteral("resume it, or stop it, before a job is loaded")));
}

TEST_F(MachineWindow, ShowsTheWayToTheEndOfTheLineAndTheProgrammedSpeed) {
  getReady();
  EXPECT_EQ(label("toGoX"), QStringLiteral("–"));
  getOntoGlass();
  tap("feedHold");
  ASSERT_TRUE(becomes(State::Held));
  QTest::qWait(20);
  const control::Report& report = m_window.machine().report();
  const motion::Segment& on = m_window.machine().loaded()->job.track[static_cast<std::size_t>(report.place.segment)];
  const Eigen::Vector3d end = motion::evaluate(on, motion::parameterLength(on)).point;
  EXPECT_NEAR(QLocale().toDouble(label("toGoX")), end.x() - report.measured.x(), 0.001);
  EXPECT_NEAR(QLocale().toDouble(label("toGoY")), end.y() - report.measured.y(), 0.001);
  EXPECT_TRUE(label("speed").contains(QStringLiteral("of 360 mm/min"))); // at 10 %
}

// The pages are made anew whenever language, units or appearance change.
TEST_F(MachineWindow, ShowsThePresentStateOnAPageThatIsMadeAnew) {
  getReady();
  tap("panesMore");
  tap("pageSetup");
  tap("jogStep2");
  tap("showByHand");
  getOntoGlass();
  tap("feedHold");
  ASSERT_TRUE(becomes(JobState::Interrupted));
  const RunPage run(m_window.planner(), m_window.machine());
  const auto labelOf = [](const QWidget& page, const char* name) {
    return page.findChild<QLabel*>(QString::fromLatin1(name))->text();
  };
  EXPECT_EQ(labelOf(run, "panesWanted"), QStringLiteral("2"));
  EXPECT_EQ(labelOf(run, "paneCounts"), label("paneCounts"));
  EXPECT_EQ(labelOf(run, "revision"), label("revision"));
  EXPECT_NE(labelOf(run, "placeX"), QStringLiteral("–"));
  EXPECT_TRUE(run.findChild<QPushButton*>(QStringLiteral("resume"))->isEnabled());
  const SetupPage setup(m_window.machine());
  EXPECT_TRUE(setup.findChild<QPushButton*>(QStringLiteral("jogStep2"))->isChecked());
  EXPECT_TRUE(setup.findChild<QPushButton*>(QStringLiteral("showByHand"))->isChecked());
}

TEST(JogEnable, ThatIsMissingIsAskedForOnTheSetupPage) {
  const test::Scratch scratch;
  MachineSetup setup = test::fastMachine(scratch);
  setup.machine.jogEnableRequired = true;
  MachineLink machine(setup);
  SetupPage page(machine);
  const auto hint = [&] { return page.findChild<QLabel*>(QStringLiteral("jogHint"))->text(); };
  auto* jog = page.findChild<QPushButton*>(QStringLiteral("jogXPlus"));
  machine.enable();
  ASSERT_TRUE(QTest::qWaitFor([&] { return machine.allowed().home; }, test::kPatience));
  EXPECT_FALSE(jog->isEnabled());
  EXPECT_TRUE(hint().contains(QStringLiteral("jog enable on the panel")));
  page.findChild<QPushButton*>(QStringLiteral("simulateJogEnable"))->click();
  EXPECT_TRUE(QTest::qWaitFor([&] { return jog->isEnabled(); }, test::kPatience));
  EXPECT_FALSE(hint().contains(QStringLiteral("jog enable")));
}

/// One window after the other on one state folder, with a drawing from the disk.
TEST(ResumedWindow, TakesUpTheJobThatTheWindowBeforeLeftInTheMiddle) {
  const test::Scratch scratch;
  const MachineSetup setup = setupOf(scratch, control::Pace::Simulated);
  const auto tap = [](MainWindow& window, const char* name) {
    auto* button = window.findChild<QPushButton*>(QString::fromLatin1(name));
    ASSERT_TRUE(QTest::qWaitFor([&] { return button->isEnabled() && button->isVisible(); }, test::kPatience)) << name;
    QTest::mouseClick(button, Qt::LeftButton);
  };
  const auto start = [&](MainWindow& window) {
    tap(window, "pageSetup");
    tap(window, "enable");
    tap(window, "home");
    tap(window, "pageRun");
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.machine().allowed().start; }, test::kPatience));
    window.machine().start();
  };
  double ground = 0;
  {
    MainWindow first(setup);
    first.resize(1024, 700);
    first.show();
    first.openPattern(ARRIS_SOURCE_DIR "/resources/samples/triangle.dxf");
    tap(first, "pageRun");
    tap(first, "loadJob");
    start(first);
    ASSERT_TRUE(QTest::qWaitFor([&] { return first.machine().progress() > 0.3; }, test::kPatience));
    ground = first.machine().progress();
    ASSERT_LT(ground, 0.95);
  }
  MainWindow second(setup);
  second.resize(1024, 700);
  second.show();
  tap(second, "pageRun");
  auto* text = second.findChild<QLabel*>(QStringLiteral("resumeText"));
  EXPECT_TRUE(text->text().contains(QStringLiteral("triangle.dxf, pane 1 of 1, interrupted by a stop")))
      << text->text().toStdString();
  test::keep("run-resume-offer", second);
  tap(second, "resumeDiscard");
  EXPECT_TRUE(text->text().contains(QStringLiteral("cannot be resumed then")));
  tap(second, "resumeKeep");
  tap(second, "resumeTakeUp");
  ASSERT_TRUE(QTest::qWaitFor([&] { return second.machine().loaded() != nullptr; }, test::kPatience));
  EXPECT_FALSE(second.findChild<QWidget*>(QStringLiteral("resumeBar"))->isVisible());
  ASSERT_TRUE(QTest::qWaitFor([&] { return second.planner().plan() && !second.planner().isBusy(); }, test::kPatience));
  EXPECT_FALSE(second.machine().isRevision(*second.planner().plan()));
  double least = 1;
  QObject::connect(&second.machine(), &MachineLink::reported, &second,
                   [&] { least = std::min(least, second.machine().progress()); });
  start(second);
  ASSERT_TRUE(QTest::qWaitFor([&] { return second.machine().jobState() == JobState::Ended; }, test::kPatience));
  EXPECT_GE(least, ground);
}

/// What ends a jog although the finger still lies on the button.
class Jog : public MachineWindow, public testing::WithParamInterface<const char*> {
protected:
  Jog() : MachineWindow(control::Pace::Real) {}
};

TEST_P(Jog, EndsWhenTheHandIsElsewhere) {
  const std::string what = GetParam();
  tap("pageSetup");
  tap("enable");
  QPushButton* jog = button("jogXPlus");
  ASSERT_TRUE(QTest::qWaitFor([&] { return jog->isEnabled(); }, test::kPatience));
  QTest::mousePress(jog, Qt::LeftButton);
  ASSERT_TRUE(becomes(State::Jogging));
  QTest::qWait(600); // it goes on as long as the button is pressed
  ASSERT_EQ(m_window.machine().report().state, State::Jogging);
  m_seen.clear();
  QMessageBox dialog;
  if (what == "release") {
    QTest::mouseRelease(jog, Qt::LeftButton);
  } else if (what == "focus loss") {
    m_window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&m_window));
    button("pageRun")->setFocus();
  } else if (what == "page change") {
    button("pageJob")->click();
  } else if (what == "dialog") {
    dialog.open();
  } else if (what == "screen lock") {
    button("lockScreen")->click();
  } else {
    QEvent ended(what == "touch cancel" ? QEvent::TouchCancel : QEvent::WindowDeactivate);
    QApplication::sendEvent(jog, &ended);
  }
  EXPECT_TRUE(becomes(State::NotHomed)) << what;
  const Eigen::Vector3d at = m_window.machine().report().commanded;
  QTest::qWait(400);
  EXPECT_EQ(m_window.machine().report().commanded, at);
}

INSTANTIATE_TEST_SUITE_P(Ends, Jog,
                         testing::Values("release", "focus loss", "page change", "dialog", "screen lock",
                                         "touch cancel", "deactivation"));

TEST_F(MachineWindow, AsksBeforeItClosesWhileTheMachineMovesAndStopsItFirst) {
  getReady();
  getOntoGlass();
  m_window.close();
  ASSERT_TRUE(m_window.isVisible());
  auto* question = m_window.findChild<QMessageBox*>();
  ASSERT_TRUE(question != nullptr);
  EXPECT_TRUE(button("feedHold")->isEnabled());
  EXPECT_FALSE(question->isModal());
  question->buttons().front()->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !m_window.isVisible(); }, test::kPatience));
  EXPECT_FALSE(control::isMoving(m_window.machine().report().state));
}

class LongWordedMachineWindow : public test::LongTexts, public MachineWindow {
protected:
  LongWordedMachineWindow()
      : LongTexts({"arris::ui::SetupPage", "arris::ui::ByHandPanel", "arris::ui::RunPage", "arris::ui::OrderPanel",
                   "arris::ui::ResumeBar", "Services", "SimulatedFault"}) {}

  void expectShown(const char* name) {
    for (int i = 0; i < 5; ++i) { // layouts settle in turns
      QTest::qWait(1);
    }
    EXPECT_EQ(m_window.size(), QSize(1024, 700)) << name;
    test::expectNothingCutOff(m_window);
    keep(name);
  }
};

TEST_F(LongWordedMachineWindow, HasRoomForTextsThatAreFortyPercentLonger) {
  for (const char* part : {"showByHand", "showSimulation", "showMoving"}) {
    tap("pageSetup");
    tap(part);
    expectShown((std::string("long-") + part).c_str());
  }
  getReady();
  expectShown("long-run-loaded");
  getOntoGlass();
  tap("correctionUp");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !m_window.planner().isBusy(); }, test::kPatience));
  expectShown("long-run-running");
  tap("feedHold");
  ASSERT_TRUE(becomes(JobState::Interrupted));
  expectShown("long-run-interrupted");
  tap("stop");
  ASSERT_TRUE(becomes(JobState::Aborted));
  expectShown("long-run-aborted");
  tap("pageSetup");
  tap("showByHand");
  expectShown("long-setup-aborted");
}

class TranslatedMachineWindow : public testing::WithParamInterface<std::string>,
                                public test::Language,
                                public MachineWindow {
protected:
  TranslatedMachineWindow() : Language(GetParam()) {}

  void expectShown(const std::string& name) {
    for (int i = 0; i < 5; ++i) { // layouts settle in turns
      QTest::qWait(1);
    }
    EXPECT_EQ(m_window.size(), QSize(1024, 700));
    test::expectNothingCutOff(m_window);
    keep(name + "-" + GetParam());
  }
};

TEST_P(TranslatedMachineWindow, ShowsEverythingOnTheSmallestScreen) {
  for (const char* page : {"showByHand", "showSimulation", "showMoving", "pageRun", "pageProfiles"}) {
    tap("pageSetup");
    tap(page);
    expectShown(std::string(page) + "-empty");
  }
  getReady();
  expectShown("run-loaded");
  getOntoGlass();
  expectShown("run-running");
  tap("feedHold");
  ASSERT_TRUE(becomes(State::Held));
  expectShown("run-held");
  tap("pageSetup");
  m_window.machine().inject(control::SimulatedFault::VacuumLoss);
  m_window.machine().resume();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !m_window.machine().alarms().empty(); }, test::kPatience));
  ASSERT_TRUE(becomes(State::Faulted));
  expectShown("setup-fault");
  tap("pageRun");
  expectShown("run-fault");
}

TEST_P(TranslatedMachineWindow, ShowsOrderOriginAndRevisionOnTheSmallestScreen) {
  getReady();
  tap("correctionUp");
  tap("loadJob");
  tap("pageSetup");
  tap("showByHand");
  tap("coolantOn");
  expectShown("setup-by-hand");
  tap("showMoving");
  tap("jogStep2");
  expectShown("setup-jog-by-steps");
  tap("pageRun");
  tap("panesMore");
  holdDown("cycleStart");
  ASSERT_TRUE(becomes(JobState::Ended));
  ASSERT_TRUE(QTest::qWaitFor([&] { return button("paneGood")->isEnabled(); }, test::kPatience));
  expectShown("run-ended");
  tap("correctionUp");
  ASSERT_TRUE(QTest::qWaitFor([&] { return button("loadJob")->isEnabled(); }, test::kPatience));
  expectShown("run-revision");
}

TEST_P(TranslatedMachineWindow, HasRoomForEveryAlarm) {
  tap("pageRun");
  auto* text = m_window.findChild<QLabel*>(QStringLiteral("alarmText"));
  for (const control::FaultInfo& row : control::allFaults()) {
    text->setText(faultText({0, row.fault, 1, 123.456}, QLocale()) + QLatin1Char('\n') + remedyText(row.fault));
    EXPECT_LE(text->heightForWidth(text->width()), text->height()) << GetParam() << ": " << row.name;
  }
}

std::vector<std::string> everyLanguage() {
  std::vector<std::string> names = test::languages();
  names.emplace_back("en");
  return names;
}

INSTANTIATE_TEST_SUITE_P(Languages, TranslatedMachineWindow, testing::ValuesIn(everyLanguage()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace arris::ui
