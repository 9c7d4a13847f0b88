#include "tests/support/panes.h"
#include "tests/ui/support/artefacts.h"
#include "tests/ui/support/locales.h"
#include "tests/ui/support/recorded_runs.h"
#include "tests/ui/support/steps.h"
#include "ui/figures/path_plot.h"
#include "ui/figures/profile_plot.h"
#include "ui/pages/profiles_page.h"
#include "ui/text/quantities.h"
#include "ui/text/translators.h"
#include "ui/widgets/theme.h"

#include <QButtonGroup>
#include <QFile>
#include <QLabel>
#include <QTest>
#include <QToolButton>

#include <gtest/gtest.h>

#include <fstream>

namespace arris::ui {
namespace {

constexpr QSize kSmallestPage(904, 620);

// Of a transition: halfway between the middle of A and C, and Q.
geometry::Point middleOf(const toolpath::Corner& corner) {
  return (corner.a + corner.c) / 4 + corner.q / 2;
}

class Profiles : public testing::Test {
protected:
  Profiles() : m_planner({}, test::paneSteps()) {
    makePage();
  }

  // As the window does in another language.
  void makePage() {
    m_page.reset();
    m_page = std::make_unique<ProfilesPage>(m_planner, m_files, m_sight);
    m_page->resize(kSmallestPage);
    m_page->show();
  }

  void settle() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !m_planner.isBusy() && !m_page->isBusy(); }, test::kPatience));
    for (int i = 0; i < 5; ++i) { // layouts settle in turns
      QTest::qWait(1);
    }
  }

  void plan(const char* pattern) {
    m_planner.openPattern(pattern);
    settle();
  }

  void open(const std::filesystem::path& file) {
    m_page->openFile(file);
    settle();
  }

  QToolButton* button(const char* name) {
    return m_page->findChild<QToolButton*>(QString::fromLatin1(name));
  }

  void press(const char* name) {
    QTest::mouseClick(button(name), Qt::LeftButton);
    settle();
  }

  QString text(const char* label) {
    return m_page->findChild<QLabel*>(QString::fromLatin1(label))->text();
  }

  // Without the marks of where a line may and may not break.
  std::string state() {
    return text("profilesState").remove(QChar(0x200b)).replace(QChar(0xa0), ' ').toStdString();
  }

  ProfilePlot* plot() {
    return plotNamed("speedsPlot");
  }

  ProfilePlot* plotNamed(const char* name) {
    return m_page->findChild<ProfilePlot*>(QString::fromLatin1(name));
  }

  PathPlot* path() {
    return m_page->findChild<PathPlot*>();
  }

  QCPRange times() {
    return timesOf("speedsPlot");
  }

  QCPRange timesOf(const char* name) {
    return plotNamed(name)->axisRect(0)->axis(QCPAxis::atBottom)->range();
  }

  // A line for each profile and those of the limits.
  int speedCurves() {
    int count = 0;
    for (const QCPGraph* graph : plot()->axisRect(4)->graphs()) {
      count += graph->dataCount() > 2 ? 1 : 0;
    }
    return count;
  }

  // Where this time stands in the plot.
  QPoint placeOf(double time) {
    return {qRound(plot()->axisRect(0)->axis(QCPAxis::atBottom)->coordToPixel(time)), plot()->height() / 2};
  }

  static const job::Job& triangle() {
    static const job::Job kJob = job::planJob(test::triangle600(), {}, {});
    return kJob;
  }

  void expectEverythingShown();

  test::Scratch m_scratch;
  Planner m_planner;
  ProfileFiles m_files;
  ProfileSight m_sight;
  std::unique_ptr<ProfilesPage> m_page;
};

