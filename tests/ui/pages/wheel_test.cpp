// The wheel that is moved along its path on the page Job.

#include "tests/ui/support/artefacts.h"
#include "tests/ui/support/locales.h"
#include "tests/ui/support/steps.h"
#include "ui/main_window.h"
#include "ui/pages/findings_panel.h"
#include "ui/pages/job_page.h"
#include "ui/pages/run_page.h"
#include "ui/views/drawing_view.h"

#include <QAbstractButton>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

namespace arris::ui {
namespace {

using geometry::Point;

class WheelWindow : public testing::Test {
protected:
  WheelWindow() : m_window(test::fastMachine(m_scratch), test::paneSteps()) {
    m_window.resize(1024, 700);
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

  DrawingView& view() {
    return *find<DrawingView>();
  }

  QAbstractButton* button(const char* name) {
    return find<QAbstractButton>(name);
  }

  QString text() {
    return find<QLabel>("wheelPlace")->text();
  }

  const job::Job& job() {
    return m_window.planner().plan()->job;
  }

  // What the window would say of the wheel there.
  Point wheel() {
    return m_window.wheelWalk().place()->setPoint.position.head<2>();
  }

  // As in the presenter's test.
  Point below(double along) {
    return job().placement.place + Point(along, -job().recipe.wheelRadius);
  }

  QPoint shown(const Point& place) {
    return view().mapFromScene(QPointF(place.x(), place.y()));
  }

  double pixel() { // mm
    return 1 / view().transform().m11();
  }

  void drag(const QPoint& from, const QPoint& to) {
    QTest::mousePress(view().viewport(), Qt::LeftButton, {}, from);
    constexpr int kMoves = 10;
    for (int i = 1; i <= kMoves; ++i) {
      QMouseEvent move(QEvent::MouseMove, from + (to - from) * i / kMoves,
                       view().viewport()->mapToGlobal(from + (to - from) * i / kMoves), Qt::NoButton, Qt::LeftButton,
                       {});
      QApplication::sendEvent(view().viewport(), &move);
    }
    QTest::mouseRelease(view().viewport(), Qt::LeftButton, {}, to);
  }

  void key(Qt::Key key) {
    view().setFocus();
    QTest::keyClick(&view(), key);
  }

  test::Scratch m_scratch;
  MainWindow m_window;
};

TEST_F(WheelWindow, FollowsADragAlongAnEdge) {
  open("rectangle.dxf");
  QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, shown(below(650)));
  ASSERT_LT((wheel() - below(650)).norm(), pixel()) << "a tap on the path puts the wheel there";
  const QTransform before = view().viewportTransform();
  drag(shown(below(650)), shown(below(750)) + QPoint(0, 30)); // the hand strays from the path
  EXPECT_NEAR(wheel().x(), below(750).x(), pixel());
  EXPECT_NEAR(wheel().y(), below(750).y(), 1e-6);
  EXPECT_EQ(view().viewportTransform(), before) << "the drawing does not move along";
  EXPECT_TRUE(text().contains(QStringLiteral("X %1").arg(wheel().x(), 0, 'f', 2))) << text().toStdString();
  EXPECT_TRUE(text().contains(QStringLiteral("Y %1").arg(below(0).y(), 0, 'f', 2))) << text().toStdString();
  EXPECT_TRUE(text().contains("Cruise · 60.0 mm/s")) << text().toStdString(); // 3600 mm/min
  test::keep("wheel-dragged", m_window);
}

TEST_F(WheelWindow, ShowsTheWheelWhereItIs) {
  open("rectangle.dxf");
  m_window.wheelWalk().putTo(below(700), 1);
  const QImage with = view().viewport()->grab().toImage();
  m_window.wheelWalk().putTo(below(300), 1);
  const QImage without = view().viewport()->grab().toImage();
  const QPoint inside = shown(below(700)) - QPoint(0, 8); // beside the path, within 75 mm
  EXPECT_NE(with.pixel(inside), without.pixel(inside));
  const QPoint outside = shown(below(700) - Point(0, 76 + 3 * pixel()));
  EXPECT_EQ(with.pixel(outside), without.pixel(outside));
}

TEST_F(WheelWindow, PansByADragBesideTheWheel) {
  open("rectangle.dxf");
  m_window.wheelWalk().putTo(below(100), 1);
  const double before = m_window.wheelWalk().place()->setPoint.time;
  const QTransform shownBefore = view().viewportTransform();
  const QPoint middle = view().viewport()->rect().center();
  drag(middle, middle + QPoint(60, 20));
  EXPECT_EQ(m_window.wheelWalk().place()->setPoint.time, before);
  EXPECT_NE(view().viewportTransform(), shownBefore);
}

TEST_F(WheelWindow, DoesNotTakeADragOfTheMachinesWheel) {
  open("rectangle.dxf");
  auto& run = *m_window.findChild<RunPage*>()->findChild<DrawingView*>();
  QSignalSpy dragged(&run, &DrawingView::wheelDragged);
  QSignalSpy stepped(&run, &DrawingView::wheelStepped);
  m_window.findChild<QAbstractButton*>("pageRun")->click();
  settle();
  run.setWheel(LiveWheel{below(700), {}});
  const QPoint at = run.mapFromScene(QPointF(below(700).x(), below(700).y()));
  QTest::mousePress(run.viewport(), Qt::LeftButton, {}, at);
  QTest::mouseMove(run.viewport(), at + QPoint(60, 0));
  QTest::mouseRelease(run.viewport(), Qt::LeftButton, {}, at + QPoint(60, 0));
  QTest::keyClick(&run, Qt::Key_Period);
  EXPECT_TRUE(dragged.isEmpty());
  EXPECT_TRUE(stepped.isEmpty());
}

TEST_F(WheelWindow, StepsByButtonsAndKeysUpToTheEnds) {
  open("rectangle.dxf");
  m_window.wheelWalk().putTo(below(700), 1);
  const double from = m_window.wheelWalk().place()->path;
  button("wheelOn")->click();
  EXPECT_NEAR(m_window.wheelWalk().place()->path, from + 10, 1e-6);
  button("wheelBack")->click();
  key(Qt::Key_Comma);
  EXPECT_NEAR(m_window.wheelWalk().place()->path, from - 10, 1e-6);
  key(Qt::Key_PageDown);
  key(Qt::Key_Period);
  key(Qt::Key_PageUp);
  EXPECT_NEAR(m_window.wheelWalk().place()->path, from, 1e-6);
  for (int i = 0; i < 2000 && button("wheelOn")->isEnabled(); ++i) {
    button("wheelOn")->click();
  }
  EXPECT_FALSE(button("wheelOn")->isEnabled());
  EXPECT_TRUE(button("wheelBack")->isEnabled());
  EXPECT_EQ(m_window.wheelWalk().place()->setPoint.time, job().duration);
  for (int i = 0; i < 2000 && button("wheelBack")->isEnabled(); ++i) {
    button("wheelBack")->click();
  }
  EXPECT_FALSE(button("wheelBack")->isEnabled());
  EXPECT_TRUE(text().contains("0.00 s of ")) << text().toStdString();
  EXPECT_TRUE(view().viewport()->rect().contains(shown(wheel()))) << "the park position was not in view";
}

TEST_F(WheelWindow, IsHiddenWhereThePaneCannotBeGround) {
  open("outside.dxf");
  EXPECT_EQ(text(), "");
  EXPECT_FALSE(button("wheelOn")->isEnabled());
  EXPECT_FALSE(button("wheelBack")->isEnabled());
  test::keep("wheel-hidden", m_window);
}

TEST_F(WheelWindow, LeavesCornersAndFindingsTheirTaps) {
  open("triangle.dxf");
  const double before = m_window.wheelWalk().place()->setPoint.time;
  QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, view().labelOf(2).center().toPoint());
  settle();
  EXPECT_EQ(find<FindingsPanel>()->selectedCorner(), 2);
  EXPECT_EQ(m_window.wheelWalk().place()->setPoint.time, before);
  button("fit")->click();
  settle();
  QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, QPoint(4, 4));
  EXPECT_EQ(find<FindingsPanel>()->selectedCorner(), 0) << "a tap beside everything selects nothing";
  EXPECT_EQ(m_window.wheelWalk().place()->setPoint.time, before);
}

