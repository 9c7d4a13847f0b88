// Opening a pattern, as a person would.

#include "core/files/whole_file.h"
#include "tests/ui/support/artefacts.h"
#include "tests/ui/support/locales.h"
#include "tests/ui/support/steps.h"
#include "ui/main_window.h"
#include "ui/pages/pattern_dialog.h"
#include "ui/widgets/control_strip.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/touch_list.h"

#include <QAbstractButton>
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QTest>

#include <gtest/gtest.h>

#include <fstream>

namespace arris::ui {
namespace {

namespace fs = std::filesystem;

constexpr QSize kSmallestWindow(1024, 700);

// A folder with two panes, a drawing that is none, and a folder.
class OpeningAPattern : public testing::Test {
protected:
  OpeningAPattern() : m_window(test::fastMachine(m_scratch), realOrPane()) {
    fs::create_directories(m_scratch / "drawings" / "order 7");
    for (const char* name : {"triangle.dxf", "rectangle.dxf", "broken.dxf", "order 7/many.dxf"}) {
      std::ofstream(m_scratch / "drawings" / name);
    }
    m_window.resize(kSmallestWindow);
    m_window.show();
  }

  // The samples as they are, the panes of other tests, and what is broken.
  static PlannerSteps realOrPane() {
    PlannerSteps steps = test::paneSteps();
    const ReadPattern pane = steps.read;
    steps.read = [pane](const fs::path& file, const pattern::ImportOptions& options, const base::Monitor& monitor) {
      const bool isReal = file.parent_path().filename() == "samples" || file.stem() == "broken";
      return isReal ? plannerSteps().read(file, options, monitor) : pane(file, options, monitor);
    };
    return steps;
  }

  void settle() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !m_window.planner().isBusy(); }, test::kPatience));
    for (int i = 0; i < 5; ++i) { // layouts settle in turns
      QTest::qWait(1);
    }
  }

  // A triangle of its folder, so that a job is there to be left alone.
  void openTriangle() {
    m_window.openPattern(m_scratch / "drawings" / "triangle.dxf");
    settle();
  }

  PatternDialog* dialog() {
    const auto all = m_window.findChildren<PatternDialog*>();
    const auto shown = std::find_if(all.begin(), all.end(), [](const QWidget* one) { return one->isVisible(); });
    return shown != all.end() ? *shown : nullptr;
  }

  template <typename T> T* find(const char* name) {
    return dialog()->findChild<T*>(QString::fromLatin1(name));
  }

  TouchList* entries() {
    return find<TouchList>("patterns");
  }

  void tap(const char* button) {
    auto* target = find<QAbstractButton>(button);
    ASSERT_TRUE(target->isEnabled()) << button;
    QTest::mouseClick(target, Qt::LeftButton);
  }

  // Opened by the button of the page, with its list there.
  void ask() {
    QTest::mouseClick(m_window.findChild<QAbstractButton*>(QStringLiteral("open")), Qt::LeftButton);
    ASSERT_TRUE(dialog() != nullptr);
    QTest::qWait(20);
  }

  void show(const char* list, const char* entry) {
    tap(list);
    await(entry);
  }

  void await(const char* entry) {
    ASSERT_TRUE(QTest::qWaitFor([&] { return rowOf(entry) >= 0; }, test::kPatience)) << entry;
  }

  int rowOf(const char* entry) {
    for (int row = 0; row < entries()->count(); ++row) {
      if (entries()->item(row)->text().section('\n', 0, 0) == entry) {
        return row;
      }
    }
    return -1;
  }

  QPoint placeOf(const char* entry) {
    QListWidgetItem* item = entries()->item(rowOf(entry));
    entries()->scrollToItem(item);
    return entries()->visualItemRect(item).center();
  }

  void tapEntry(const char* entry) {
    QTest::mouseClick(entries()->viewport(), Qt::LeftButton, {}, placeOf(entry));
  }

  void awaitPreview(const char* name) {
    ASSERT_TRUE(QTest::qWaitFor([&] { return text("patternName") == name && !text("patternFacts").isEmpty(); },
                                test::kPatience))
        << name;
    QTest::qWait(5);
  }

  QString text(const char* label) {
    return find<QLabel>(label)->text();
  }

  std::string openedFile() {
    const PlanPointer& plan = m_window.planner().plan();
    return plan ? plan->import->file.filename().string() : std::string();
  }

  void expectOpened(const char* file) {
    EXPECT_TRUE(QTest::qWaitFor([&] { return openedFile() == file; }, test::kPatience)) << openedFile();
    EXPECT_TRUE(QTest::qWaitFor([&] { return dialog() == nullptr; }, test::kPatience));
  }

  test::Scratch m_scratch;
  MainWindow m_window;
};

