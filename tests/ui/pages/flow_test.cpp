// The window is served whatever is read and planned, and what takes long can be ended. That nothing of it runs on the
// window's thread is looked at after every test (main.cpp).

#include "tests/support/corpus.h"
#include "tests/support/dxf_text.h"
#include "tests/ui/support/artefacts.h"
#include "tests/ui/support/long_texts.h"
#include "tests/ui/support/steps.h"
#include "ui/main_window.h"
#include "ui/pages/job_page.h"
#include "ui/views/drawing_view.h"
#include "ui/widgets/theme.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <fstream>
#include <memory>
#include <numbers>
#include <thread>

namespace arris::ui {
namespace {

constexpr int kChords = 100'000;
constexpr int kServedAtLeast = 5; // turns while one step is under way

/// A circle as a CAD system exports it.
std::filesystem::path choppedCircle(const test::Scratch& scratch, int chords) {
  std::vector<geometry::Point> corners;
  for (int i = 0; i < chords; ++i) {
    const double angle = 2 * std::numbers::pi * i / chords;
    corners.emplace_back(600 * std::cos(angle), 600 * std::sin(angle));
  }
  std::filesystem::path file = scratch / "circle.dxf";
  std::ofstream(file) << test::DxfText().insUnits(4).addGroups(test::polylineGroups(corners, true)).text();
  return file;
}

/// Of the drawings of the corpus the one that takes the most bytes.
std::optional<std::filesystem::path> largestOfCorpus() {
  const auto folder = test::corpusFolder();
  if (!folder) {
    return std::nullopt;
  }
  const auto files = test::drawingsIn(*folder);
  const auto bySize = [](const auto& a, const auto& b) {
    return std::filesystem::file_size(a) < std::filesystem::file_size(b);
  };
  return *std::max_element(files.begin(), files.end(), bySize);
}

/// The turns of the window's event loop, as a timer of 5 ms counts them.
using Ticks = std::shared_ptr<std::atomic<int>>;

/// Steps that each go on until the event loop has turned some more times since they began: on the window's thread they
/// would wait in vain.
PlannerSteps servedMeanwhile(const Ticks& ticks) {
  const auto awaitTicks = [ticks](int from) {
    for (int waited = 0; *ticks < from + kServedAtLeast && waited < test::kPatience; ++waited) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  };
  PlannerSteps steps = plannerSteps();
  steps.read = [ticks, awaitTicks, read = steps.read](const auto& file, const auto& options, const auto& monitor) {
    const int from = *ticks;
    auto import = read(file, options, monitor);
    awaitTicks(from);
    return import;
  };
  steps.plan = [ticks, awaitTicks, plan = steps.plan](const auto& pattern, const auto& recipe, const auto& machine,
                                                      const auto& monitor) {
    const int from = *ticks;
    job::Job job = plan(pattern, recipe, machine, monitor);
    awaitTicks(from);
    return job;
  };
  return steps;
}

class Flow : public testing::Test {
protected:
  explicit Flow(PlannerSteps steps = plannerSteps())
      : m_window(test::fastMachine(m_scratch), std::move(steps)), m_planned(&m_window.planner(), &Planner::planned),
        m_profiles(&m_window.planner(), &Planner::profileReady) {
    m_window.show();
  }

  Planner& planner() {
    return m_window.planner();
  }

  [[nodiscard]] bool becomesIdle() {
    return QTest::qWaitFor([this] { return !planner().isBusy(); }, test::kPatience);
  }

  template <typename T> T* find(const char* name) {
    return m_window.findChild<JobPage*>()->findChild<T*>(QString::fromLatin1(name));
  }

  test::Scratch m_scratch;
  MainWindow m_window;
  QSignalSpy m_planned;
  QSignalSpy m_profiles;
};

class ServedFlow : public Flow {
protected:
  explicit ServedFlow(const Ticks& ticks = std::make_shared<std::atomic<int>>(0))
      : Flow(servedMeanwhile(ticks)), m_ticks(ticks) {
    m_ticker.setInterval(5);
    QObject::connect(&m_ticker, &QTimer::timeout, &m_window, [ticks] { ++*ticks; });
    m_ticker.start();
  }

  void expectServedWhileOpening(const std::filesystem::path& file) {
    *m_ticks = 0;
    m_window.openPattern(file);
    EXPECT_EQ(m_planned.count(), 0);
    ASSERT_TRUE(QTest::qWaitFor([this] { return !m_planned.isEmpty(); }, 2 * test::kPatience));
    EXPECT_GE(*m_ticks, 2 * kServedAtLeast); // while it was read, and while it was planned
    ASSERT_TRUE(becomesIdle());
  }

  // A large drawing comes a moment later: on the window's thread its painting would be told as an offence.
  void expectPaintedBeside() {
    auto* view = m_window.findChild<JobPage*>()->findChild<DrawingView*>();
    const QColor glass = screenStyle(1).palette.glass;
    const auto shown = [&] { return view->viewport()->grab().toImage().pixelColor(view->viewport()->rect().center()); };
    ASSERT_TRUE(QTest::qWaitFor([&] { return shown() == glass && view->isUpToDate(); }, test::kPatience));
  }

