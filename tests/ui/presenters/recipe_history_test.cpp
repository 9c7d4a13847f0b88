#include "tests/support/dice.h"
#include "tests/ui/support/steps.h"
#include "ui/presenters/recipe_history.h"

#include <QSignalSpy>

#include <gtest/gtest.h>

namespace arris::ui {
namespace {

class RecipeSteps : public testing::Test {
protected:
  void set(double recipe::Recipe::*member, double value) {
    recipe::Recipe recipe = m_planner.recipe();
    recipe.*member = value;
    m_planner.setRecipe(recipe);
  }

  [[nodiscard]] double feed() const {
    return m_planner.recipe().feed;
  }

  Planner m_planner{{}, test::paneSteps()};
  RecipeHistory m_history{m_planner};
};

TEST_F(RecipeSteps, HasNothingToUndoAtFirst) {
  EXPECT_FALSE(m_history.canUndo());
  EXPECT_FALSE(m_history.canRedo());
  m_history.undo();
  m_history.redo();
  EXPECT_EQ(m_planner.recipe(), recipe::Recipe());
}

TEST_F(RecipeSteps, TakesWhatIsTypedIntoOneFieldAsOneStep) {
  for (const double typed : {1.0, 18.0, 180.0, 1800.0}) {
    set(&recipe::Recipe::feed, typed);
  }
  m_history.undo();
  EXPECT_DOUBLE_EQ(feed(), 3600);
  EXPECT_FALSE(m_history.canUndo());
  m_history.redo();
  EXPECT_DOUBLE_EQ(feed(), 1800);
  EXPECT_FALSE(m_history.canRedo());
}

TEST_F(RecipeSteps, TakesTheSameFieldAsAStepOfItsOwnOnceItWasLeft) {
  set(&recipe::Recipe::feed, 1800);
  m_history.endStep();
  set(&recipe::Recipe::feed, 900);
  m_history.undo();
  EXPECT_DOUBLE_EQ(feed(), 1800);
  m_history.undo();
  EXPECT_DOUBLE_EQ(feed(), 3600);
}

TEST_F(RecipeSteps, HasNoStepWhereTheValueWasTypedBack) {
  set(&recipe::Recipe::feed, 360);
  set(&recipe::Recipe::feed, 3600);
  EXPECT_FALSE(m_history.canUndo());
}

TEST_F(RecipeSteps, ForgetsWhatWasUndoneOnceSomethingElseIsChanged) {
  set(&recipe::Recipe::feed, 1800);
  m_history.undo();
  set(&recipe::Recipe::depth, 0.3);
  EXPECT_FALSE(m_history.canRedo());
}

TEST_F(RecipeSteps, CanForget) {
  set(&recipe::Recipe::feed, 1800);
  m_history.forget();
  EXPECT_FALSE(m_history.canUndo());
  m_history.undo();
  EXPECT_DOUBLE_EQ(feed(), 1800);
}

// Whatever is changed in whatever order: all undone gives the recipe at the beginning, all redone that at the end.
TEST_F(RecipeSteps, UndoesAndRedoesAnySequence) {
  test::Dice dice(20);
  const std::vector<double recipe::Recipe::*> members{&recipe::Recipe::feed, &recipe::Recipe::depth,
                                                      &recipe::Recipe::wheelRadius};
  for (int round = 0; round < 100; ++round) {
    const recipe::Recipe first = m_planner.recipe();
    m_history.forget();
    for (int change = 0; change < 60; ++change) {
      const double what = dice.between(0, 6);
      if (what < 3) {
        set(members[static_cast<std::size_t>(what)], std::floor(dice.between(1, 5)));
      } else if (what < 4) {
        m_history.endStep();
      } else if (what < 5) {
        m_history.undo();
      } else {
        m_history.redo();
      }
    }
    while (m_history.canRedo()) {
      m_history.redo();
    }
    const recipe::Recipe last = m_planner.recipe();
    while (m_history.canUndo()) {
      m_history.undo();
    }
    ASSERT_EQ(m_planner.recipe(), first) << "round " << round;
    while (m_history.canRedo()) {
      m_history.redo();
    }
    ASSERT_EQ(m_planner.recipe(), last) << "round " << round;
  }
}

TEST_F(RecipeSteps, KeepsTheLatestStepsOnly) {
  for (std::size_t step = 0; step < RecipeHistory::kMostSteps + 50; ++step) {
    set(&recipe::Recipe::feed, 100 + static_cast<double>(step));
    m_history.endStep();
  }
  std::size_t undone = 0;
  for (; m_history.canUndo(); ++undone) {
    m_history.undo();
  }
  EXPECT_EQ(undone, RecipeHistory::kMostSteps);
  EXPECT_DOUBLE_EQ(feed(), 149); // the fiftieth stays
}

} // namespace
} // namespace arris::ui
