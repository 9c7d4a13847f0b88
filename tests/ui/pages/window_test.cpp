#include "tests/ui/support/artefacts.h"
#include "tests/ui/support/locales.h"
#include "tests/ui/support/steps.h"
#include "ui/main_window.h"
#include "ui/models/problem_model.h"
#include "ui/pages/findings_panel.h"
#include "ui/pages/job_page.h"
#include "ui/pages/recipe_panel.h"
#include "ui/text/translators.h"
#include "ui/views/drawing_view.h"
#include "ui/widgets/number_edit.h"
#include "ui/widgets/theme.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QCheckBox>
#include <QDropEvent>
#include <QHeaderView>
#include <QLabel>
#include <QMimeData>
#include <QSignalSpy>
#include <QTabBar>
#include <QTableView>
#include <QTest>

#include <gtest/gtest.h>

namespace arris::ui {
namespace {

constexpr QSize kSmallest(1024, 700);

class Window : public testing::Test {
protected:
  Window()
      : m_window(test::fastMachine(m_scratch), test::paneSteps()), m_planned(&m_window.planner(), &Planner::planned) {
    m_window.resize(kSmallest);
    m_window.show();
  }

  void open(const char* file) {
    m_window.openPattern(file);
    settle();
  }

  void settle() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !m_window.planner().isBusy(); }, test::kPatience));
    for (int i = 0; i < 5; ++i) { // layouts settle in turns
      QTest::qWait(1);
    }
  }

  template <typename T = QWidget> T* find(const char* name = nullptr) {
    return m_window.findChild<JobPage*>()->findChild<T*>(QString::fromLatin1(name));
  }

  QLineEdit* field(const char* key) {
    return find<RecipePanel>()->field(key)->line();
  }

  void type(const char* key, const char* text) {
    field(key)->setFocus();
    field(key)->selectAll();
    QTest::keyClicks(field(key), QString::fromUtf8(text));
    settle();
  }

  QString text(const char* label) {
    return find<QLabel>(label)->text().replace(QChar(QChar::Nbsp), QLatin1Char(' '));
  }

  const job::Job& job() {
    return m_planned.last().front().value<PlanPointer>()->job;
  }

  void tap(QWidget* widget, const QPoint& place) {
    QTest::mouseClick(widget, Qt::LeftButton, {}, place);
    settle();
  }

  void expectEverythingShown();

  test::Scratch m_scratch;
  MainWindow m_window;
  QSignalSpy m_planned;
};

void Window::expectEverythingShown() {
  for (const char* file : {"triangle.dxf", "many.dxf", "outside.dxf"}) {
    open(file);
    for (const char* views : {"showProfile", "showBoth", "showDrawing"}) {
      find<QAbstractButton>(views)->click();
      settle();
      EXPECT_EQ(m_window.size(), kSmallest) << "the contents pushed the window larger with " << views;
      test::expectNothingCutOff(m_window);
    }
    find<FindingsPanel>()->selectCorner(1);
    settle();
    test::expectNothingCutOff(m_window);
  }
  open("splashback.dxf");
  for (const char* page : {"showPane", "showGrinding"}) {
    find<QAbstractButton>(page)->click();
    settle();
    EXPECT_EQ(m_window.size(), kSmallest);
    test::expectNothingCutOff(m_window);
  }
  find<FindingsPanel>()->setCurrentIndex(1);
  settle();
  test::expectNothingCutOff(m_window);
  for (const char* wrong : {"999999", "3.600", "3,600", "?"}) {
    for (const char* key : {"wheel_radius_mm", "accel_x_mm_s2"}) {
      type(key, wrong);
      EXPECT_EQ(m_window.size(), kSmallest) << "the complaint pushed the window larger about " << wrong;
      test::expectNothingCutOff(m_window);
    }
  }
}

TEST_F(Window, SaysWhatToDoWhenNothingIsOpen) {
  EXPECT_EQ(text("state"), "No pattern is open.");
  test::keep("window-empty", m_window);
}