TEST_F(OpeningAPattern, ShowsWhatIsTappedAndOpensItByTheButton) {
  openTriangle();
  ask();
  show("patternsFolder", "rectangle.dxf");
  tapEntry("rectangle.dxf");
  awaitPreview("rectangle.dxf");
  EXPECT_TRUE(text("patternFacts").contains("Contours: 1 · 1000 × 600 mm")) << text("patternFacts").toStdString();
  EXPECT_EQ(openedFile(), "triangle.dxf"); // only shown
  test::keep("open-folder", *dialog());
  tap("patternOpen");
  expectOpened("rectangle.dxf");
}

TEST_F(OpeningAPattern, OpensByADoubleClick) {
  openTriangle();
  ask();
  show("patternsFolder", "rectangle.dxf");
  const QPoint place = placeOf("rectangle.dxf");
  QTest::mouseClick(entries()->viewport(), Qt::LeftButton, {}, place);
  QTest::mouseDClick(entries()->viewport(), Qt::LeftButton, {}, place);
  expectOpened("rectangle.dxf");
}

TEST_F(OpeningAPattern, OpensByKeysAlone) {
  openTriangle();
  m_window.openPattern(m_scratch / "drawings" / "rectangle.dxf");
  settle();
  ask();
  await("triangle.dxf");
  EXPECT_EQ(QApplication::focusWidget(), entries());
  EXPECT_EQ(entries()->currentRow(), 0); // the latest
  QTest::keyClick(entries(), Qt::Key_Down);
  awaitPreview("triangle.dxf");
  QTest::keyClick(entries(), Qt::Key_Return);
  expectOpened("triangle.dxf");
}

TEST_F(OpeningAPattern, GoesIntoAFolderByATapAndUpAgain) {
  openTriangle();
  ask();
  show("patternsFolder", "order 7");
  tapEntry("order 7");
  await("many.dxf");
  awaitPreview("many.dxf");
  tap("folderUp");
  await("order 7");
  EXPECT_EQ(entries()->currentRow(), rowOf("order 7"));
  entries()->setFocus();
  QTest::keyClick(entries(), Qt::Key_Return); // a folder by Enter
  await("many.dxf");
  QTest::keyClick(entries(), Qt::Key_Return);
  expectOpened("many.dxf");
}

// The second of two quick taps meets the next list, perhaps before it is read.
TEST_F(OpeningAPattern, DoesNotTakeADoubleTapOnAFolderForOneOnWhatIsInIt) {
  fs::create_directories(m_scratch / "drawings" / "order 7" / "deeper");
  openTriangle();
  ask();
  show("patternsFolder", "order 7");
  const QPoint place = placeOf("order 7");
  QTest::mouseClick(entries()->viewport(), Qt::LeftButton, {}, place);
  await("deeper");
  QTest::mouseDClick(entries()->viewport(), Qt::LeftButton, {}, place);
  QTest::qWait(50);
  EXPECT_GE(rowOf("deeper"), 0);
  EXPECT_EQ(openedFile(), "triangle.dxf");
}

TEST_F(OpeningAPattern, GoesWhereAPathIsTyped) {
  ask();
  tap("patternsFolder");
  auto* path = find<QLineEdit>("folderPath");
  ASSERT_TRUE(QTest::qWaitFor([&] { return path->isVisible() && !path->text().isEmpty(); }, test::kPatience));
  path->setFocus();
  path->selectAll();
  QTest::keyClicks(path, QString::fromStdString((m_scratch / "drawings" / "triangle.dxf").string()));
  QTest::keyClick(path, Qt::Key_Return);
  await("triangle.dxf");
  awaitPreview("triangle.dxf");
  EXPECT_TRUE(dialog() != nullptr); // Enter was for the path
  EXPECT_EQ(path->text().toStdString(), (m_scratch / "drawings").string());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  expectOpened("triangle.dxf");
}