void Profiles::expectEverythingShown() {
  const auto check = [this] {
    EXPECT_EQ(m_page->size(), kSmallestPage) << "the contents pushed the page larger";
    test::expectNothingCutOff(*m_page);
  };
  check();
  plan("triangle.dxf");
  press("profilesNextCorner");
  check();
  const auto record = test::recordOf(triangle(), m_scratch);
  const auto longName = m_scratch / "the third pane of the order of the eleventh of November, after dressing.arrisrun";
  std::filesystem::rename(record, longName);
  open(longName);
  press("profilesNextCorner");
  check();
  open(test::cutAt(0.5, longName, m_scratch));
  check();
  open(m_scratch / "missing.csv");
  check();
  plan("outside.dxf");
  check();
  press("profilesPlanned");
  check();
  plan("triangle.dxf");
  for (const char* content : {"profilesPositions", "profilesPath", "profilesSpeeds"}) {
    press(content);
    press("profilesNextCorner");
    check();
  }
}

TEST_F(Profiles, SayWhatToDoWhenNothingIsOpen) {
  EXPECT_EQ(state(), "No pattern is open. Profiles and records of runs can be opened all the same.");
  EXPECT_TRUE(button("profilesOpen")->isEnabled());
  for (const char* name : {"profilesPlanned", "profilesOverlay", "profilesSave", "profilesNextCorner"}) {
    EXPECT_FALSE(button(name)->isEnabled()) << name;
  }
  test::keep("profiles-empty", *m_page);
}

TEST_F(Profiles, ShowTheProfileOfThePlannedJob) {
  plan("triangle.dxf");
  EXPECT_EQ(state(), "Planned: triangle.dxf");
  EXPECT_EQ(speedCurves(), 1);
  EXPECT_NEAR(times().size(), triangle().working, 0.01);
  test::keep("profiles-planned", *m_page);
}

TEST_F(Profiles, SayWhenThePatternCannotBeGround) {
  plan("triangle.dxf");
  plan("outside.dxf");
  EXPECT_EQ(state(), "The pattern cannot be ground: there is no planned profile.");
  EXPECT_EQ(speedCurves(), 0);
  EXPECT_FALSE(button("profilesZoomIn")->isEnabled());
}

TEST_F(Profiles, LayARecordOverThePlanAndGoBackToThePlanAlone) {
  plan("triangle.dxf");
  open(test::recordOf(triangle(), m_scratch));
  EXPECT_EQ(state(), "run.arrisrun, drawn thin over the plan, which is wide and pale");
  EXPECT_EQ(speedCurves(), 2);
  test::keep("profiles-record", *m_page);
  press("profilesOverlay");
  EXPECT_EQ(state(), "run.arrisrun");
  EXPECT_EQ(speedCurves(), 1);
  press("profilesOverlay");
  EXPECT_EQ(speedCurves(), 2);
  press("profilesPlanned");
  EXPECT_EQ(state(), "Planned: triangle.dxf");
  EXPECT_EQ(speedCurves(), 1);
}

TEST_F(Profiles, LayAnExportedProfileOverThePlan) {
  plan("triangle.dxf");
  recipe::Recipe slow;
  slow.feed = 1800;
  open(test::profileOf(job::planJob(test::triangle600(), slow, {}), m_scratch));
  EXPECT_EQ(state(), "profile.csv, drawn thin over the plan, which is wide and pale");
  EXPECT_EQ(speedCurves(), 2);
}

TEST_F(Profiles, ShowAFileWithoutAnyPlan) {
  open(test::profileOf(triangle(), m_scratch));
  EXPECT_EQ(state(), "profile.csv");
  EXPECT_EQ(speedCurves(), 1);
  EXPECT_FALSE(button("profilesOverlay")->isEnabled());
  plan("triangle.dxf"); // comes later and goes under it
  EXPECT_EQ(speedCurves(), 2);
}