TEST_F(Window, ShowsTimesAndCornersOfAPattern) {
  open("triangle.dxf");
  EXPECT_EQ(m_window.windowTitle(), "triangle.dxf – Arris");
  EXPECT_TRUE(text("state").startsWith("Grinding: 1 min 18.2 s"));
  EXPECT_EQ(find<QTableView>("corners")->model()->rowCount(), 3);
  test::keep("window-triangle", m_window);
}

TEST_F(Window, PlansAgainWhenAValueIsTyped) {
  open("triangle.dxf");
  type("wheel_radius_mm", "60");
  EXPECT_DOUBLE_EQ(job().recipe.wheelRadius, 60);
  // L(t_m/2) = (R/2)(s + 1/s) with s = sin 30°
  EXPECT_EQ(find<QTableView>("corners")->model()->index(0, 6).data().toString(), "75.00");
}

TEST_F(Window, TakesDecimalCommaAndPoint) {
  open("triangle.dxf");
  type("depth_mm", "0,25");
  EXPECT_DOUBLE_EQ(job().recipe.depth, 0.25);
  type("depth_mm", "0.35");
  EXPECT_DOUBLE_EQ(job().recipe.depth, 0.35);
}

TEST_F(Window, NamesTheRangeOfAWrongValueAndKeepsTheLastGoodPlan) {
  open("triangle.dxf");
  type("wheel_radius_mm", "700");
  EXPECT_TRUE(text("complaint").contains("Wheel radius is out of range; it must be from 0.5 to 500"))
      << text("complaint").toStdString();
  EXPECT_DOUBLE_EQ(job().recipe.wheelRadius, 70); // as far as the typing was valid
  const auto* sign = field("wheel_radius_mm")->findChild<QAbstractButton*>();
  EXPECT_TRUE(field("wheel_radius_mm")->rect().contains(sign->geometry()));
  QTest::qWait(300); // the sign fades in
  test::keep("window-wrong-value", m_window);
  type("wheel_radius_mm", "80");
  EXPECT_EQ(text("complaint"), "");
  EXPECT_DOUBLE_EQ(job().recipe.wheelRadius, 80);
}

TEST_F(Window, DoesNotAllowMoreAccelerationThanTheMachineHas) {
  open("triangle.dxf");
  type("accel_x_mm_s2", "501"); // the machine has 500
  EXPECT_TRUE(text("complaint").contains("from 0.1 to 500")) << text("complaint").toStdString();
}

TEST_F(Window, ShowsTheRimSpeedBesideTheSpindleSpeed) {
  // 2π · 0.075 m · 6000/min = 47.1 m/s
  const auto shows = [this](const char* words) {
    const QList<QLabel*> labels = m_window.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) { return label->text() == words; });
  };
  EXPECT_TRUE(shows("Rim speed: 47.1 m/s"));
  type("spindle_r_min", "3000");
  EXPECT_TRUE(shows("Rim speed: 23.6 m/s"));
}

TEST_F(Window, ShowsTheFiguresOfACornerThatIsTapped) {
  open("triangle.dxf");
  auto* view = find<DrawingView>();
  ASSERT_TRUE(view->labelOf(2).isValid());
  tap(view->viewport(), view->labelOf(2).center().toPoint());
  EXPECT_EQ(text("cornerTitle"), "Corner 2: 60°, transition");
  EXPECT_TRUE(text("cornerFigures").contains("20.00 mm/s")) << text("cornerFigures").toStdString();
  EXPECT_TRUE(text("cornerFigures").contains("1.5396 mm/s²"));
  EXPECT_TRUE(text("cornerFigures").contains("12.990 s"));
  EXPECT_TRUE(text("cornerFigures").contains("93.750"));
  EXPECT_EQ(find<QTableView>("corners")->currentIndex().row(), 1);
  test::keep("window-corner", m_window);
}

