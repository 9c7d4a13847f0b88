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
#include <thread>

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
  steps.plan = [&](const pattern::Pattern& pattern, const recipe::Recipe& recipe, const recipe::Machine& machine,
                   const base::Monitor&) {
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
  steps.read = [&](const std::filesystem::path& file, const pattern::ImportOptions& options, const base::Monitor&) {
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

/// Steps whose planning takes until it is given up, or until it may end; counts what was begun.
struct SlowPlanning {
  std::atomic<int> begun = 0;
  std::atomic<bool> mayEnd = false;

  PlannerSteps steps() {
    PlannerSteps steps = test::paneSteps();
    steps.plan = [this, plan = steps.plan](const auto& pattern, const auto& recipe, const auto& machine,
                                           const base::Monitor& monitor) {
      ++begun;
      while (!mayEnd && !monitor.stop.stop_requested()) {
        std::this_thread::yield();
      }
      return plan(pattern, recipe, machine, monitor);
    };
    return steps;
  }

  [[nodiscard]] bool begins(int times) const {
    return QTest::qWaitFor([&] { return begun == times; }, test::kPatience);
  }
};

TEST(Planner, GivesUpWhatIsCancelledAndPlansTheNextRequest) {
  SlowPlanning slow;
  Planner planner({}, slow.steps());
  QSignalSpy planned(&planner, &Planner::planned);
  planner.openPattern("triangle.dxf");
  ASSERT_TRUE(slow.begins(1));
  planner.cancel();
  EXPECT_FALSE(planner.isBusy());
  EXPECT_TRUE(planner.isCancelled());
  slow.mayEnd = true;
  recipe::Recipe recipe;
  recipe.feed = 1200;
  planner.setRecipe(recipe);
  EXPECT_FALSE(planner.isCancelled());
  ASSERT_TRUE(becomesIdle(planner));
  EXPECT_EQ(slow.begun, 2);
  ASSERT_EQ(planned.count(), 1);
  EXPECT_DOUBLE_EQ(lastPlan(planned)->job.recipe.feed, 1200);
}

TEST(Planner, KeepsThePlanBeforeWhenANewOneIsCancelledAndSaysThatItIsNotPresent) {
  SlowPlanning slow;
  Planner planner({}, slow.steps());
  slow.mayEnd = true;
  planner.openPattern("triangle.dxf");
  ASSERT_TRUE(becomesIdle(planner));
  EXPECT_TRUE(planner.isPresent());
  const PlanPointer before = planner.plan();
  slow.mayEnd = false;
  recipe::Recipe recipe;
  recipe.feed = 1200;
  planner.setRecipe(recipe);
  ASSERT_TRUE(slow.begins(2));
  planner.cancel();
  EXPECT_EQ(planner.plan(), before);
  EXPECT_FALSE(planner.isPresent());
  EXPECT_DOUBLE_EQ(planner.recipe().feed, 1200);
  slow.mayEnd = true;
  planner.setRecipe({});
  ASSERT_TRUE(becomesIdle(planner));
  EXPECT_TRUE(planner.isPresent());
}

TEST(Planner, ForgetsAnOpeningThatIsCancelled) {
  std::atomic<bool> reads = false;
  PlannerSteps steps = test::paneSteps();
  steps.read = [&, read = steps.read](const std::filesystem::path& file, const auto& options,
                                      const base::Monitor& monitor) {
    if (file == "rectangle.dxf") {
      reads = true;
      while (!monitor.stop.stop_requested()) {
        std::this_thread::yield();
      }
    }
    return read(file, options, monitor);
  };
  Planner planner({}, steps);
  QSignalSpy planned(&planner, &Planner::planned);
  planner.openPattern("triangle.dxf");
  ASSERT_TRUE(becomesIdle(planner));
  planner.openPattern("rectangle.dxf");
  ASSERT_TRUE(QTest::qWaitFor([&] { return reads.load(); }, test::kPatience));
  planner.cancel();
  recipe::Recipe recipe;
  recipe.feed = 1200;
  planner.setRecipe(recipe);
  ASSERT_TRUE(becomesIdle(planner));
  ASSERT_EQ(planned.count(), 2);
  EXPECT_EQ(lastPlan(planned)->import->file, "triangle.dxf");
}

TEST(Planner, TellsWhichPartOfTheWorkIsUnderWay) {
  Planner planner({});
  QSignalSpy progressed(&planner, &Planner::progressed);
  planner.openPattern(ARRIS_SOURCE_DIR "/resources/samples/triangle.dxf");
  ASSERT_TRUE(becomesIdle(planner));
  using enum base::Stage;
  std::vector<base::Stage> told;
  for (const QList<QVariant>& signal : progressed) {
    told.push_back(signal.front().value<base::Stage>());
  }
  EXPECT_EQ(told, (std::vector{Reading, Joining, WheelPath, Speeds, Profile}));
}

TEST(Planner, PlansTheValueThatWasChangedJustBeforeAFileCouldNotBeOpened) {
  SlowPlanning slow;
  Planner planner({}, slow.steps());
  QSignalSpy planned(&planner, &Planner::planned);
  slow.mayEnd = true;
  planner.openPattern("triangle.dxf");
  ASSERT_TRUE(becomesIdle(planner));
  slow.mayEnd = false;
  recipe::Recipe recipe;
  recipe.feed = 1200;
  planner.setRecipe(recipe);
  ASSERT_TRUE(slow.begins(2));
  planner.openPattern("missing.dxf");
  slow.mayEnd = true;
  ASSERT_TRUE(becomesIdle(planner));
  ASSERT_EQ(planned.count(), 2);
  EXPECT_DOUBLE_EQ(lastPlan(planned)->job.recipe.feed, 1200);
  EXPECT_TRUE(planner.isPresent());
  EXPECT_TRUE(planner.curves());
  ASSERT_TRUE(planner.openProblem()); // it is told still
  EXPECT_EQ(planner.openProblem()->code, base::Code::CannotOpen);
}

TEST(Planner, PlansAPatternThatWasReadJustBeforeAnotherCouldNotBeOpened) {
  SlowPlanning slow;
  Planner planner({}, slow.steps());
  QSignalSpy planned(&planner, &Planner::planned);
  planner.openPattern("triangle.dxf");
  ASSERT_TRUE(slow.begins(1));
  QCoreApplication::processEvents(); // it was read
  planner.openPattern("missing.dxf");
  slow.mayEnd = true;
  ASSERT_TRUE(becomesIdle(planner));
  ASSERT_EQ(planned.count(), 1);
  EXPECT_EQ(lastPlan(planned)->import->file, "triangle.dxf");
}

TEST(Planner, AsksOnceForAFileThatCannotBeOpened) {
  std::atomic<int> readings = 0;
  std::atomic<bool> mayRead = false;
  PlannerSteps steps = test::paneSteps();
  steps.read = [&, read = steps.read](const auto& file, const auto& options, const auto& monitor) {
    ++readings;
    while (!mayRead) {
      std::this_thread::yield();
    }
    return read(file, options, monitor);
  };
  Planner planner({}, steps);
  QSignalSpy failed(&planner, &Planner::openFailed);
  planner.openPattern("missing.dxf");
  ASSERT_TRUE(QTest::qWaitFor([&] { return readings == 1; }, test::kPatience));
  recipe::Recipe recipe;
  for (const double feed : {1000.0, 2000.0}) { // while it is asked for
    recipe.feed = feed;
    planner.setRecipe(recipe);
  }
  mayRead = true;
  ASSERT_TRUE(becomesIdle(planner));
  recipe.feed = 3000;
  planner.setRecipe(recipe);
  ASSERT_TRUE(becomesIdle(planner));
  EXPECT_EQ(readings, 1);
  EXPECT_EQ(failed.count(), 1);
}

TEST(Planner, AsksOnceForAFileThatHasGoneWhenItIsToBeReadDifferently) {
  std::atomic<int> readings = 0;
  PlannerSteps steps = test::paneSteps();
  steps.read = [&, read = steps.read](const auto& file, const auto& options, const auto& monitor) {
    return read(++readings == 1 ? file : std::filesystem::path("missing.dxf"), options, monitor);
  };
  Planner planner({}, steps);
  planner.openPattern("triangle.dxf");
  ASSERT_TRUE(becomesIdle(planner));
  recipe::Recipe recipe;
  recipe.gap = 0.2;
  planner.setRecipe(recipe);
  ASSERT_TRUE(becomesIdle(planner));
  EXPECT_EQ(readings, 2);
  EXPECT_TRUE(planner.openProblem());
  EXPECT_FALSE(planner.isPresent());
}

TEST(Planner, CanGoAwayWhileItWorks) {
  QSemaphore started;
  QSemaphore mayPlan;
  PlannerSteps steps = test::paneSteps();
  steps.plan = [&](const pattern::Pattern& pattern, const recipe::Recipe& recipe, const recipe::Machine& machine,
                   const base::Monitor&) {
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