TEST_F(OpeningAPattern, SaysThatATypedFolderIsNotThere) {
  ask();
  tap("patternsFolder");
  auto* path = find<QLineEdit>("folderPath");
  ASSERT_TRUE(QTest::qWaitFor([&] { return path->isVisible() && !path->text().isEmpty(); }, test::kPatience));
  path->setFocus();
  path->setText("/nowhere/at/all");
  QTest::keyClick(path, Qt::Key_Return);
  ASSERT_TRUE(QTest::qWaitFor([&] { return text("patternsMessage").contains("No such file"); }, test::kPatience));
  EXPECT_FALSE(find<QAbstractButton>("patternOpen")->isEnabled());
}

TEST_F(OpeningAPattern, LeavesTheJobWhenItIsCancelledByButtonOrKey) {
  openTriangle();
  const PlanPointer before = m_window.planner().plan();
  for (const bool byKey : {false, true}) {
    ask();
    show("patternsFolder", "rectangle.dxf");
    tapEntry("rectangle.dxf");
    awaitPreview("rectangle.dxf");
    if (byKey) {
      QTest::keyClick(entries(), Qt::Key_Escape);
    } else {
      tap("patternCancel");
    }
    EXPECT_TRUE(QTest::qWaitFor([&] { return dialog() == nullptr; }, test::kPatience));
    settle();
    EXPECT_EQ(m_window.planner().plan(), before);
  }
}

TEST_F(OpeningAPattern, SaysWhatIsWrongWithABrokenFileAndLeavesTheJob) {
  openTriangle();
  const PlanPointer before = m_window.planner().plan();
  ask();
  show("patternsFolder", "broken.dxf");
  const QPoint place = placeOf("broken.dxf");
  tapEntry("broken.dxf");
  auto* findings = find<TouchList>("patternFindings");
  ASSERT_TRUE(QTest::qWaitFor([&] { return findings->isVisible() && findings->count() == 1; }, test::kPatience));
  EXPECT_TRUE(findings->item(0)->text().contains("empty")) << findings->item(0)->text().toStdString();
  EXPECT_FALSE(find<QAbstractButton>("patternOpen")->isEnabled());
  QTest::mouseDClick(entries()->viewport(), Qt::LeftButton, {}, place);
  QTest::keyClick(entries(), Qt::Key_Return);
  settle();
  EXPECT_TRUE(dialog() != nullptr);
  EXPECT_EQ(m_window.planner().plan(), before);
  QTest::qWait(20);
  test::keep("open-broken", *dialog());
}

TEST_F(OpeningAPattern, OffersTheSamples) {
  ask();
  show("patternsSamples", "splashback.dxf");
  tapEntry("splashback.dxf");
  awaitPreview("splashback.dxf");
  EXPECT_TRUE(text("patternFacts").contains("Contours: 3")) << text("patternFacts").toStdString();
  test::keep("open-samples", *dialog());
  tap("patternOpen");
  expectOpened("splashback.dxf");
}

TEST_F(OpeningAPattern, LeavesFeedHoldAndStopInReach) {
  openTriangle();
  ask();
  EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
  const auto* strip = m_window.findChild<ControlStrip*>();
  const QRect stops(strip->mapToGlobal(QPoint()), strip->size());
  EXPECT_FALSE(dialog()->frameGeometry().intersects(stops));
  QTest::mouseClick(m_window.findChild<QAbstractButton*>(QStringLiteral("pageSetup")), Qt::LeftButton);
  EXPECT_TRUE(m_window.findChild<QAbstractButton*>(QStringLiteral("pageSetup"))->isChecked());
  EXPECT_TRUE(dialog() != nullptr);
}

TEST_F(OpeningAPattern, EndsWhenTheScreenIsLockedForWiping) {
  openTriangle();
  ask();
  QTest::mouseClick(m_window.findChild<QAbstractButton*>(QStringLiteral("lockScreen")), Qt::LeftButton);
  EXPECT_EQ(dialog(), nullptr);
}

