// The recipe on the page Job: every value has a field, undo and redo, recipes that have names.

#include "core/files/whole_file.h"
#include "core/recipe/fields.h"
#include "tests/ui/support/artefacts.h"
#include "tests/ui/support/locales.h"
#include "tests/ui/support/steps.h"
#include "ui/main_window.h"
#include "ui/pages/job_page.h"
#include "ui/pages/recipe_dialog.h"
#include "ui/pages/recipe_panel.h"
#include "ui/widgets/number_edit.h"
#include "ui/widgets/theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QTableView>
#include <QTest>

#include <gtest/gtest.h>

#include <set>

namespace arris::ui {
namespace {

class RecipeWindow : public testing::Test {
protected:
  RecipeWindow() : m_window(test::fastMachine(m_scratch), test::paneSteps()) {
    m_window.resize(1024, 700);
    m_window.show();
    m_window.openPattern("splashback.dxf");
    settle();
  }

  void settle() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return !m_window.planner().isBusy(); }, test::kPatience));
    for (int i = 0; i < 5; ++i) { // layouts settle in turns
      QTest::qWait(1);
    }
  }

  template <typename T = QAbstractButton> T* find(const char* name) {
    return m_window.findChild<JobPage*>()->findChild<T*>(QString::fromLatin1(name));
  }

  void tap(const char* name) {
    ASSERT_TRUE(find(name) != nullptr) << name;
    ASSERT_TRUE(find(name)->isEnabled()) << name;
    QTest::mouseClick(find(name), Qt::LeftButton, {}, QPoint(14, 22));
    settle();
  }

  void type(const char* name, const char* text) {
    auto* line = find<QLineEdit>(name);
    ASSERT_TRUE(line != nullptr) << name;
    ASSERT_TRUE(line->isVisible()) << name;
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, QString::fromUtf8(text));
    settle();
  }

  void choose(const char* name, int index) {
    auto* box = find<QComboBox>(name);
    ASSERT_TRUE(box != nullptr && box->isVisible()) << name;
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Home);
    for (int i = 0; i < index; ++i) {
      QTest::keyClick(box, Qt::Key_Down);
    }
    settle();
  }

  void turnTo(const char* heading) {
    tap("showMore");
    for (int pages = 0; pages < 5 && text("moreHeading") != QString::fromLatin1(heading); ++pages) {
      tap("moreOn");
    }
    ASSERT_EQ(text("moreHeading"), heading);
  }

  QString text(const char* label) {
    return find<QLabel>(label)->text();
  }

  const recipe::Recipe& recipe() {
    return m_window.planner().recipe();
  }

  RecipeDialog* dialog() {
    return m_window.findChild<RecipeDialog*>();
  }

  void openDialog() {
    tap("recipes");
    ASSERT_TRUE(dialog() != nullptr);
  }

  void saveAs(const char* name) {
    type("newRecipe", name);
    tap("recipeSave");
  }

  void chooseRow(int row) {
    auto* table = find<QTableView>("recipeTable");
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, table->visualRect(table->model()->index(row, 0)).center());
  }

  test::Scratch m_scratch;
  MainWindow m_window;
};

// Each field is found on its page, and what is typed there reaches the plan.
TEST_F(RecipeWindow, HasAFieldForEveryNumber) {
  std::set<std::string_view> reached;
  const auto visit = [&] {
    for (const recipe::NumberField& field : recipe::numberFields()) {
      NumberEdit* edit = m_window.findChild<RecipePanel*>()->field(field.key);
      ASSERT_TRUE(edit != nullptr) << field.key;
      if (edit->isVisible()) {
        reached.insert(field.key);
        const double half = (edit->value() + edit->spec().most) / 2;
        edit->line()->setText(QString::number(half, 'f', 3));
        EXPECT_NEAR(recipe().*field.member, half, 1e-3) << field.key;
      }
    }
  };
  tap("showGrinding");
  visit();
  tap("showPane");
  visit();
  tap("showMore");
  for (int page = 0; page < 5; ++page) {
    visit();
    tap("moreOn");
  }
  EXPECT_EQ(reached.size(), recipe::numberFields().size());
}

TEST_F(RecipeWindow, TakesEveryChoice) {
  turnTo("Corners");
  choose("acceleration_rule", 1);
  EXPECT_EQ(recipe().accelerationRule, recipe::AccelerationRule::Combined);
  turnTo("On the table");
  choose("mirror", 2);
  EXPECT_EQ(recipe().mirror, recipe::Mirror::Y);
  turnTo("Start");
  choose("direction", 1);
  EXPECT_EQ(recipe().direction, recipe::Direction::CounterClockwise);
  turnTo("Drawing");
  choose("units", 4);
  EXPECT_EQ(recipe().units, recipe::Units::Inch);
  choose("units", 0);
  EXPECT_EQ(recipe().units, std::nullopt);
}

