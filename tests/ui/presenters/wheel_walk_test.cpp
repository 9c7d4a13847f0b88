#include "tests/ui/support/locales.h"
#include "tests/ui/support/steps.h"
#include "ui/presenters/wheel_walk.h"
#include "ui/text/quantities.h"
#include "ui/text/wheel_text.h"

#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <set>

namespace arris::ui {
namespace {

using geometry::Point;

class WheelWalks : public testing::Test {
protected:
  void open(const char* file) {
    m_planner.openPattern(file);
    settle();
  }

  void setWheelRadius(double radius) {
    recipe::Recipe recipe = m_planner.recipe();
    recipe.wheelRadius = radius;
    m_planner.setRecipe(recipe);
    settle();
  }

  void settle() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !m_planner.isBusy(); }, test::kPatience));
  }

  [[nodiscard]] const job::Job& job() const {
    return m_planner.plan()->job;
  }

  [[nodiscard]] Point at() const {
    return m_walk.place()->setPoint.position.head<2>();
  }

  // On the way of the wheel's centre below the lower side of the rectangle, so far from its left corner.
  [[nodiscard]] Point below(double along) const {
    return job().placement.place + Point(along, -job().recipe.wheelRadius);
  }

  Planner m_planner{{}, test::paneSteps()};
  WheelWalk m_walk{m_planner};
};

TEST_F(WheelWalks, HasNoPlaceWithoutAPlan) {
  EXPECT_FALSE(m_walk.place());
  m_walk.stepOn();
  m_walk.dragTo({0, 0}, 10);
  EXPECT_FALSE(m_walk.putTo({0, 0}, 1e9));
  EXPECT_FALSE(m_walk.place());
}

TEST_F(WheelWalks, HasNoPlaceWhereThePaneCannotBeGroundAndOneAgainOnceItCan) {
  open("rectangle.dxf");
  ASSERT_TRUE(m_walk.putTo(below(300), 1));
  setWheelRadius(500); // leaves the travel
  ASSERT_FALSE(job().canBeGround());
  EXPECT_FALSE(m_walk.place());
  setWheelRadius(75);
  ASSERT_TRUE(m_walk.place());
  EXPECT_LT((at() - below(300)).norm(), 1e-6);
}

TEST_F(WheelWalks, BeginsWhereTheWheelComesOntoTheGlass) {
  open("rectangle.dxf");
  EXPECT_EQ(m_walk.place()->phase, job::Phase::LeadIn);
  EXPECT_NEAR(m_walk.place()->speed, 0, 1e-9); // at rest after the plunge
}

// Far from the ends of a side 1000 mm long, and from its middle, where the wheel comes onto the glass, it has the feed:
// 3600 mm/min are 60 mm/s.
TEST_F(WheelWalks, TellsWhatIsPlannedForAPlace) {
  open("rectangle.dxf");
  ASSERT_TRUE(m_walk.putTo(below(700) + Point(0, -8), 10));
  const job::Sample place = *m_walk.place();
  EXPECT_LT((at() - below(700)).norm(), 1e-6);
  EXPECT_NEAR(place.speed, 60, 1e-9);
  EXPECT_EQ(place.phase, job::Phase::Cruise);
  EXPECT_EQ(place.corner, 0);
  EXPECT_NEAR(std::abs(place.setPoint.velocity.x()), 60, 1e-9);
  EXPECT_FALSE(m_walk.putTo(below(700) + Point(0, -12), 10)); // too far away: the wheel stays
  EXPECT_LT((at() - below(700)).norm(), 1e-6);
}

TEST_F(WheelWalks, StepsTenMillimetresAlongTheWay) {
  open("rectangle.dxf");
  m_walk.putTo(below(700), 1);
  const double direction = m_walk.place()->setPoint.velocity.x() > 0 ? 1 : -1;
  m_walk.stepOn();
  EXPECT_NEAR(at().x(), below(700 + 10 * direction).x(), 1e-6);
  m_walk.stepBack();
  m_walk.stepBack();
  EXPECT_NEAR(at().x(), below(700 - 10 * direction).x(), 1e-6);
}