TEST_F(OpeningAPattern, BeginsAgainInTheListOfLastTimeAfterTheWindowWasMadeAnew) {
  openTriangle();
  ask();
  show("patternsFolder", "rectangle.dxf");
  files::Settings settings = m_window.preferences().settings();
  settings.lengthUnit = files::Settings::LengthUnit::Inch;
  m_window.preferences().change(settings);
  ASSERT_TRUE(QTest::qWaitFor([&] { return dialog() == nullptr; }, test::kPatience)); // it was of the window before
  ask();
  await("rectangle.dxf");
  tapEntry("rectangle.dxf");
  awaitPreview("rectangle.dxf");
  EXPECT_TRUE(text("patternFacts").contains("39.37 × 23.62 in")) << text("patternFacts").toStdString();
  settings.appearance = files::Settings::Appearance::Dark;
  m_window.preferences().change(settings);
  m_window.resize(1920, 1080);
  ASSERT_TRUE(QTest::qWaitFor([&] { return dialog() == nullptr; }, test::kPatience));
  settle();
  ask();
  await("rectangle.dxf");
  tapEntry("rectangle.dxf");
  awaitPreview("rectangle.dxf");
  test::keep("open-dark", *dialog());
  m_window.preferences().change({}); // of the whole process
  QTest::qWait(20);
}

TEST_F(OpeningAPattern, HasTargetsForFingers) {
  openTriangle();
  ask();
  show("patternsFolder", "order 7");
  for (const QAbstractButton* button : dialog()->findChildren<QAbstractButton*>()) {
    EXPECT_GE(button->height(), kTouch) << button->objectName().toStdString();
    EXPECT_GE(button->width(), kTouch) << button->objectName().toStdString();
  }
  EXPECT_GE(find<QLineEdit>("folderPath")->height(), kTouch);
  for (int row = 0; row < entries()->count(); ++row) {
    EXPECT_GE(entries()->visualItemRect(entries()->item(row)).height(), kTouch);
  }
}

TEST_F(OpeningAPattern, ShowsAPlanAtTheFirstStart) {
  m_window.openLast();
  settle();
  EXPECT_EQ(openedFile(), "balustrade.dxf");
  EXPECT_TRUE(m_window.planner().plan()->job.canBeGround());
  test::keep("open-first-start", m_window);
}

TEST_F(OpeningAPattern, ShowsAtALaterStartTheLastPatternThatIsStillThere) {
  const fs::path gone = m_scratch / "drawings" / "rectangle.dxf";
  openTriangle();
  m_window.openPattern(gone);
  settle();
  fs::remove(gone);
  m_window.openLast();
  settle();
  EXPECT_EQ(openedFile(), "triangle.dxf");
}

class TranslatedOpening : public testing::WithParamInterface<std::string>,
                          public test::Language,
                          public OpeningAPattern {
protected:
  TranslatedOpening() : Language(GetParam()) {}

  void expectShown(const char* name) {
    QTest::qWait(20);
    EXPECT_TRUE(m_window.geometry().contains(dialog()->geometry()));
    test::expectNothingCutOff(*dialog());
    test::keep("open-" + GetParam() + "-" + name, *dialog());
  }
};

TEST_P(TranslatedOpening, ShowsEverythingOnTheSmallestScreen) {
  openTriangle();
  ask();
  await("triangle.dxf");
  awaitPreview("triangle.dxf");
  expectShown("recent");
  show("patternsSamples", "splashback.dxf");
  tapEntry("splashback.dxf");
  awaitPreview("splashback.dxf");
  expectShown("samples");
  show("patternsFolder", "broken.dxf");
  tapEntry("broken.dxf");
  ASSERT_TRUE(QTest::qWaitFor([&] { return find<TouchList>("patternFindings")->count() == 1; }, test::kPatience));
  expectShown("broken");
  find<QLineEdit>("folderPath")->setFocus();
  find<QLineEdit>("folderPath")->setText("/nowhere/at/all");
  QTest::keyClick(find<QLineEdit>("folderPath"), Qt::Key_Return);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !text("patternsMessage").isEmpty(); }, test::kPatience));
  expectShown("nowhere");
}

std::vector<std::string> openingLanguages() {
  std::vector<std::string> names = test::languages();
  names.emplace_back("en");
  return names;
}

INSTANTIATE_TEST_SUITE_P(Languages, TranslatedOpening, testing::ValuesIn(openingLanguages()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace arris::ui