TEST_F(Window, ShowsACornerThatIsChosenInTheTable) {
  open("triangle.dxf");
  auto* corners = find<QTableView>("corners");
  tap(corners->viewport(), corners->visualRect(corners->model()->index(2, 1)).center());
  EXPECT_EQ(text("cornerTitle"), "Corner 3: 60°, transition");
  auto* view = find<DrawingView>();
  EXPECT_TRUE(view->viewport()->rect().contains(view->labelOf(3).center().toPoint()));
  EXPECT_FALSE(view->viewport()->rect().contains(view->labelOf(1).center().toPoint())); // it came near
}

// On the smallest window there is no room for the card beside drawing and profile.
TEST_F(Window, ShowsTheFiguresOfACornerInShortWhereTheCardHasNoRoom) {
  m_window.resize(1024, 768);
  open("triangle.dxf");
  find<QAbstractButton>("showBoth")->click();
  settle();
  auto* view = find<DrawingView>();
  tap(view->viewport(), view->labelOf(2).center().toPoint());
  EXPECT_EQ(text("state"), "Corner 2: 60°, transition\n20.0 mm/s; 13.0 s");
  find<QAbstractButton>("showDrawing")->click();
  EXPECT_TRUE(text("state").startsWith("Grinding: ")) << text("state").toStdString();
}

TEST_F(Window, KeepsTheChosenCornerWhenAValueChanges) {
  open("triangle.dxf");
  find<FindingsPanel>()->selectCorner(3);
  type("feed_mm_min", "1800");
  EXPECT_EQ(find<FindingsPanel>()->selectedCorner(), 3);
  EXPECT_TRUE(text("cornerFigures").contains("10.00 mm/s")); // (60/180) · 30
}

TEST_F(Window, ShowsThePlaceOfAProblemThatIsTapped) {
  open("outside.dxf");
  EXPECT_EQ(text("state"), "Cannot be ground: see the problems.");
  find<FindingsPanel>()->setCurrentIndex(1);
  settle();
  test::keep("window-problems", m_window);
  auto* problems = find<QAbstractItemView>("problems");
  ASSERT_GT(problems->model()->rowCount(), 0);
  tap(problems->viewport(), problems->visualRect(problems->model()->index(0, 0)).center());
  auto* view = find<DrawingView>();
  const geometry::Point where = *find<ProblemModel>()->problem(0).where;
  const QPoint shown = view->mapFromScene(QPointF(where.x(), where.y()));
  EXPECT_LT((shown - view->viewport()->rect().center()).manhattanLength(), 4);
  test::keep("window-problem-place", m_window);
}

TEST_F(Window, ShowsThePlaceOfARepairThatIsTapped) {
  open("repaired.dxf");
  find<FindingsPanel>()->setCurrentIndex(1);
  settle();
  auto* problems = find<QAbstractItemView>("problems");
  ASSERT_EQ(problems->model()->rowCount(), 1);
  EXPECT_TRUE(problems->model()->index(0, 0).data().toString().startsWith("Repaired: A gap of 0.02 mm was closed."));
  tap(problems->viewport(), problems->visualRect(problems->model()->index(0, 0)).center());
  auto* view = find<DrawingView>();
  const geometry::Point where = *find<ProblemModel>()->problem(0).where;
  const QPoint shown = view->mapFromScene(QPointF(where.x(), where.y()));
  EXPECT_LT((shown - view->viewport()->rect().center()).manhattanLength(), 4);
}

TEST_F(Window, ShowsTheProblemWhoseSignIsTapped) {
  open("splashback.dxf"); // its sockets are too small for the wheel
  auto* view = find<DrawingView>();
  const auto* model = find<ProblemModel>();
  const base::Problem second = model->problem(1);
  ASSERT_EQ(second.code, base::Code::ContourNotEntered);
  tap(view->viewport(), view->mapFromScene(QPointF(second.where->x(), second.where->y())));
  EXPECT_EQ(find<FindingsPanel>()->currentIndex(), 1);
  EXPECT_EQ(find<QAbstractItemView>("problems")->currentIndex().row(), 1);
  test::keep("window-sign", m_window);
}