TEST_F(Profiles, StayAsTheyWereWhenAFileIsBrokenAndSayWhy) {
  plan("triangle.dxf");
  open(test::recordOf(triangle(), m_scratch));
  press("profilesNextCorner");
  const QCPRange before = times();
  const QString value = text("value_1_5");
  std::ofstream(m_scratch / "letter.csv") << "Dear customer,\nthe panes are ready.\n";
  open(m_scratch / "letter.csv");
  EXPECT_NE(state().find("letter.csv is not a profile of Arris: the column t_s is missing. (line 1 of the file)"),
            std::string::npos)
      << state();
  EXPECT_EQ(speedCurves(), 2);
  EXPECT_EQ(times(), before);
  EXPECT_EQ(text("value_1_5"), value);
  test::keep("profiles-broken-file", *m_page);
  press("profilesPlanned");
  EXPECT_EQ(state(), "Planned: triangle.dxf");
}

TEST_F(Profiles, ShowWhatARecordThatBreaksOffStillHoldsAndSaySo) {
  open(test::cutAt(0.5, test::recordOf(triangle(), m_scratch), m_scratch));
  EXPECT_EQ(speedCurves(), 1);
  EXPECT_NE(state().find("cut.arrisrun is not whole: it breaks off at byte "), std::string::npos) << state();
}

// Braking from 60 to 20 mm/s, the transition of 12.990 s and accelerating again, and a tenth more at either end.
TEST_F(Profiles, GoFromCornerToCornerAndZoomToEach) {
  plan("triangle.dxf");
  double last = 0;
  for (int corner = 1; corner <= 3; ++corner) {
    press("profilesNextCorner");
    EXPECT_GT(times().size(), 1.2 * 12.99038);
    EXPECT_LT(times().size(), 1.2 * (12.99038 + 2 * 5));
    EXPECT_GT(times().center(), last);
    last = times().center();
    // L(t_m/2) = (R/2)(s + 1/s) with s = sin 30°, where 20 mm/s have turned by 60°: 20 cos 60°
    EXPECT_EQ(text("value_0_5"), "93.75");
    EXPECT_EQ(text("value_0_4"), "10.00");
  }
  test::keep("profiles-corner", *m_page);
  press("profilesNextCorner"); // the first again
  EXPECT_LT(times().center(), last);
  press("profilesPreviousCorner");
  EXPECT_DOUBLE_EQ(times().center(), last);
  press("profilesWork");
  EXPECT_NEAR(times().size(), triangle().working, 0.01);
  press("profilesAll");
  EXPECT_NEAR(times().size(), triangle().duration, 0.01);
}

TEST_F(Profiles, ZoomInAndOutRoundTheMiddle) {
  plan("triangle.dxf");
  const QCPRange before = times();
  press("profilesZoomIn");
  EXPECT_LT(times().size(), before.size());
  EXPECT_NEAR(times().center(), before.center(), 1e-9);
  press("profilesZoomOut");
  EXPECT_NEAR(times().size(), before.size(), 1e-9);
}

TEST_F(Profiles, TellTheValuesAtTheTimeThatIsTappedOrHoveredOver) {
  plan("triangle.dxf");
  open(test::recordOf(triangle(), m_scratch));
  EXPECT_EQ(text("instant").trimmed(), "");
  press("profilesNextCorner");
  const double middle = times().center();
  QTest::mouseMove(plot(), placeOf(middle));
  EXPECT_TRUE(text("instant").startsWith("t = ")) << text("instant").toStdString();
  EXPECT_EQ(text("value_0_4").left(2), "10"); // mm/s, to a pixel of time
  EXPECT_EQ(text("value_1_4").left(2), "10");
  press("profilesWork");
  QTest::mouseClick(plot(), Qt::LeftButton, {}, placeOf(times().lower + 0.999 * times().size()));
  EXPECT_EQ(text("value_0_5"), "–"); // no corner is due any more
}

