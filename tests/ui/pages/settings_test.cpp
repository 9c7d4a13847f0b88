// The settings and what lies over every page: language, units and appearance while running, keypad, lock of the screen.

#include "tests/ui/support/artefacts.h"
#include "tests/ui/support/locales.h"
#include "tests/ui/support/steps.h"
#include "ui/figures/style.h"
#include "ui/main_window.h"
#include "ui/pages/pattern_dialog.h"
#include "ui/run_window.h"
#include "ui/text/translators.h"
#include "ui/widgets/keypad.h"
#include "ui/widgets/theme.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

#include <gtest/gtest.h>

#include <fstream>

namespace arris::ui {
namespace {

class SettingsWindow : public testing::Test {
protected:
  SettingsWindow() : m_window(test::fastMachine(m_scratch), test::paneSteps()) {
    m_window.resize(1024, 700);
    m_window.show();
  }

  void TearDown() override { // what counts for the whole process
    speak(QStringLiteral("en"));
    QLocale::setDefault(test::kEnglish);
    showLengthsIn(LengthUnit::Millimetre);
    showAppearance(Appearance::Light);
    setKeypadOpens(KeypadOpens::OnTouch);
    applyTheme(*qApp);
  }

  template <typename Widget = QPushButton> Widget* find(const char* name) {
    return m_window.findChild<Widget*>(QString::fromLatin1(name));
  }

  void tap(const char* name) {
    ASSERT_TRUE(find(name) != nullptr) << name;
    ASSERT_TRUE(find(name)->isEnabled()) << name;
    QTest::mouseClick(find(name), Qt::LeftButton);
    QTest::qWait(1); // what is built anew is built by then
  }

  void choose(const char* language) {
    auto* box = find<QComboBox>("language");
    box->setCurrentIndex(box->findData(QString::fromLatin1(language)));
    Q_EMIT box->activated(box->currentIndex());
    QTest::qWait(1);
  }

  void openTriangle() {
    m_window.openPattern("triangle.dxf");
    ASSERT_TRUE(QTest::qWaitFor([&] { return m_window.planner().curves() != nullptr; }, test::kPatience));
  }

  test::Scratch m_scratch;
  MainWindow m_window;
};

TEST_F(SettingsWindow, SpeaksAnotherLanguageAtOnceAndKeepsJobAndMachine) {
  openTriangle();
  m_window.machine().enable();
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_window.machine().allowed().home; }, test::kPatience));
  tap("pageSettings");
  choose("de");
  EXPECT_EQ(find("pageJob")->text(), QStringLiteral("Auftrag"));
  EXPECT_TRUE(find("pageSettings")->isChecked()); // the page stays
  EXPECT_TRUE(m_window.machine().allowed().home);
  EXPECT_EQ(find<QLineEdit>("depth_mm")->text(), QStringLiteral("0,13"));
  tap("pageJob");
  EXPECT_TRUE(find<QLabel>("state")->text().contains(QStringLiteral("Schleifen")));
  choose("en");
  EXPECT_EQ(find("pageJob")->text(), QStringLiteral("Job"));
  EXPECT_EQ(find<QLineEdit>("depth_mm")->text(), QStringLiteral("0.13"));
}

TEST_F(SettingsWindow, ShowsAndTakesInchesWithoutChangingTheRecipe) {
  openTriangle();
  const recipe::Recipe before = m_window.planner().recipe();
  tap("pageSettings");
  tap("unitInch");
  EXPECT_EQ(m_window.planner().recipe(), before);
  EXPECT_EQ(find<QLineEdit>("wheel_radius_mm")->text(), QStringLiteral("2.952756")); // 75 / 25.4
  find<QLineEdit>("wheel_radius_mm")->setText(QStringLiteral("3"));
  EXPECT_DOUBLE_EQ(m_window.planner().recipe().wheelRadius, 76.2);
  EXPECT_EQ(find<QLineEdit>("spindle_r_min")->text(), QStringLiteral("6000"));
  tap("unitMillimetre");
  EXPECT_EQ(find<QLineEdit>("wheel_radius_mm")->text(), QStringLiteral("76.2"));
}

TEST_F(SettingsWindow, IsDarkAtOnce) {
  openTriangle();
  tap("pageSettings");
  tap("appearanceDark");
  EXPECT_LT(m_window.palette().color(QPalette::Window).lightness(), 80);
  for (const char* page : {"pageJob", "pageSetup", "pageRun", "pageProfiles", "pageSettings"}) {
    tap(page);
    QTest::qWait(20);
    test::keep(std::string("dark-") + page, m_window);
  }
  EXPECT_LT(m_window.grab().toImage().pixelColor(300, 690).lightness(), 80);
  tap("appearanceLight");
  EXPECT_GT(m_window.palette().color(QPalette::Window).lightness(), 200);
}