TEST_F(RecipeWindow, BeginsAPlaceWhereThePaneIs) {
  m_window.openPattern("rectangle.dxf"); // 1000 × 600 on a table of 1500 × 2500
  settle();
  turnTo("On the table");
  tap("place_mm");
  ASSERT_TRUE(recipe().place);
  EXPECT_EQ(*recipe().place, Eigen::Vector2d(250, 950));
  type("place_mmX", "100,5");
  EXPECT_EQ(*recipe().place, Eigen::Vector2d(100.5, 950));
  type("place_mmX", "1,000");
  EXPECT_EQ(*recipe().place, Eigen::Vector2d(1, 950)) << "as far as it meant one thing";
  EXPECT_TRUE(text("complaint").contains("can mean"));
  tap("place_mm");
  EXPECT_EQ(recipe().place, std::nullopt);
}

TEST_F(RecipeWindow, ChoosesAmongTheLayersOfTheDrawing) {
  turnTo("Drawing");
  auto* layer = find<QScrollArea>("layers")->findChild<QCheckBox*>();
  ASSERT_TRUE(layer != nullptr);
  EXPECT_GE(layer->height(), kTouch);
  test::keep("recipe-layers", m_window);
  QTest::mouseClick(layer, Qt::LeftButton, {}, QPoint(14, 22));
  settle();
  EXPECT_EQ(recipe().layers, std::vector{layer->text().toStdString()});
  QTest::mouseClick(layer, Qt::LeftButton, {}, QPoint(14, 22));
  settle();
  EXPECT_TRUE(recipe().layers.empty());
}

TEST_F(RecipeWindow, UndoesAndRedoesByTapsAndKeys) {
  EXPECT_FALSE(find("undo")->isEnabled());
  type("feed_mm_min", "1800");
  type("depth_mm", "0.2");
  tap("undo");
  EXPECT_DOUBLE_EQ(recipe().depth, 0.13);
  EXPECT_EQ(find<QLineEdit>("depth_mm")->text(), "0.13");
  tap("undo");
  EXPECT_DOUBLE_EQ(recipe().feed, 3600);
  EXPECT_FALSE(find("undo")->isEnabled());
  tap("redo");
  EXPECT_DOUBLE_EQ(recipe().feed, 1800);
  EXPECT_DOUBLE_EQ(m_window.planner().plan()->job.recipe.feed, 1800) << "the drawing follows";
}

TEST_F(RecipeWindow, UndoesFirstWhatCannotBeTaken) {
  type("depth_mm", "0.2");
  type("depth_mm", "?");
  tap("undo");
  EXPECT_EQ(find<QLineEdit>("depth_mm")->text(), "0.2");
  EXPECT_DOUBLE_EQ(recipe().depth, 0.2);
}

// Undo must not bring back accelerations that a code protects by now.
TEST_F(RecipeWindow, ForgetsTheStepsWhenTheTechnologistsValuesAreLocked) {
  m_window.preferences().setCode(QStringLiteral("1234"));
  type("accel_x_mm_s2", "90");
  m_window.preferences().lock();
  EXPECT_FALSE(find("undo")->isEnabled());
  EXPECT_FALSE(find<QLineEdit>("accel_x_mm_s2")->isEnabled());
  turnTo("Corners");
  EXPECT_FALSE(find<QLineEdit>("corner_speed_percent")->isEnabled());
  EXPECT_FALSE(find<QComboBox>("acceleration_rule")->isEnabled());
  openDialog();
  EXPECT_FALSE(find("recipeSave")->isEnabled());
  EXPECT_FALSE(find("recipeImport")->isEnabled());
}

TEST_F(RecipeWindow, SavesARecipeUnderANameAndLoadsIt) {
  EXPECT_EQ(find<QLabel>("recipeName")->toolTip(), "Unnamed recipe");
  type("thickness_mm", "6");
  openDialog();
  EXPECT_EQ(find<QLineEdit>("newRecipe")->text(), "6 mm, wheel R 75 mm");
  tap("recipeSave");
  EXPECT_EQ(find<QLabel>("recipeMessage")->text(), "Saved as “6 mm, wheel R 75 mm”.");
  type("feed_mm_min", "1800"); // the dialog leaves the page in reach
  EXPECT_EQ(find<QLabel>("recipeName")->toolTip(), "6 mm, wheel R 75 mm, changed");
  chooseRow(0);
  tap("recipeLoad");
  EXPECT_DOUBLE_EQ(recipe().feed, 3600);
  EXPECT_EQ(find<QLineEdit>("feed_mm_min")->text(), "3600");
  test::keep("recipe-dialog", *dialog());
  tap("recipeClose");
  test::keep("recipe-loaded", m_window);
  tap("undo");
  EXPECT_DOUBLE_EQ(recipe().feed, 1800) << "loading is a step too";
}