TEST_F(Profiles, AreReadAndZoomedByKeys) {
  plan("triangle.dxf");
  press("profilesNextCorner");
  plot()->setFocus();
  const double whole = times().size();
  QTest::keyClick(plot(), Qt::Key_Plus);
  EXPECT_LT(times().size(), whole);
  QTest::keyClick(plot(), Qt::Key_Minus);
  EXPECT_NEAR(times().size(), whole, 1e-9);
  const QCPRange shown = times();
  const double before = text("instant").section(' ', 2, 2).toDouble();
  QTest::keyClick(plot(), Qt::Key_Right);
  QTest::keyClick(plot(), Qt::Key_Right);
  QTest::keyClick(plot(), Qt::Key_Left);
  EXPECT_NEAR(text("instant").section(' ', 2, 2).toDouble(), before + shown.size() / 200, 0.0011);
  test::keep("profiles-keys", *m_page);
  QTest::keyClick(plot(), Qt::Key_Home);
  EXPECT_NEAR(times().size(), triangle().working, 0.01);
}

TEST_F(Profiles, GoOnFromTheCornerThatIsTapped) {
  plan("triangle.dxf");
  press("profilesNextCorner");
  press("profilesNextCorner");
  const double second = times().center();
  press("profilesPreviousCorner");
  press("profilesWork");
  QTest::mouseClick(plot(), Qt::LeftButton, {}, placeOf(second));
  press("profilesNextCorner");
  EXPECT_GT(times().center(), second + 10);
}

TEST_F(Profiles, KeepTheViewWhenAValueOfThePlanChanges) {
  plan("triangle.dxf");
  press("profilesNextCorner");
  const QCPRange before = times();
  recipe::Recipe recipe;
  recipe.depth = 0.2;
  m_planner.setRecipe(recipe);
  settle();
  EXPECT_EQ(times(), before);
  plan("rectangle.dxf"); // another pattern is shown from the start
  EXPECT_GT(times().size(), 2 * before.size());
}

TEST_F(Profiles, AreSavedAsAPicture) {
  plan("triangle.dxf");
  open(test::recordOf(triangle(), m_scratch));
  const std::filesystem::path picture = m_scratch / "profile.svg";
  m_page->savePicture(picture);
  settle();
  EXPECT_EQ(state(), "Saved: profile.svg");
  QFile file(QString::fromStdString(picture.string()));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QByteArray svg = file.readAll();
  for (const char* words : {"<svg", "run.arrisrun", "Plan", "60°", "limit 20"}) {
    EXPECT_TRUE(svg.contains(words)) << words;
  }
  m_page->savePicture(m_scratch / "profile.txt");
  settle();
  EXPECT_NE(state().find(".svg, .pdf, .png"), std::string::npos) << state();
}

TEST_F(Profiles, ShowThePositionsOverTime) {
  plan("triangle.dxf");
  open(test::recordOf(triangle(), m_scratch));
  press("profilesNextCorner");
  const QCPRange before = times();
  press("profilesPositions");
  ProfilePlot* positions = plotNamed("positionsPlot");
  ASSERT_TRUE(positions->isVisible());
  EXPECT_EQ(positions->axisRectCount(), 2);
  EXPECT_EQ(positions->axisRect(0)->axis(QCPAxis::atBottom)->range(), before); // the same times
  const geometry::Point middle = middleOf(triangle().toolpath.corners[0]);
  EXPECT_NEAR(text("value_0_0").toDouble(), middle.x(), 0.03);
  EXPECT_NEAR(text("value_0_1").toDouble(), middle.y(), 0.03);
  EXPECT_EQ(text("value_0_2"), "10.00");
  EXPECT_EQ(text("value_0_3"), "93.75");
  EXPECT_EQ(text("value_0_4").trimmed(), "");
  press("profilesNextCorner");
  EXPECT_GT(positions->axisRect(0)->axis(QCPAxis::atBottom)->range().center(), before.center());
  test::keep("profiles-positions-corner", *m_page);
  press("profilesWork");
  test::keep("profiles-positions", *m_page);
  press("profilesSpeeds");
  EXPECT_NEAR(times().size(), triangle().working, 0.01);
}

