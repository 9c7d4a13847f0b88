#include "tests/support/panes.h"
#include "tests/support/scratch.h"
#include "tests/ui/support/steps.h"
#include "ui/presenters/planner.h"

#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>

namespace arris::ui {
namespace {

bool becomesIdle(const Planner& planner) {
  return QTest::qWaitFor([&] { return !planner.isBusy(); }, test::kPatience);
}

PlanPointer lastPlan(const QSignalSpy& planned) {
  return planned.isEmpty() ? nullptr : planned.last().front().value<PlanPointer>();
}

TEST(Planner, PlansAPatternWithItsProfileInTheBackground) {
  Planner planner({}, test::paneSteps());
  QSignalSpy planned(&planner, &Planner::planned);
  QSignalSpy profiles(&planner, &Planner::profileReady);
  QSignalSpy busy(&planner, &Planner::busyChanged);
  planner.openPattern("triangle.dxf");
  EXPECT_TRUE(planner.isBusy());
  EXPECT_TRUE(planned.isEmpty()); // nothing happened in the caller's time
  ASSERT_TRUE(becomesIdle(planner));
  ASSERT_EQ(planned.count(), 1);
  EXPECT_TRUE(lastPlan(planned)->job.canBeGround());
  EXPECT_EQ(lastPlan(planned)->job.toolpath.corners.size(), 3U);
  EXPECT_EQ(profiles.count(), 1);
  ASSERT_EQ(busy.count(), 2);
  EXPECT_TRUE(busy[0][0].toBool());
  EXPECT_FALSE(busy[1][0].toBool());
}

TEST(Planner, PlansAgainWhenAValueChangesAndOnlyThen) {
  Planner planner({}, test::paneSteps());
  QSignalSpy planned(&planner, &Planner::planned);
  planner.openPattern("triangle.dxf");
  ASSERT_TRUE(becomesIdle(planner));
  recipe::Recipe recipe;
  planner.setRecipe(recipe);
  EXPECT_FALSE(planner.isBusy());
  recipe.wheelRadius = 60;
  planner.setRecipe(recipe);
  ASSERT_TRUE(becomesIdle(planner));
  ASSERT_EQ(planned.count(), 2);
  EXPECT_DOUBLE_EQ(lastPlan(planned)->job.recipe.wheelRadius, 60);
}

TEST(Planner, DoesNothingWithoutAPattern) {
  Planner planner({}, test::paneSteps());
  recipe::Recipe recipe;
  recipe.feed = 100;
  planner.setRecipe(recipe);
  EXPECT_FALSE(planner.isBusy());
}

TEST(Planner, LetsTheLatestRequestWinAndDropsWhatWasOvertaken) {
  PlannerSteps steps = test::paneSteps();
  QSemaphore mayPlan;
  std::atomic<int> plannings = 0;
  steps.plan = [&](const pattern::Pattern& pattern, const recipe::Recipe& recipe, const recipe::Machine& machine) {
    ++plannings;
    mayPlan.acquire();
    return job::planJob(pattern, recipe, machine);
  };
  Planner planner({}, steps);
  QSignalSpy planned(&planner, &Planner::planned);
  planner.openPattern("triangle.dxf");
  ASSERT_TRUE(QTest::qWaitFor([&] { return plannings == 1; }, test::kPatience));
  recipe::Recipe recipe;
  for (const double feed : {1000.0, 2000.0, 3000.0}) { // while the first is under way
    recipe.feed = feed;
    planner.setRecipe(recipe);
  }
  mayPlan.release(10);
  ASSERT_TRUE(becomesIdle(planner));
  EXPECT_EQ(plannings, 2); // the first and the last
  ASSERT_EQ(planned.count(), 1);
  EXPECT_DOUBLE_EQ(lastPlan(planned)->job.recipe.feed, 3000);
}

// While "1800" is typed, a feed of 1 mm/min has a profile of a hundred million rows.
TEST(Planner, LeavesTheLongProfileOfAValueThatWasOvertaken) {
  Planner planner({}, test::paneSteps());
  QSignalSpy planned(&planner, &Planner::planned);
  recipe::Recipe recipe;
  recipe.feed = 1;
  planner.setRecipe(recipe);
  planner.openPattern("triangle.dxf");
  ASSERT_TRUE(planned.wait(test::kPatience));
  recipe.feed = 1800;
  planner.setRecipe(recipe);
  ASSERT_TRUE(becomesIdle(planner));
  EXPECT_DOUBLE_EQ(lastPlan(planned)->job.recipe.feed, 1800);
}

TEST(Planner, SaysWhyAFileCannotBeOpenedAndKeepsThePatternBefore) {
  Planner planner({}, test::paneSteps());
  QSignalSpy planned(&planner, &Planner::planned);
  QSignalSpy failed(&planner, &Planner::openFailed);
  planner.openPattern("triangle.dxf");
  ASSERT_TRUE(becomesIdle(planner));
  planner.openPattern("missing.dxf");
  ASSERT_TRUE(becomesIdle(planner));
  ASSERT_EQ(failed.count(), 1);
  EXPECT_EQ(failed[0][0].value<base::Problem>().code, base::Code::CannotOpen);
  recipe::Recipe recipe;
  recipe.feed = 1200;
  planner.setRecipe(recipe);
  ASSERT_TRUE(becomesIdle(planner));
  EXPECT_EQ(failed.count(), 1);
  EXPECT_EQ(lastPlan(planned)->import->file, "triangle.dxf");
  EXPECT_DOUBLE_EQ(lastPlan(planned)->job.recipe.feed, 1200);
}

TEST(Planner, ReadsAFileOnceUntilItIsOpenedAgainOrReadDifferently) {
  PlannerSteps steps = test::paneSteps();
  std::atomic<int> readings = 0;
  steps.read = [&](const std::filesystem::path& file, const pattern::ImportOptions& options) {
    ++readings;
    return Import{file, options, test::triangle600(), {}};
  };
  Planner planner({}, steps);
  planner.openPattern("triangle.dxf");
  ASSERT_TRUE(becomesIdle(planner));
  recipe::Recipe recipe;
  recipe.depth = 0.2;
  planner.setRecipe(recipe);
  ASSERT_TRUE(becomesIdle(planner));
  EXPECT_EQ(readings, 1);
  recipe.gap = 0.2;
  planner.setRecipe(recipe);
  ASSERT_TRUE(becomesIdle(planner));
  EXPECT_EQ(readings, 2);
  planner.openPattern("triangle.dxf");
  ASSERT_TRUE(becomesIdle(planner));
  EXPECT_EQ(readings, 3);
}

TEST(Planner, GivesAPlanWithoutAProfileWhereThePaneCannotBeGround) {
  Planner planner({}, test::paneSteps());
  QSignalSpy planned(&planner, &Planner::planned);
  QSignalSpy profiles(&planner, &Planner::profileReady);
  planner.openPattern("outside.dxf");
  ASSERT_TRUE(becomesIdle(planner));
  ASSERT_EQ(planned.count(), 1);
  EXPECT_FALSE(lastPlan(planned)->job.canBeGround());
  EXPECT_EQ(profiles.count(), 0);
}

TEST(Planner, ReadsADxfFileFromTheDisk) {
  const test::Scratch scratch;
  const std::filesystem::path file = scratch / "square.dxf";
  std::ofstream(file) << "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n0\n90\n4\n70\n1\n10\n0\n20\n0\n10\n400\n20\n0\n"
                         "10\n400\n20\n400\n10\n0\n20\n400\n0\nENDSEC\n0\nEOF\n";
  Planner planner({});
  QSignalSpy planned(&planner, &Planner::planned);
  planner.openPattern(file);
  ASSERT_TRUE(becomesIdle(planner));
  ASSERT_EQ(planned.count(), 1);
  EXPECT_EQ(lastPlan(planned)->job.toolpath.corners.size(), 4U);
  EXPECT_TRUE(lastPlan(planned)->job.canBeGround());
}

TEST(Planner, CanGoAwayWhileItWorks) {
  QSemaphore started;
  QSemaphore mayPlan;
  PlannerSteps steps = test::paneSteps();
  steps.plan = [&](const pattern::Pattern& pattern, const recipe::Recipe& recipe, const recipe::Machine& machine) {
    started.release();
    mayPlan.acquire();
    return job::planJob(pattern, recipe, machine);
  };
  {
    Planner planner({}, steps);
    planner.openPattern("triangle.dxf");
    started.acquire();
    mayPlan.release();
  }
  QTest::qWait(1); // what was delivered to it is gone
}

} // namespace
} // namespace arris::ui
