#include "core/files/recipe_folder.h"
#include "core/files/whole_file.h"
#include "tests/support/dice.h"
#include "tests/support/scratch.h"

#include <gtest/gtest.h>

namespace arris::test {
namespace {

using files::NamedRecipe;
using files::NamedRecipes;

NamedRecipe named(std::string name, double thickness) {
  NamedRecipe recipe{std::move(name), {}};
  recipe.recipe.thickness = thickness;
  return recipe;
}

void keepAll(const std::filesystem::path& folder, const NamedRecipes& recipes) {
  for (const NamedRecipe& recipe : recipes) {
    ASSERT_TRUE(files::keepRecipe(folder, recipe)) << recipe.name;
  }
}

TEST(RecipeFolder, GivesBackWhatWasKeptByThicknessAndName) {
  const Scratch scratch;
  const std::filesystem::path folder = scratch / "recipes";
  const NamedRecipes recipes{named("b float", 4), named("ÄÖ 钢化玻璃", 8), named("a.b", 12), named("z", 12)};
  keepAll(folder, {recipes[3], recipes[0], recipes[2], recipes[1]});
  const auto read = files::readRecipes(folder);
  EXPECT_TRUE(read.problems.empty());
  EXPECT_EQ(read.value, recipes);
}

TEST(RecipeFolder, IsEmptyWhereThereIsNone) {
  const Scratch scratch;
  const auto read = files::readRecipes(scratch / "recipes");
  EXPECT_TRUE(read.value.empty());
  EXPECT_TRUE(read.problems.empty());
}

TEST(RecipeFolder, KeepsTheLatestOfAName) {
  const Scratch scratch;
  keepAll(scratch / "recipes", {named("float", 4), named("float", 6)});
  const auto read = files::readRecipes(scratch / "recipes");
  ASSERT_EQ(read.value.size(), 1U);
  EXPECT_DOUBLE_EQ(read.value.front().recipe.thickness, 6);
}

TEST(RecipeFolder, SetsADamagedOneAsideTellsItAndKeepsTheOthers) {
  const Scratch scratch;
  const std::filesystem::path folder = scratch / "recipes";
  keepAll(folder, {named("good", 4)});
  const std::string damaged = R"({"arris_recipe": 1, "feed_mm_min": -3})";
  ASSERT_TRUE(files::writeWholeFile(folder / "bad.json", damaged));
  auto read = files::readRecipes(folder);
  ASSERT_EQ(read.value.size(), 1U);
  EXPECT_EQ(read.value.front().name, "good");
  ASSERT_EQ(read.problems.size(), 2U);
  EXPECT_EQ(read.problems[0].code, base::Code::ValueOutOfRange);
  EXPECT_EQ(read.problems[1].code, base::Code::FileSetAside);
  EXPECT_EQ(files::readFile(folder / "bad.json.damaged"), damaged);
  EXPECT_TRUE(files::readRecipes(folder).problems.empty()) << "it is told once";
}

TEST(RecipeFolder, PassesOverWhatIsNoRecipeByItsName) {
  const Scratch scratch;
  const std::filesystem::path folder = scratch / "recipes";
  keepAll(folder, {named("good", 4)});
  ASSERT_TRUE(files::writeWholeFile(folder / "notes.txt", "?"));
  ASSERT_TRUE(files::writeWholeFile(folder / ".good.json", "?"));
  std::filesystem::create_directory(folder / "folder.json");
  const auto read = files::readRecipes(folder);
  EXPECT_EQ(read.value.size(), 1U);
  EXPECT_TRUE(read.problems.empty());
  EXPECT_EQ(files::readFile(folder / "notes.txt"), "?");
}

TEST(RecipeFolder, RemovesOneAndSaysWhereThereIsNone) {
  const Scratch scratch;
  const std::filesystem::path folder = scratch / "recipes";
  keepAll(folder, {named("a", 4), named("b", 4)});
  EXPECT_TRUE(files::removeRecipe(folder, "a"));
  const auto again = files::removeRecipe(folder, "a");
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().code, base::Code::CannotWrite);
  EXPECT_EQ(files::readRecipes(folder).value.size(), 1U);
}

TEST(RecipeFolder, TakesNoNameThatLeavesTheFolderOrHides) {
  for (const char* name : {"", ".", "..", "../a", "a/b", "a\\b", ".a", " a", "a ", "a\nb", "\x7f", "\xff"}) {
    EXPECT_FALSE(files::isRecipeName(name)) << name;
  }
  EXPECT_FALSE(files::isRecipeName(std::string(files::kLongestRecipeName + 1, 'a')));
}

// Whatever is typed: a name that is taken can be kept, found again under the same name, and removed.
TEST(RecipeFolder, AnyNameThatIsTakenIsKeptInTheFolder) {
  const Scratch scratch;
  const std::filesystem::path folder = scratch / "recipes";
  Dice dice(7);
  int kept = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string name;
    for (int length = static_cast<int>(dice.between(0, 13)); length > 0; --length) {
      const double byte = dice.chance(0.3) ? dice.between(1, 256) : dice.between('-', 'z');
      name += static_cast<char>(static_cast<int>(byte));
    }
    if (!files::isRecipeName(name)) {
      continue;
    }
    ++kept;
    ASSERT_TRUE(files::keepRecipe(folder, {name, {}})) << name;
    const auto read = files::readRecipes(folder);
    ASSERT_EQ(read.value.size(), 1U) << name;
    EXPECT_EQ(read.value.front().name, name);
    ASSERT_TRUE(files::removeRecipe(folder, name));
  }
  EXPECT_GT(kept, 300);
}

} // namespace
} // namespace arris::test