TEST_F(SettingsWindow, LocksTheMachineBehindTheCode) {
  tap("pageSettings");
  tap("settingsMachine");
  QTest::qWait(5);
  test::keep("settings-machine", m_window);
  auto* travel = find<QLineEdit>("travel_mmX");
  EXPECT_TRUE(travel->isEnabled());
  travel->setText(QStringLiteral("3000"));
  EXPECT_EQ(m_window.preferences().nextMachine().travel.x(), 3000);
  travel->setText(QStringLiteral("-1"));
  EXPECT_EQ(m_window.preferences().nextMachine().travel.x(), 3000);
  EXPECT_TRUE(m_window.findChildren<QLabel*>(QStringLiteral("complaint")).back()->text().contains("out of range"));
  travel->setText(QStringLiteral("3000"));
  tap("settingsCode");
  EXPECT_FALSE(find<QPushButton>("codeSet")->isEnabled()); // nothing is typed
  find<QLineEdit>("code")->setText(QStringLiteral("4711"));
  tap("codeSet");
  tap("codeLock");
  test::keep("settings-code", m_window);
  EXPECT_FALSE(travel->isEnabled());
  EXPECT_FALSE(find<QLineEdit>("accel_x_mm_s2")->isEnabled());
  EXPECT_TRUE(find<QLineEdit>("depth_mm")->isEnabled());
  find<QLineEdit>("code")->setText(QStringLiteral("1111"));
  tap("codeOpen");
  EXPECT_FALSE(travel->isEnabled());
  find<QLineEdit>("code")->setText(QStringLiteral("4711"));
  tap("codeOpen");
  EXPECT_TRUE(travel->isEnabled());
}

TEST_F(SettingsWindow, BringsUpTheKeypadWhichTakesANumberOrSaysWhyNot) {
  auto* line = find<QLineEdit>("thickness_mm");
  QTest::mouseClick(line, Qt::LeftButton);
  EXPECT_TRUE(find<Keypad>("keypad") == nullptr); // a mouse has its keyboard beside it
  tap("pageSettings");
  tap("keypadAlways");
  tap("pageJob");
  line = find<QLineEdit>("thickness_mm");
  QTest::mouseClick(line, Qt::LeftButton);
  ASSERT_TRUE(find<Keypad>("keypad") != nullptr);
  EXPECT_TRUE(find<QLabel>("keypadRange")->text().contains("from 1 to 100"));
  EXPECT_FALSE(find<QPushButton>("keySign")->isEnabled()); // there is no glass of −12 mm
  for (const char* key : {"key1", "key9", "key0"}) {
    tap(key);
  }
  tap("keyOk");
  ASSERT_TRUE(find<Keypad>("keypad") != nullptr); // 190 is too thick
  EXPECT_TRUE(find<QLabel>("keypadComplaint")->text().contains("out of range"));
  QTest::qWait(5);
  test::keep("keypad", m_window);
  EXPECT_EQ(m_window.planner().recipe().thickness, 12);
  for (const char* key : {"keyBack", "keyBack", "key9", "keyPoint", "key5", "keyOk"}) {
    tap(key);
  }
  QTest::qWait(1);
  EXPECT_TRUE(find<Keypad>("keypad") == nullptr);
  EXPECT_EQ(m_window.planner().recipe().thickness, 19.5);
}

TEST_F(SettingsWindow, LeavesTheStripFreeOfTheKeypad) {
  setKeypadOpens(KeypadOpens::OnEveryTap);
  for (auto* line : m_window.findChildren<QLineEdit*>()) {
    if (line->isVisible()) {
      QTest::mouseClick(line, Qt::LeftButton);
      const auto* keypad = find<Keypad>("keypad");
      ASSERT_TRUE(keypad != nullptr) << line->objectName().toStdString();
      for (const char* name : {"stop", "feedHold"}) {
        const QRect button(find(name)->mapTo(&m_window, QPoint()), find(name)->size());
        EXPECT_FALSE(keypad->geometry().intersects(button));
      }
      EXPECT_TRUE(m_window.rect().contains(keypad->geometry()));
    }
  }
}