TEST_F(WheelWindow, StaysWhenThePagesAreMadeAnew) {
  open("rectangle.dxf");
  m_window.wheelWalk().putTo(below(700), 1);
  const QString before = text();
  files::Settings settings = m_window.preferences().settings();
  settings.appearance = files::Settings::Appearance::Dark;
  m_window.preferences().change(settings);
  settle();
  EXPECT_EQ(text(), before);
  test::keep("wheel-dark", m_window);
  settings.appearance = files::Settings::Appearance::Light;
  m_window.preferences().change(settings);
  settle();
}

class TranslatedWheelWindow : public testing::WithParamInterface<std::string>,
                              public test::Language,
                              public WheelWindow {
protected:
  TranslatedWheelWindow() : Language(GetParam()) {}
};

// At a corner the text is longest.
TEST_P(TranslatedWheelWindow, FitsTheSmallestScreen) {
  open("triangle.dxf");
  const toolpath::Corner& corner = job().toolpath.corners[2];
  m_window.wheelWalk().putTo(corner.s, 1000);
  ASSERT_EQ(m_window.wheelWalk().place()->corner, 3);
  for (const char* views : {"showProfile", "showBoth", "showDrawing"}) {
    button(views)->click();
    settle();
    EXPECT_EQ(m_window.size(), QSize(1024, 700));
    test::expectNothingCutOff(m_window);
    EXPECT_FALSE(text().contains(QStringLiteral("…"))) << text().toStdString();
    test::keep("wheel-" + GetParam() + "-" + views, m_window);
  }
}

std::vector<std::string> wheelLanguages() {
  std::vector<std::string> names = test::languages();
  names.emplace_back("en");
  return names;
}

INSTANTIATE_TEST_SUITE_P(Languages, TranslatedWheelWindow, testing::ValuesIn(wheelLanguages()));

} // namespace
} // namespace arris::ui
