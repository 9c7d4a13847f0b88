// Every page in every language from the smallest window to the largest screen: nothing is cut off. Kept to be looked
// at.

#include "tests/ui/support/artefacts.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/locales.h"
#include "tests/ui/support/page_parts.h"
#include "ui/widgets/control_strip.h"

#include <QAbstractButton>
#include <QTest>

namespace arris::ui {
namespace {

using control::JobState;
using control::State;
using test::kPageParts;
using test::PagePart;

constexpr QSize kScreens[] = {{1024, 700}, {1024, 768}, {1920, 1080}, {3840, 2160}};

class WindowOfEverySize : public testing::WithParamInterface<std::string>,
                          public test::Language,
                          public test::DrivenWindow {
protected:
  WindowOfEverySize() : Language(GetParam()) {}

  void expectShown(const PagePart& part, const std::string& state) {
    tap(part.page);
    if (part.part != nullptr) {
      QTest::mouseClick(find<QAbstractButton>(part.part), Qt::LeftButton);
    }
    settle();
    const std::string name = std::string(part.page) + '-' + (part.part != nullptr ? part.part : "all") + '-' + state;
    const testing::ScopedTrace trace(__FILE__, __LINE__, name);
    const QSize size = m_window.size();
    test::expectNothingCutOff(m_window);
    expectWithin(m_window.centralWidget()->size());
    EXPECT_EQ(m_window.size(), size);
    if (size == kScreens[3] && GetParam() == "en") {
      test::keep("size-4k-" + name, m_window);
    }
  }

  // Every button that is shown lies in the window, none on another.
  void expectWithin(const QSize& room) {
    QList<QRect> places;
    for (const QAbstractButton* button : m_window.findChildren<QAbstractButton*>()) {
      const bool isOfALine = button->parentWidget()->inherits("QLineEdit");
      if (button->isVisible() && !isOfALine && !button->visibleRegion().isEmpty()) {
        const QRect place(button->mapTo(m_window.centralWidget(), QPoint()), button->size());
        const bool isScrolled = button->visibleRegion().boundingRect() != button->rect();
        EXPECT_TRUE(isScrolled || QRect(QPoint(), room).contains(place)) << button->text().toStdString();
        for (const QRect& other : places) {
          EXPECT_FALSE(other.intersects(place)) << button->text().toStdString();
        }
        places.push_back(place);
      }
    }
  }

  // What holds the window high.
  std::string highest() {
    std::string names;
    for (const QWidget* part : m_window.findChildren<QWidget*>()) {
      if (part->property("page").isValid() || part->parentWidget() == m_window.centralWidget()) {
        names += part->property("page").toString().toStdString() + part->metaObject()->className() + ' ' +
                 std::to_string(part->minimumSizeHint().height()) + ", ";
      }
    }
    return names;
  }

  void expectEveryPageShown(const std::string& state) {
    for (const QSize& screen : kScreens) {
      for (int turn = 0; turn < 2; ++turn) { // what is side by side holds the window wide until it stands below
        m_window.resize(screen);
        settle();
      }
      ASSERT_EQ(m_window.size(), screen) << state << ": the highest is " << highest();
      for (const PagePart& part : kPageParts) {
        expectShown(part, state);
      }
      tap("pageRun");
    }
  }
};

TEST_P(WindowOfEverySize, ShowsEveryPageOfALoadedPattern) {
  m_window.openPattern("splashback.dxf"); // with problems to tell
  settle();
  expectEveryPageShown("pattern");
}

TEST_P(WindowOfEverySize, ShowsEveryPageWhileAJobIsHeldAndAfterAFault) {
  getReady();
  getOntoGlass();
  tap("feedHold");
  ASSERT_TRUE(becomes(State::Held));
  expectEveryPageShown("held");
  m_window.machine().inject(control::SimulatedFault::CoolantLoss);
  m_window.machine().resume();
  ASSERT_TRUE(becomes(State::Faulted));
  expectEveryPageShown("fault");
}

// The pages get the room of a large screen; the strip stays as wide as a hand needs it.
TEST_P(WindowOfEverySize, GivesTheRoomOfALargeScreenToThePages) {
  for (const QSize& screen : kScreens) {
    m_window.resize(screen);
    settle();
    const auto* strip = m_window.findChild<ControlStrip*>();
    EXPECT_EQ(strip->width(), ControlStrip::kWidth);
    EXPECT_EQ(strip->mapTo(&m_window, QPoint(strip->width(), strip->height())),
              QPoint(screen.width(), screen.height()));
  }
}

std::vector<std::string> languagesOfSizes() {
  std::vector<std::string> names = test::languages();
  names.emplace_back("en");
  return names;
}

INSTANTIATE_TEST_SUITE_P(Languages, WindowOfEverySize, testing::ValuesIn(languagesOfSizes()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace arris::ui