TEST_F(Window, TakesTheSizeCorrectionOnThePageOfThePane) {
  open("rectangle.dxf");
  find<QAbstractButton>("showPane")->click();
  settle();
  type("size_correction_mm", "0.5");
  EXPECT_DOUBLE_EQ(job().recipe.sizeCorrection, 0.5);
  EXPECT_TRUE(job().canBeGround());
  test::keep("window-pane", m_window);
}

// A wheel of 75 mm does not go into the sockets.
TEST_F(Window, LeavesUngroundWhatTheWheelCannotReachWhenToldSo) {
  open("splashback.dxf");
  EXPECT_FALSE(job().canBeGround());
  find<QAbstractButton>("showPane")->click();
  settle();
  test::keep("window-unreached", m_window);
  tap(find<QCheckBox>("accept_unreached"), {14, 22});
  EXPECT_TRUE(job().recipe.acceptUnreached);
  test::keep("window-accepted", m_window);
  EXPECT_TRUE(job().canBeGround());
  EXPECT_TRUE(text("state").startsWith("Grinding: "));
}

TEST_F(Window, ShowsAConcaveCornerWithTheContourThatItIsOf) {
  open("splashback.dxf");
  type("wheel_radius_mm", "15");
  find<QAbstractButton>("showPane")->click();
  settle();
  type("lead_mm", "10");
  ASSERT_TRUE(job().canBeGround());
  find<FindingsPanel>()->selectCorner(4);
  settle();
  EXPECT_EQ(text("cornerTitle"), "Corner 4: 270°, exact stop (contour 3)");
  EXPECT_TRUE(text("cornerFigures").contains("6.213 mm before the corner")) << text("cornerFigures").toStdString();
  test::keep("window-concave", m_window);
}

TEST_F(Window, SaysWhyAFileCannotBeOpenedAndKeepsTheOneBefore) {
  open("triangle.dxf");
  open("missing.dxf");
  EXPECT_TRUE(text("state").contains("missing.dxf cannot be opened: No such file or directory."));
  EXPECT_EQ(find<QTableView>("corners")->model()->rowCount(), 3);
}

TEST_F(Window, OpensAFileThatIsDroppedOnIt) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile("/somewhere/rectangle.dxf")});
  QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&m_window, &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&m_window, &drop);
  settle();
  EXPECT_EQ(find<QTableView>("corners")->model()->rowCount(), 4);
}

TEST_F(Window, ZoomsByTapsAndKeysAndFitsAgain) {
  open("rectangle.dxf");
  auto* view = find<DrawingView>();
  const double fitted = view->transform().m11();
  tap(find<QAbstractButton>("zoomIn"), {5, 5});
  EXPECT_GT(view->transform().m11(), fitted);
  tap(find<QAbstractButton>("fit"), {5, 5});
  EXPECT_NEAR(view->transform().m11(), fitted, 1e-12);
  view->setFocus();
  QTest::keyClick(view, Qt::Key_Plus);
  EXPECT_GT(view->transform().m11(), fitted);
  QTest::keyClick(view, Qt::Key_Home);
  EXPECT_NEAR(view->transform().m11(), fitted, 1e-12);
}

TEST_F(Window, KeepsTheViewWhenAValueChanges) {
  open("rectangle.dxf");
  auto* view = find<DrawingView>();
  view->zoomToCorner(2);
  const QTransform before = view->viewportTransform();
  type("depth_mm", "0.2");
  EXPECT_EQ(view->viewportTransform(), before);
}

TEST_F(Window, ReachesEveryControlWithTheTabulator) {
  open("triangle.dxf");
  field("wheel_radius_mm")->setFocus();
  QSet<QWidget*> reached;
  for (int i = 0; i < 60; ++i) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    reached.insert(QApplication::focusWidget());
  }
  for (const char* name : {"open", "showDrawing", "zoomIn", "zoomOut", "fit", "corners", "spindle_r_min", "depth_mm"}) {
    EXPECT_TRUE(reached.contains(find<QWidget>(name))) << name;
  }
  EXPECT_TRUE(reached.contains(find<DrawingView>()));
}

