// FEED HOLD and STOP while the wheel moves: from every page, beside everything that may be open, and under the lock of
// the screen. The emergency stop is a button of the machine, never one of the screen.

#include "core/files/whole_file.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/locales.h"
#include "ui/widgets/keypad.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QLineEdit>
#include <QTest>
#include <QWindow>

#include <algorithm>

namespace arris::ui {
namespace {

using control::JobState;
using control::State;

/// While a pane is ground slowly.
class Stops : public test::DrivenWindow {
protected:
  void startAnew() {
    tap("pageRun");
    getOntoGlass();
  }

  // The way that a real press takes: through the window, past whatever lies over it.
  void press(const char* name) {
    ASSERT_TRUE(QTest::qWaitFor([&] { return button(name)->isEnabled(); }, test::kPatience)) << name;
    ASSERT_TRUE(button(name)->isVisible()) << name;
    ASSERT_EQ(QApplication::activeModalWidget(), nullptr) << name;
    m_seen.clear();
    touch(name);
  }

  void touch(const char* name) {
    QTest::mouseClick(m_window.windowHandle(), Qt::LeftButton, {},
                      button(name)->mapTo(&m_window, button(name)->rect().center()));
  }

  // Where keys go to: to what is open, or else to the window.
  void strike(Qt::Key key) {
    m_seen.clear();
    QWidget* popup = QApplication::activePopupWidget();
    QWidget* focus = QApplication::focusWidget();
    QTest::keyClick((popup != nullptr ? popup : focus != nullptr ? focus->window() : &m_window)->windowHandle(), key);
  }

  void resumeSoon() {
    m_seen.clear();
    m_window.machine().resume();
    ASSERT_TRUE(becomes(State::Running));
  }

  // `open` brings up what stands in the way, each time.
  template <typename Open> void expectStops(const Open& open) {
    getReady();
    startAnew();
    open();
    press("feedHold");
    EXPECT_TRUE(becomes(State::Held));
    EXPECT_TRUE(becomes(JobState::Interrupted));
    resumeSoon();
    open();
    strike(Qt::Key_F11);
    EXPECT_TRUE(becomes(State::Held));
    resumeSoon();
    open();
    press("stop");
    EXPECT_TRUE(becomes(JobState::Aborted));
    clear();
    startAnew();
    open();
    strike(Qt::Key_F12);
    EXPECT_TRUE(becomes(JobState::Aborted));
    EXPECT_FALSE(control::isMoving(m_window.machine().report().state));
    clear();
  }

  // As a person clears the window before going on.
  void clear() {
    for (QDialog* dialog : m_window.findChildren<QDialog*>()) {
      dialog->close();
    }
    delete m_window.findChild<Keypad*>();
    QTest::qWait(1);
  }
};

class StopsFromPage : public Stops, public testing::WithParamInterface<const char*> {};

TEST_P(StopsFromPage, HoldAndStopTheJob) {
  expectStops([this] { tap(GetParam()); });
}

INSTANTIATE_TEST_SUITE_P(Pages, StopsFromPage, testing::ValuesIn(test::kPages),
                         [](const auto& row) { return std::string(row.param); });

class StopsBeside : public Stops, public testing::WithParamInterface<const char*> {
protected:
  // A tap and the dialog that it opens.
  void ask(const char* page, const char* opens) {
    tap(page);
    auto* opener = find<QAbstractButton>(opens);
    ASSERT_TRUE(opener != nullptr && opener->isEnabled()) << opens;
    QTest::mouseClick(opener, Qt::LeftButton);
    expectDialog();
  }

  void expectDialog() {
    const auto dialogs = m_window.findChildren<QDialog*>();
    const auto shown =
        std::find_if(dialogs.begin(), dialogs.end(), [](const QDialog* one) { return one->isVisible(); });
    ASSERT_NE(shown, dialogs.end());
    EXPECT_FALSE((*shown)->isModal());
    (*shown)->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(*shown));
  }