TEST_F(RecipeWindow, AsksBeforeARecipeIsReplacedOrDeleted) {
  openDialog();
  saveAs("float");
  type("feed_mm_min", "1800");
  tap("recipeSave");
  EXPECT_TRUE(find<QLabel>("recipeMessage")->text().startsWith("Replace “float”"));
  EXPECT_FALSE(find("recipeSave")->isEnabled());
  tap("recipeNo");
  chooseRow(0);
  tap("recipeLoad");
  EXPECT_DOUBLE_EQ(recipe().feed, 3600) << "nothing was replaced";
  tap("recipeDelete");
  tap("recipeNo");
  EXPECT_EQ(find<QTableView>("recipeTable")->model()->rowCount(), 1);
  tap("recipeDelete");
  tap("recipeYes");
  EXPECT_EQ(find<QTableView>("recipeTable")->model()->rowCount(), 0);
}

TEST_F(RecipeWindow, ShowsTheRecipesForTheGlassThatIsSet) {
  openDialog();
  const auto message = [this] { return find<QLabel>("recipeMessage")->text(); };
  EXPECT_EQ(message(), "No recipe has been saved yet.");
  for (const char* thickness : {"6", "8", "10"}) {
    type("thickness_mm", thickness);
    saveAs(thickness);
  }
  EXPECT_EQ(find<QTableView>("recipeTable")->model()->rowCount(), 3);
  tap("recipesOfGlass");
  ASSERT_EQ(find<QTableView>("recipeTable")->model()->rowCount(), 1);
  EXPECT_EQ(find<QTableView>("recipeTable")->model()->index(0, 0).data().toString(), "10");
  tap("recipesAll");
  type("thickness_mm", "12");
  tap("recipesOfGlass");
  EXPECT_NE(message(), "No recipe has been saved yet.");
  EXPECT_EQ(find<QTableView>("recipeTable")->model()->rowCount(), 0);
}

TEST_F(RecipeWindow, TakesNoNameThatIsNone) {
  openDialog();
  for (const char* name : {"", " ", "a/b", ".x"}) {
    find<QLineEdit>("newRecipe")->setText(QString::fromUtf8(name));
    EXPECT_FALSE(find("recipeSave")->isEnabled()) << name;
  }
}

// A damaged recipe of the folder neither stops the program nor hides the others.
TEST(DamagedRecipe, IsSetAsideAndTold) {
  const test::Scratch scratch;
  const std::filesystem::path recipes = scratch / "state" / "recipes";
  std::filesystem::create_directories(recipes);
  ASSERT_TRUE(files::writeWholeFile(recipes / "bad.json", "{"));
  MainWindow window(test::fastMachine(scratch), test::paneSteps());
  EXPECT_TRUE(std::filesystem::exists(recipes / "bad.json.damaged"));
  ASSERT_TRUE(window.machine().complaint());
  EXPECT_EQ(window.machine().complaint()->code, base::Code::FileSetAside);
}

class TranslatedRecipes : public testing::WithParamInterface<std::string>, public test::Language, public RecipeWindow {
protected:
  TranslatedRecipes() : Language(GetParam()) {}
};

TEST_P(TranslatedRecipes, ShowEverythingOnTheSmallestScreen) {
  for (const char* page : {"showGrinding", "showPane", "showMore"}) {
    tap(page);
    test::expectNothingCutOff(m_window);
  }
  for (int page = 0; page < 5; ++page) {
    test::expectNothingCutOff(m_window);
    EXPECT_EQ(m_window.size(), QSize(1024, 700));
    test::keep("recipe-" + GetParam() + "-more" + std::to_string(page), m_window);
    tap("moreOn");
  }
  openDialog();
  saveAs("a longer name, float glass");
  tap("recipeDelete");
  settle();
  test::expectNothingCutOff(*dialog());
  test::keep("recipe-" + GetParam() + "-dialog", *dialog());
}

INSTANTIATE_TEST_SUITE_P(Languages, TranslatedRecipes, testing::ValuesIn([] {
                           auto all = test::languages();
                           all.emplace_back("en");
                           return all;
                         }()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace arris::ui