// Every kind of control that is tapped is large enough for a finger in a glove.
TEST_F(Window, HasTargetsForFingers) {
  open("many.dxf");
  const auto check = [](const QWidget* widget, const QSize& size) {
    EXPECT_GE(size.height(), kTouch) << widget->metaObject()->className() << ' ' << widget->objectName().toStdString();
    EXPECT_GE(size.width(), kTouch) << widget->metaObject()->className() << ' ' << widget->objectName().toStdString();
  };
  for (const QAbstractButton* button : m_window.findChildren<QAbstractButton*>()) {
    if (button->isVisible() && button->parentWidget()->metaObject() != &QLineEdit::staticMetaObject) {
      check(button, button->size());
    }
  }
  for (const char* page : {"showPane", "showGrinding"}) {
    find<QAbstractButton>(page)->click();
    settle();
    for (const QLineEdit* line : m_window.findChildren<QLineEdit*>()) {
      if (line->isVisible()) {
        check(line, line->size());
      }
    }
    for (const QCheckBox* box : m_window.findChildren<QCheckBox*>()) {
      if (box->isVisible()) {
        check(box, box->size());
      }
    }
  }
  for (const QTabBar* tabs : m_window.findChildren<QTabBar*>()) {
    for (int i = 0; i < tabs->count(); ++i) {
      check(tabs, tabs->tabRect(i).size());
    }
  }
  check(find<QTableView>("corners"), {kTouch, find<QTableView>("corners")->rowHeight(0)});
}

// Nothing is cut off on the smallest screen: every text has the room that it asks for.
TEST_F(Window, ShowsEverythingOnTheSmallestScreen) {
  expectEverythingShown();
}

TEST_F(Window, LooksRightInEverySize) {
  open("triangle.dxf");
  find<FindingsPanel>()->selectCorner(2);
  for (const char* views : {"showProfile", "showBoth"}) {
    find<QAbstractButton>(views)->click();
    settle();
    test::keep(std::string("window-") + views, m_window);
  }
  m_window.resize(1920, 1080);
  settle();
  find<QAbstractButton>("fit")->click();
  settle();
  test::keep("window-large", m_window);
  open("many.dxf");
  test::keep("window-large-many", m_window);
}

class TranslatedWindow : public testing::WithParamInterface<std::string>, public test::Language, public Window {
protected:
  TranslatedWindow() : Language(GetParam()) {}

  void keep(const char* name) {
    test::keep("window-" + GetParam() + "-" + name, m_window);
  }
};

TEST_P(TranslatedWindow, ShowsEverythingOnTheSmallestScreen) {
  expectEverythingShown();
  keep("wrong-value");
}

TEST_P(TranslatedWindow, LooksRight) {
  keep("empty");
  open("outside.dxf");
  find<FindingsPanel>()->setCurrentIndex(1);
  settle();
  keep("problems");
  open("triangle.dxf");
  find<FindingsPanel>()->setCurrentIndex(2);
  settle();
  keep("times");
  find<FindingsPanel>()->setCurrentIndex(0);
  find<FindingsPanel>()->selectCorner(2);
  settle();
  keep("corner");
  find<QAbstractButton>("showProfile")->click();
  settle();
  keep("profile");
  find<QAbstractButton>("showBoth")->click();
  m_window.resize(1920, 1080);
  settle();
  find<QAbstractButton>("fit")->click();
  settle();
  keep("large");
  find<QAbstractButton>("showDrawing")->click();
  find<QAbstractButton>("showPane")->click();
  for (int i = 0; i < 2; ++i) { // what is side by side holds the window wide until it stands below
    m_window.resize(kSmallest);
    settle();
  }
  open("splashback.dxf");
  find<FindingsPanel>()->setCurrentIndex(1);
  settle();
  keep("pane");
}

INSTANTIATE_TEST_SUITE_P(Languages, TranslatedWindow, testing::ValuesIn(test::languages()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace arris::ui