// A corner is small on the table.
TEST_F(Profiles, ShowPositionsOverTheRoomOfWhatIsInView) {
  plan("triangle.dxf");
  press("profilesPositions");
  const auto expectFitted = [&](int panel, Panel kind) {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    const QCPRange times = timesOf("positionsPlot");
    for (int i = 0; i <= 1000; ++i) {
      const double value = curveValue(curveOf(*m_planner.curves(), kind), times.lower + times.size() * i / 1000);
      least = std::min(least, value);
      most = std::max(most, value);
    }
    const QCPRange range = plotNamed("positionsPlot")->axisRect(panel)->axis(QCPAxis::atLeft)->range();
    EXPECT_LE(range.lower, least);
    EXPECT_GE(range.upper, most);
    EXPECT_LT(range.size(), 1.5 * (most - least));
  };
  expectFitted(0, Panel::PositionX);
  press("profilesNextCorner");
  expectFitted(0, Panel::PositionX);
  expectFitted(1, Panel::PositionY);
  press("profilesZoomIn");
  press("profilesZoomIn");
  expectFitted(0, Panel::PositionX);
  expectFitted(1, Panel::PositionY);
}

TEST_F(Profiles, ShowThePathInThePlaneInOneScale) {
  plan("triangle.dxf");
  open(test::recordOf(triangle(), m_scratch));
  press("profilesPath");
  test::keep("profiles-path", *m_page);
  press("profilesNextCorner");
  const toolpath::Corner& corner = triangle().toolpath.corners[0];
  const job::CornerResult& result = triangle().cornerResults[0];
  const QRectF shown = path()->shownBox();
  for (const geometry::Point& place : {corner.a, corner.c, corner.q, corner.s, result.decelerationPoint}) {
    EXPECT_TRUE(shown.contains(place.x(), place.y()));
  }
  EXPECT_LT(shown.width(), 600);
  const QCPAxisRect* rect = path()->axisRect();
  EXPECT_NEAR(shown.width() / rect->width(), shown.height() / rect->height(), 1e-6);
  test::keep("profiles-path-corner", *m_page);
  press("profilesZoomIn");
  EXPECT_NEAR(path()->shownBox().width(), shown.width() / 1.5, 1e-6);
  EXPECT_NEAR(path()->shownBox().height(), shown.height() / 1.5, 1e-6);
  press("profilesNextCorner");
  EXPECT_FALSE(path()->shownBox().contains(corner.s.x(), corner.s.y()));
  press("profilesAll");
  EXPECT_TRUE(path()->shownBox().contains(QRectF(0, 0, 1500, 2500)));
}

TEST_F(Profiles, TellTheValuesAtThePlaceOfThePathThatIsTapped) {
  plan("triangle.dxf");
  press("profilesPath");
  press("profilesNextCorner");
  const toolpath::Corner& corner = triangle().toolpath.corners[0];
  const QPoint at(qRound(path()->xAxis->coordToPixel(corner.a.x())), qRound(path()->yAxis->coordToPixel(corner.a.y())));
  QTest::mouseClick(path(), Qt::LeftButton, {}, at);
  EXPECT_NEAR(text("value_0_0").toDouble(), corner.a.x(), 1); // to a pixel
  EXPECT_NEAR(text("value_0_3").toDouble(), 75, 0.1);
  const QString before = text("instant");
  QTest::keyClick(path(), Qt::Key_Right);
  EXPECT_NE(text("instant"), before);
}

TEST_F(Profiles, ShowThePathOfAFileWithoutAnyPlan) {
  open(test::recordOf(triangle(), m_scratch));
  press("profilesPath");
  press("profilesNextCorner");
  EXPECT_TRUE(path()->shownBox().contains(triangle().toolpath.corners[0].a.x(), triangle().toolpath.corners[0].a.y()));
  test::keep("profiles-path-file", *m_page);
}

