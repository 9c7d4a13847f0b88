#include "core/files/whole_file.h"
#include "tests/support/scratch.h"
#include "tests/ui/support/steps.h"
#include "ui/presenters/recipe_book.h"

#include <gtest/gtest.h>

namespace arris::ui {
namespace {

class Book : public testing::Test {
protected:
  void set(double recipe::Recipe::*member, double value) {
    recipe::Recipe recipe = m_planner.recipe();
    recipe.*member = value;
    m_planner.setRecipe(recipe);
  }

  test::Scratch m_scratch;
  Planner m_planner{{}, test::paneSteps()};
  RecipeBook m_book{m_scratch / "recipes", m_planner};
};

TEST_F(Book, LoadsWhatWasSaved) {
  set(&recipe::Recipe::thickness, 6);
  const recipe::Recipe saved = m_planner.recipe();
  EXPECT_TRUE(m_book.save("6 mm float").empty());
  EXPECT_EQ(m_book.current(), "6 mm float");
  EXPECT_FALSE(m_book.isChanged());
  set(&recipe::Recipe::feed, 1234);
  EXPECT_TRUE(m_book.isChanged());
  EXPECT_TRUE(m_book.load("6 mm float").empty());
  EXPECT_EQ(m_planner.recipe(), saved);
  EXPECT_FALSE(m_book.isChanged());
}

TEST_F(Book, FindsTheNameOfTheRecipeInEffectAtTheNextStart) {
  set(&recipe::Recipe::thickness, 6);
  ASSERT_TRUE(m_book.save("six").empty());
  RecipeBook later(m_scratch / "recipes", m_planner);
  EXPECT_TRUE(later.refresh().empty());
  EXPECT_EQ(later.current(), "six");
}

TEST_F(Book, DoesNotLoadWhatTheMachineCannotDo) {
  recipe::Machine strong;
  strong.maxAccel = {5000, 5000, 5000};
  Planner elsewhere(strong, test::paneSteps());
  recipe::Recipe fast;
  fast.accelX = 4000; // this machine has 500
  elsewhere.setRecipe(fast);
  ASSERT_TRUE(RecipeBook(m_scratch / "recipes", elsewhere).save("fast").empty());
  ASSERT_TRUE(m_book.refresh().empty());
  const base::Problems problems = m_book.load("fast");
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems.front().code, base::Code::ValueAboveMachine);
  EXPECT_EQ(m_planner.recipe(), recipe::Recipe());
  EXPECT_EQ(m_book.current(), "");
}

TEST_F(Book, ImportsAFileWithoutPuttingItIntoEffect) {
  recipe::Recipe other;
  other.feed = 777;
  ASSERT_TRUE(files::writeWholeFile(m_scratch / "other.json", files::writeRecipe(other)));
  EXPECT_TRUE(m_book.importFile(m_scratch / "other.json", "other").empty());
  EXPECT_EQ(m_planner.recipe(), recipe::Recipe());
  ASSERT_NE(m_book.find("other"), nullptr);
  EXPECT_EQ(m_book.find("other")->recipe, other);
}

TEST_F(Book, RefusesADamagedFileAndLeavesItWhereItIs) {
  const std::filesystem::path file = m_scratch / "bad.json";
  ASSERT_TRUE(files::writeWholeFile(file, R"({"arris_recipe": 1, "depth_mm": "deep"})"));
  const base::Problems problems = m_book.importFile(file, "bad");
  EXPECT_TRUE(base::hasErrors(problems));
  EXPECT_TRUE(m_book.recipes().empty());
  EXPECT_TRUE(std::filesystem::exists(file));
  EXPECT_EQ(m_book.importFile(m_scratch / "none.json", "none").front().code, base::Code::CannotOpen);
}

TEST_F(Book, ExportsAFileThatIsTheSameRecipe) {
  set(&recipe::Recipe::thickness, 19);
  ASSERT_TRUE(m_book.save("nineteen").empty());
  EXPECT_TRUE(m_book.exportTo(m_scratch / "out.json", "nineteen").empty());
  EXPECT_EQ(files::readRecipeFile(m_scratch / "out.json").value, m_planner.recipe());
  EXPECT_EQ(m_book.exportTo(m_scratch / "no" / "out.json", "nineteen").front().code, base::Code::CannotWrite);
}

TEST_F(Book, ForgetsADeletedOneAndKeepsItsValuesInEffect) {
  set(&recipe::Recipe::thickness, 6);
  const recipe::Recipe inEffect = m_planner.recipe();
  ASSERT_TRUE(m_book.save("six").empty());
  EXPECT_TRUE(m_book.remove("six").empty());
  EXPECT_EQ(m_book.current(), "");
  EXPECT_TRUE(m_book.recipes().empty());
  EXPECT_EQ(m_planner.recipe(), inEffect);
}

TEST_F(Book, WritesNothingWhileABackUpIsRestored) {
  ASSERT_TRUE(m_book.save("six").empty());
  m_book.setKeeping(false);
  set(&recipe::Recipe::feed, 1);
  m_book.save("six");
  m_book.save("new");
  m_book.remove("six");
  m_book.setKeeping(true);
  EXPECT_TRUE(m_book.refresh().empty());
  ASSERT_EQ(m_book.recipes().size(), 1U);
  EXPECT_EQ(m_book.recipes().front().recipe, recipe::Recipe());
}

TEST_F(Book, SaysWhyItCannotSave) {
  ASSERT_TRUE(files::writeWholeFile(m_scratch / "recipes", "a file where the folder should be"));
  const base::Problems problems = m_book.save("six");
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems.front().code, base::Code::CannotWrite);
  EXPECT_EQ(m_book.current(), "");
}

TEST_F(Book, SuggestsANameThatCanBeOne) {
  EXPECT_EQ(m_book.suggestedName(), "12 mm, wheel R 75 mm");
  EXPECT_TRUE(files::isRecipeName(m_book.suggestedName().toStdString()));
}

} // namespace
} // namespace arris::ui