// Nothing that is planned is stepped over, and every step leads on.
TEST_F(WheelWalks, StepsThroughEveryPhaseFromEndToEnd) {
  open("triangle.dxf");
  while (!m_walk.isAtStart()) {
    const double before = m_walk.place()->setPoint.time;
    m_walk.stepBack();
    ASSERT_LT(m_walk.place()->setPoint.time, before);
  }
  EXPECT_EQ(m_walk.place()->setPoint.position, job().machine.park);
  std::set<std::pair<job::Phase, int>> met;
  while (!m_walk.isAtEnd()) {
    const double before = m_walk.place()->setPoint.time;
    met.emplace(m_walk.place()->phase, m_walk.place()->corner);
    m_walk.stepOn();
    ASSERT_GT(m_walk.place()->setPoint.time, before);
    ASSERT_LE(m_walk.place()->path, 1e6);
  }
  met.emplace(m_walk.place()->phase, m_walk.place()->corner);
  for (const job::PlannedPiece& piece : job().pieces) {
    EXPECT_TRUE(met.contains({piece.phase, piece.corner})) << job::name(piece.phase) << ' ' << piece.corner;
  }
  m_walk.stepOn();
  EXPECT_EQ(m_walk.place()->setPoint.time, job().duration);
}

TEST_F(WheelWalks, FollowsTheHandRoundTheWholePane) {
  open("rectangle.dxf");
  m_walk.putTo(below(700), 1);
  const Point origin = job().placement.place;
  const double radius = job().recipe.wheelRadius;
  for (double y = -radius; y < 600; y += 20) { // off the end of the lower side: round the corner and up
    m_walk.dragTo(origin + Point(1000 + radius, y), 40);
  }
  EXPECT_NEAR(at().x(), origin.x() + 1000 + radius, 1e-6);
  EXPECT_GT(at().y(), origin.y() + 500);
}

TEST_F(WheelWalks, GoesToTheStartOfAnotherPattern) {
  open("rectangle.dxf");
  m_walk.putTo(below(700), 1);
  open("triangle.dxf");
  EXPECT_EQ(m_walk.place()->phase, job::Phase::LeadIn);
}

TEST_F(WheelWalks, KeepsItsShareOfTheWayWhenAValueChanges) {
  open("rectangle.dxf");
  m_walk.putTo(below(700), 1);
  const double share = m_walk.place()->path / job::Trajectory(job()).length();
  setWheelRadius(60);
  EXPECT_NEAR(m_walk.place()->path / job::Trajectory(job()).length(), share, 1e-9);
  EXPECT_NEAR(at().y(), below(700).y(), 1e-6); // on the same side still
  setWheelRadius(75);
  EXPECT_LT((at() - below(700)).norm(), 1e-6);
}

TEST_F(WheelWalks, SaysWhenItMoves) {
  open("rectangle.dxf");
  QSignalSpy changed(&m_walk, &WheelWalk::changed);
  m_walk.stepOn();
  m_walk.dragTo(below(700), 40);
  EXPECT_EQ(changed.count(), 2);
}

job::Sample sampleInTransition() {
  job::Sample sample;
  sample.setPoint.time = 12.336;
  sample.setPoint.position = {312.4, 118.02, 40};
  sample.speed = 38.21;
  sample.phase = job::Phase::Transition;
  sample.corner = 3;
  sample.distance = 101.6;
  return sample;
}

TEST(WheelText, SaysWhereTheWheelIs) {
  EXPECT_EQ(wheelText(sampleInTransition(), 78.2, test::kEnglish).toStdString(),
            "Planned: X 312.40  Y 118.02  Z 40.00 mm · 12.34 s of 1 min 18.2 s\n"
            "Transition, corner 3 · 38.2 mm/s · 101.6 mm to the corner");
  job::Sample cruise = sampleInTransition();
  cruise.phase = job::Phase::Cruise;
  cruise.corner = 0;
  EXPECT_EQ(wheelText(cruise, 78.2, test::kEnglish).section('\n', 1).toStdString(), "Cruise · 38.2 mm/s");
}

TEST(WheelText, HasTheOperatorsNumbersAndUnit) {
  EXPECT_TRUE(
      wheelText(sampleInTransition(), 78.2, test::kGerman).startsWith("Planned: X 312,40  Y 118,02  Z 40,00 mm"));
  showLengthsIn(LengthUnit::Inch);
  const QString inches = wheelText(sampleInTransition(), 78.2, test::kEnglish);
  showLengthsIn(LengthUnit::Millimetre);
  EXPECT_EQ(inches.toStdString(), "Planned: X 12.299  Y 4.646  Z 1.575 in · 12.34 s of 1 min 18.2 s\n"
                                  "Transition, corner 3 · 1.50 in/s · 4.00 in to the corner");
}

} // namespace
} // namespace arris::ui