TEST_F(Profiles, SaveThePictureThatIsShown) {
  plan("triangle.dxf");
  open(test::recordOf(triangle(), m_scratch));
  press("profilesPath");
  press("profilesNextCorner");
  const auto saved = [&](const char* name) {
    m_page->savePicture(test::artefact(name));
    settle();
    QFile file(QString::fromStdString(test::artefact(name).string()));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll();
  };
  const QByteArray way = saved("profiles-path-picture.svg");
  for (const char* words : {"X, mm", "Y, mm", ">Q<", ">S<", "run.arrisrun", "Glass"}) {
    EXPECT_TRUE(way.contains(words)) << words;
  }
  saved("profiles-path-picture.png");
  press("profilesPositions");
  const QByteArray positions = saved("profiles-positions-picture.svg");
  EXPECT_TRUE(positions.contains("X position"));
  EXPECT_FALSE(positions.contains("X velocity"));
  saved("profiles-positions-picture.png");
}

TEST_F(Profiles, SaveTheProfileOfTheRunThatIsOpenElseThePlannedOne) {
  plan("triangle.dxf");
  const auto read = [this](const char* name) {
    m_page->saveProfile(m_scratch / name);
    settle();
    QFile file(QString::fromStdString((m_scratch / name).string()));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll();
  };
  EXPECT_FALSE(read("planned.csv").contains("vx_meas_mm_s"));
  EXPECT_EQ(state(), "Saved: planned.csv");
  open(test::recordOf(triangle(), m_scratch));
  EXPECT_TRUE(read("executed.csv").contains("vx_meas_mm_s"));
}

TEST_F(Profiles, SaveTheJobSheetAlsoOfAPaneThatCannotBeGround) {
  EXPECT_FALSE(button("profilesSaveSheet")->isEnabled());
  plan("outside.dxf");
  EXPECT_TRUE(button("profilesSaveSheet")->isEnabled());
  EXPECT_FALSE(button("profilesSaveProfile")->isEnabled());
  m_page->saveJobSheet(m_scratch / "sheet.pdf");
  settle();
  EXPECT_EQ(state(), "Saved: sheet.pdf");
  EXPECT_GT(std::filesystem::file_size(m_scratch / "sheet.pdf"), 10000U);
}

TEST_F(Profiles, AreAsTheyWereOnAPageThatIsMadeAnew) {
  plan("triangle.dxf");
  open(test::cutAt(0.5, test::recordOf(triangle(), m_scratch), m_scratch));
  press("profilesNextCorner");
  press("profilesPositions");
  press("profilesZoomIn");
  const QCPRange shown = timesOf("positionsPlot");
  const QString x = text("value_0_0");
  makePage();
  settle();
  EXPECT_NE(state().find("cut.arrisrun"), std::string::npos) << state();
  EXPECT_TRUE(plotNamed("positionsPlot")->isVisible());
  EXPECT_EQ(timesOf("positionsPlot"), shown);
  EXPECT_EQ(text("value_0_0"), x);
  press("profilesSpeeds");
  EXPECT_EQ(speedCurves(), 2);
  EXPECT_EQ(times(), shown);
  press("profilesNextCorner");
  EXPECT_GT(times().center(), shown.center()); // on from the corner that was gone to
  press("profilesOverlay");
  press("profilesNextCorner");
  press("profilesPath");
  const QRectF box = path()->shownBox();
  makePage();
  settle();
  EXPECT_TRUE(path()->isVisible());
  EXPECT_FALSE(button("profilesOverlay")->isChecked());
  EXPECT_LT(path()->shownBox().width(), 1.5 * box.width()); // the corner, not all of the way
  press("profilesSpeeds");
  EXPECT_EQ(speedCurves(), 1);
}