  void openWhatIsTested() {
    const std::string what = GetParam();
    if (what == "patternDialog") {
      ask("pageJob", "open");
    } else if (what == "recipeDialog") {
      ask("pageJob", "recipes");
    } else if (what == "fileOfProfile") {
      ask("pageProfiles", "profilesOpen");
    } else if (what == "fileToSave") {
      ask("pageProfiles", "profilesSave");
    } else if (what == "closeQuestion") {
      m_window.close();
      expectDialog();
    } else if (what == "keypad") {
      tap("pageJob");
      setKeypadOpens(KeypadOpens::OnEveryTap);
      QTest::mouseClick(find<QLineEdit>("depth_mm"), Qt::LeftButton);
      setKeypadOpens(KeypadOpens::OnTouch);
      ASSERT_TRUE(m_window.findChild<Keypad*>() != nullptr);
    } else if (what == "openList") {
      tap("pageSettings");
      find<QComboBox>("language")->showPopup();
      ASSERT_TRUE(QApplication::activePopupWidget() != nullptr);
    }
  }
};

TEST_P(StopsBeside, HoldAndStopTheJob) {
  expectStops([this] { openWhatIsTested(); });
}

INSTANTIATE_TEST_SUITE_P(Dialogs, StopsBeside,
                         testing::Values("patternDialog", "recipeDialog", "fileOfProfile", "fileToSave",
                                         "closeQuestion", "keypad", "openList"),
                         [](const auto& row) { return std::string(row.param); });

TEST_F(Stops, HoldAndStopTheJobUnderTheLockOfTheScreen) {
  getReady();
  getOntoGlass();
  tap("lockScreen");
  press("feedHold");
  EXPECT_TRUE(becomes(State::Held));
  resumeSoon();
  strike(Qt::Key_F11);
  EXPECT_TRUE(becomes(State::Held));
  touch("resume"); // under the cover: wiping does not start anything
  QTest::qWait(100);
  EXPECT_EQ(m_window.machine().jobState(), JobState::Interrupted);
  resumeSoon();
  strike(Qt::Key_F12);
  EXPECT_TRUE(becomes(JobState::Aborted));
}

TEST_F(Stops, StandInSightOfEveryPageAtTheSamePlace) {
  getReady();
  getOntoGlass();
  const QRect hold = button("feedHold")->geometry();
  const QRect stop = button("stop")->geometry();
  for (const char* page : test::kPages) {
    tap(page);
    settle();
    EXPECT_TRUE(button("feedHold")->isVisible() && button("feedHold")->isEnabled()) << page;
    EXPECT_TRUE(button("stop")->isVisible() && button("stop")->isEnabled()) << page;
    EXPECT_EQ(button("feedHold")->geometry(), hold) << page;
    EXPECT_EQ(button("stop")->geometry(), stop) << page;
  }
}

class EmergencyStop : public testing::WithParamInterface<std::string>,
                      public test::Language,
                      public test::DrivenWindow {
protected:
  EmergencyStop() : Language(GetParam()) {}

  // As it is called in the languages of the window.
  static bool meansEmergencyStop(const QString& text) {
    static const QStringList kWords{"emergency", "e-stop", "estop",     "not-halt", "nothalt",
                                    "not-aus",   "notaus", "emergenza", "急停",     "紧急停止"};
    return std::any_of(kWords.begin(), kWords.end(),
                       [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
  }
};

// What trips the one of the simulated machine, to learn with, stands apart and says so.
TEST_P(EmergencyStop, IsNoButtonOfTheScreen) {
  int simulated = 0;
  for (const QAbstractButton* any : m_window.findChildren<QAbstractButton*>()) {
    if (any->parentWidget()->objectName() == QStringLiteral("simulation")) {
      simulated += meansEmergencyStop(any->text()) ? 1 : 0;
    } else {
      for (const QString& text : {any->text(), any->objectName(), any->accessibleName(), any->toolTip()}) {
        EXPECT_FALSE(meansEmergencyStop(text)) << text.toStdString();
      }
    }
  }
  EXPECT_EQ(simulated, 1) << "the words are not those of this language";
}

std::vector<std::string> languagesOfStops() {
  std::vector<std::string> names = test::languages();
  names.emplace_back("en");
  return names;
}

INSTANTIATE_TEST_SUITE_P(Languages, EmergencyStop, testing::ValuesIn(languagesOfStops()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace arris::ui