  Ticks m_ticks;
  QTimer m_ticker;
};

TEST_F(ServedFlow, GoesOnWhileTheLargestDrawingOfTheCorpusIsOpened) {
  const auto file = largestOfCorpus();
  if (!file) {
    GTEST_SKIP() << "ARRIS_PATTERN_CORPUS names no folder of drawings";
  }
  expectServedWhileOpening(*file);
}

TEST_F(ServedFlow, GoesOnWhileAHundredThousandChordsArePlanned) {
  recipe::Recipe recipe;
  recipe.smooth = 0; // each of them stays
  planner().setRecipe(recipe);
  expectServedWhileOpening(choppedCircle(m_scratch, kChords));
  EXPECT_GE(planner().plan()->job.track.size(), static_cast<std::size_t>(kChords));
  EXPECT_EQ(m_profiles.count(), 1);
  expectPaintedBeside();
  find<QAbstractButton>("zoomIn")->click();
  expectPaintedBeside();
}

/// At every stage of a long planning.
class Cancelling : public Flow, public testing::WithParamInterface<base::Stage> {};

TEST_P(Cancelling, EndsWhatIsUnderWay) {
  recipe::Recipe recipe;
  recipe.smooth = 0;
  planner().setRecipe(recipe);
  std::vector<base::Stage> begun;
  QObject::connect(&planner(), &Planner::progressed, &m_window, [&](base::Stage stage) {
    begun.push_back(stage);
    if (stage == GetParam()) {
      planner().cancel();
    }
  });
  m_window.openPattern(choppedCircle(m_scratch, kChords));
  ASSERT_TRUE(becomesIdle());
  EXPECT_TRUE(planner().isCancelled());
  QTest::qWait(300); // nothing comes afterwards
  EXPECT_EQ(begun.back(), GetParam());
  EXPECT_EQ(m_planned.count(), GetParam() == base::Stage::Profile ? 1 : 0);
  EXPECT_EQ(m_profiles.count(), 0);
  EXPECT_TRUE(find<QLabel>("state")->text().startsWith("Cancelled")) << find<QLabel>("state")->text().toStdString();
}

INSTANTIATE_TEST_SUITE_P(Flow, Cancelling,
                         testing::Values(base::Stage::Reading, base::Stage::Joining, base::Stage::WheelPath,
                                         base::Stage::Speeds, base::Stage::Profile),
                         [](const auto& stage) { return "Stage" + std::to_string(static_cast<int>(stage.param) + 1); });

/// A planning that goes on until it is given up.
class EndlessFlow : public Flow {
protected:
  EndlessFlow() : Flow(endless()) {}

  static PlannerSteps endless() {
    PlannerSteps steps = test::paneSteps();
    steps.plan = [plan = steps.plan](const auto& pattern, const auto& recipe, const auto& machine,
                                     const base::Monitor& monitor) {
      monitor.begin(base::Stage::WheelPath);
      while (recipe.feed < 1000 && !monitor.stop.stop_requested()) {
        std::this_thread::yield();
      }
      return plan(pattern, recipe, machine, monitor);
    };
    return steps;
  }

  void beginEndless() {
    recipe::Recipe slow = planner().recipe();
    slow.feed = 500;
    planner().setRecipe(slow);
    ASSERT_TRUE(QTest::qWaitFor([this] { return find<QPushButton>("cancelPlanning")->isVisible(); }, test::kPatience));
  }
};

TEST_F(EndlessFlow, SaysWhatIsUnderWayAndEndsItByABigButton) {
  m_window.openPattern("triangle.dxf");
  ASSERT_TRUE(becomesIdle());
  auto* cancel = find<QPushButton>("cancelPlanning");
  EXPECT_FALSE(cancel->isVisible());
  beginEndless();
  EXPECT_EQ(find<QLabel>("busyText")->text(), "Laying the wheel path… (3 of 5)");
  EXPECT_GE(cancel->height(), kTouch);
  EXPECT_GE(cancel->width(), kTouch);
  EXPECT_NE(cancel->focusPolicy() & Qt::TabFocus, 0);
  test::keep("window-planning", m_window);
  QTest::mouseClick(cancel, Qt::LeftButton);
  EXPECT_FALSE(planner().isBusy());
  EXPECT_EQ(find<QLabel>("state")->text(), "Cancelled: values before.\nTo plan: change a value.");
  EXPECT_DOUBLE_EQ(planner().plan()->job.recipe.feed, recipe::Recipe().feed);
  EXPECT_FALSE(m_window.findChild<QPushButton*>("loadJob")->isEnabled()); // it would be of other values
  test::keep("window-cancelled", m_window);
  planner().setRecipe({});
  ASSERT_TRUE(becomesIdle());
  EXPECT_TRUE(find<QLabel>("state")->text().startsWith("Grinding: "));
}

TEST_F(EndlessFlow, EndsByEscape) {
  m_window.openPattern("triangle.dxf");
  ASSERT_TRUE(becomesIdle());
  beginEndless();
  m_window.activateWindow();
  find<QPushButton>("cancelPlanning")->setFocus();
  QTest::keyClick(&m_window, Qt::Key_Escape);
  EXPECT_TRUE(planner().isCancelled());
  EXPECT_FALSE(planner().isBusy());
}

/// In a language of longer words.
struct LongWordsOfFlow {
  test::LongTexts texts{{"Stage", "arris::ui::BusyRow", "arris::ui::JobPage"}};
};

class LongFlow : private LongWordsOfFlow, public EndlessFlow {};

TEST_F(LongFlow, CutsNothingOffWhileItPlansAndWhenThatIsCancelled) {
  m_window.resize(1024, 700);
  m_window.openPattern("triangle.dxf");
  ASSERT_TRUE(becomesIdle());
  beginEndless();
  test::expectNothingCutOff(m_window);
  EXPECT_EQ(m_window.size(), QSize(1024, 700));
  test::keep("window-planning-long", m_window);
  planner().cancel();
  QTest::qWait(1);
  test::expectNothingCutOff(m_window);
  EXPECT_EQ(m_window.size(), QSize(1024, 700));
  test::keep("window-cancelled-long", m_window);
}

} // namespace
} // namespace arris::ui