TEST_F(Profiles, AreInInchesWhereTheWindowIsButNotInPictures) {
  showLengthsIn(LengthUnit::Inch);
  ProfileSight sight;
  ProfilesPage page(m_planner, m_files, sight);
  page.resize(kSmallestPage);
  page.show();
  plan("triangle.dxf");
  QTest::mouseClick(page.findChild<QToolButton*>(QStringLiteral("profilesNextCorner")), Qt::LeftButton);
  EXPECT_EQ(page.findChild<QLabel*>(QStringLiteral("value_0_5"))->text(), "3.691"); // 93.75 mm
  const auto* plot = page.findChild<ProfilePlot*>(QStringLiteral("speedsPlot"));
  EXPECT_TRUE(plot->axisRect(0)->axis(QCPAxis::atLeft)->label().endsWith("in/s"));
  EXPECT_NEAR(plot->axisRect(4)->axis(QCPAxis::atLeft)->range().upper, 1.12 * 60 / 25.4, 1e-6);
  page.savePicture(m_scratch / "inch.svg");
  settle();
  QTest::qWait(20);
  test::keep("profiles-inch", page);
  showLengthsIn(LengthUnit::Millimetre);
  QFile file(QString::fromStdString((m_scratch / "inch.svg").string()));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QByteArray svg = file.readAll();
  EXPECT_TRUE(svg.contains("mm/s"));
  EXPECT_FALSE(svg.contains("in/s"));
}

TEST_F(Profiles, LookRightInTheDark) {
  showAppearance(Appearance::Dark);
  ProfileSight sight;
  ProfilesPage page(m_planner, m_files, sight);
  page.resize(kSmallestPage);
  page.show();
  plan("triangle.dxf");
  open(test::recordOf(triangle(), m_scratch));
  QTest::mouseClick(page.findChild<QToolButton*>(QStringLiteral("profilesNextCorner")), Qt::LeftButton);
  QTest::qWait(20);
  test::keep("profiles-dark", page);
  QTest::mouseClick(page.findChild<QToolButton*>(QStringLiteral("profilesPath")), Qt::LeftButton);
  QTest::qWait(20);
  test::keep("profiles-dark-path", page);
  showAppearance(Appearance::Light);
  const QImage shown = page.findChild<PathPlot*>()->grab().toImage();
  EXPECT_LT(shown.pixelColor(2, 2).lightness(), 60);
}

TEST_F(Profiles, HaveTargetsForFingersThatTheTabulatorReaches) {
  plan("triangle.dxf");
  open(test::recordOf(triangle(), m_scratch));
  button("profilesOpen")->setFocus();
  QSet<QWidget*> reached{button("profilesOpen")};
  for (int i = 0; i < 30; ++i) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    reached.insert(QApplication::focusWidget());
  }
  EXPECT_TRUE(reached.contains(plot()));
  for (QToolButton* each : m_page->findChildren<QToolButton*>()) {
    EXPECT_GE(each->height(), kTouch) << each->objectName().toStdString();
    EXPECT_GE(each->width(), kTouch) << each->objectName().toStdString();
    const bool byArrows = each->group() != nullptr && reached.contains(each->group()->checkedButton());
    EXPECT_TRUE(reached.contains(each) || byArrows) << each->objectName().toStdString();
  }
}

TEST_F(Profiles, ShowEverythingOnTheSmallestScreen) {
  expectEverythingShown();
}

TEST_F(Profiles, LookRightOnALargeScreen) {
  plan("triangle.dxf");
  open(test::recordOf(triangle(), m_scratch));
  m_page->resize(1920, 1080);
  settle();
  test::keep("profiles-large", *m_page);
  press("profilesNextCorner");
  test::keep("profiles-large-corner", *m_page);
  plan("many.dxf");
  press("profilesPlanned");
  test::keep("profiles-large-many", *m_page);
}

class TranslatedProfiles : public testing::WithParamInterface<std::string>, public test::Language, public Profiles {
protected:
  TranslatedProfiles() : Language(GetParam()) {}
};

TEST_P(TranslatedProfiles, ShowEverythingOnTheSmallestScreen) {
  expectEverythingShown();
  open(test::recordOf(triangle(), m_scratch));
  plan("triangle.dxf");
  press("profilesNextCorner");
  test::keep("profiles-" + GetParam(), *m_page);
}

INSTANTIATE_TEST_SUITE_P(Languages, TranslatedProfiles, testing::ValuesIn(test::languages()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace arris::ui