TEST_F(SettingsWindow, LocksTheScreenForWipingButNotTheStops) {
  openTriangle();
  m_window.machine().enable();
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_window.machine().allowed().home; }, test::kPatience));
  tap("lockScreen");
  QTest::qWait(5);
  test::keep("locked", m_window);
  EXPECT_FALSE(find("pageRun")->isEnabled());
  EXPECT_FALSE(find("home")->isEnabled());
  QTest::keyClick(&m_window, Qt::Key_F4);
  EXPECT_TRUE(find("pageJob")->isChecked());
  m_window.machine().home();
  ASSERT_TRUE(QTest::qWaitFor([&] { return find("stop")->isEnabled(); }, test::kPatience));
  QTest::mouseClick(find("stop"), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !control::isMoving(m_window.machine().report().state); }, test::kPatience));
  EXPECT_FALSE(m_window.machine().report().homed);
}

TEST_F(SettingsWindow, AsksForAFileWithoutKeepingAnybodyFromStop) {
  openTriangle();
  m_window.machine().enable();
  ASSERT_TRUE(QTest::qWaitFor([&] { return m_window.machine().allowed().home; }, test::kPatience));
  tap("open");
  auto* dialog = m_window.findChild<PatternDialog*>();
  ASSERT_TRUE(dialog != nullptr && dialog->isVisible());
  m_window.machine().home();
  ASSERT_TRUE(QTest::qWaitFor([&] { return find("stop")->isEnabled(); }, test::kPatience));
  dialog->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(dialog));
  QTest::keyClick(dialog, Qt::Key_F12);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !control::isMoving(m_window.machine().report().state); }, test::kPatience));
  EXPECT_FALSE(m_window.machine().report().homed);
}

TEST_F(SettingsWindow, KeepsOnTheJobPageWhatAnotherPageHasChanged) {
  openTriangle();
  auto* depth = find<QLineEdit>("depth_mm");
  depth->setText(QStringLiteral("nothing"));
  tap("pageRun");
  tap("correctionUp");
  EXPECT_EQ(find<QLineEdit>("size_correction_mm")->text(), QStringLiteral("0.01"));
  EXPECT_EQ(depth->text(), QStringLiteral("nothing")); // still to be mended
  find<QLineEdit>("feed_mm_min")->setText(QStringLiteral("3000"));
  EXPECT_DOUBLE_EQ(m_window.planner().recipe().sizeCorrection, 0.01);
  EXPECT_EQ(m_window.planner().recipe().feed, 3000);
}

TEST_F(SettingsWindow, IsScaledFromTheNextStart) {
  const files::StateFolder folder{m_scratch / "state"};
  EXPECT_EQ(scaleFactor(folder), "");
  files::Settings settings = m_window.preferences().settings();
  settings.scale = 150;
  m_window.preferences().change(settings);
  EXPECT_EQ(scaleFactor(folder), "1.5");
  std::ofstream(folder.settings()) << "{";
  EXPECT_EQ(scaleFactor(folder), "");
}

TEST_F(SettingsWindow, IsAsSmallAgainAsItWasAfterItWasLarge) {
  openTriangle();
  m_window.resize(1920, 1080);
  QTest::qWait(20);
  m_window.resize(1024, 700);
  QTest::qWait(20);
  EXPECT_EQ(m_window.size(), QSize(1024, 700));
  EXPECT_EQ(m_window.centralWidget()->width(), 1024);
}

TEST_F(SettingsWindow, GoesToEveryPageAndToItsHelpByKeys) {
  m_window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&m_window));
  int key = Qt::Key_F2;
  for (const char* page : {"pageJob", "pageSetup", "pageRun", "pageProfiles"}) {
    QTest::keyClick(&m_window, static_cast<Qt::Key>(key++));
    EXPECT_TRUE(find(page)->isChecked()) << page;
    QTest::keyClick(&m_window, Qt::Key_F1);
    EXPECT_TRUE(find("pageHelp")->isChecked());
  }
}

TEST_F(SettingsWindow, TellsADamagedFileAndStartsAllTheSame) {
  m_window.close();
  const test::Scratch other;
  std::filesystem::create_directories(other / "state");
  std::ofstream(other / "state" / "settings.json") << "{ \"arris_settings\": 1, \"appearance\": 7 }";
  MainWindow window(test::fastMachine(other), test::paneSteps());
  window.show();
  EXPECT_TRUE(window.findChild<QLabel*>(QStringLiteral("alarmText"))->text().contains("settings.json.damaged"));
}

} // namespace
} // namespace arris::ui
