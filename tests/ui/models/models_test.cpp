#include "tests/support/panes.h"
#include "ui/models/corner_model.h"
#include "ui/models/problem_model.h"
#include "ui/models/recipe_model.h"
#include "ui/models/time_model.h"
#include "ui/text/quantities.h"

#include <QAbstractItemModelTester>

#include <gtest/gtest.h>

namespace arris::ui {
namespace {

PlanPointer planOf(const pattern::Pattern& pattern, const recipe::Recipe& recipe = {}) {
  auto plan = std::make_shared<Plan>();
  plan->import = std::make_shared<const Import>(Import{"pane.dxf", {}, pattern, {}});
  plan->job = job::planJob(pattern, recipe, recipe::Machine{});
  plan->drawing = drawingOf(plan->job, pattern);
  return plan;
}

std::string cell(const QAbstractItemModel& model, int row, int column) {
  return model.index(row, column).data().toString().toStdString();
}

TEST(CornerModel, ShowsTheFiguresOfThePaper) {
  CornerModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  model.setPlan(planOf(test::triangle600()));
  ASSERT_EQ(model.rowCount(), 3);
  EXPECT_EQ(cell(model, 2, CornerModel::Number), "3");
  EXPECT_EQ(cell(model, 2, CornerModel::Angle), "60°");
  EXPECT_EQ(cell(model, 2, CornerModel::Treatment), "transition");
  EXPECT_EQ(cell(model, 2, CornerModel::Speed), "20.0");
  EXPECT_EQ(cell(model, 2, CornerModel::Acceleration), "1.54");
  EXPECT_EQ(cell(model, 2, CornerModel::Time), "12.99");
  EXPECT_EQ(cell(model, 2, CornerModel::Widest), "93.75");
  EXPECT_EQ(cell(model, 2, CornerModel::Relief), "+18.49"); // 93.75 − 75.26
}

TEST(CornerModel, ShowsInchesWhereTheWindowDoes) {
  CornerModel model;
  model.setPlan(planOf(test::triangle600()));
  showLengthsIn(LengthUnit::Inch);
  EXPECT_EQ(cell(model, 2, CornerModel::Speed), "0.79"); // 20 mm/s
  EXPECT_EQ(cell(model, 2, CornerModel::Time), "12.99");
  EXPECT_EQ(cell(model, 2, CornerModel::Widest), "3.691");
  EXPECT_EQ(cell(model, 2, CornerModel::Relief), "+0.728");
  EXPECT_EQ(model.headerData(CornerModel::Acceleration, Qt::Horizontal).toString().section('\n', 1), "in/s²");
  showLengthsIn(LengthUnit::Millimetre);
}

TEST(CornerModel, HasNoTransitionFiguresForARoll) {
  CornerModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  model.setPlan(planOf(test::polygon({{0, 0}, {500, 0}, {1000, 60}, {1000, 600}, {0, 600}})));
  int rolls = 0;
  for (int row = 0; row < model.rowCount(); ++row) {
    if (cell(model, row, CornerModel::Treatment) == "roll") {
      ++rolls;
      EXPECT_EQ(cell(model, row, CornerModel::Speed), "–");
      EXPECT_EQ(cell(model, row, CornerModel::Relief), "–");
    }
  }
  EXPECT_EQ(rolls, 1);
}

TEST(CornerModel, HasNoFiguresOfReliefForAConcaveCorner) {
  CornerModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  model.setPlan(planOf(test::polygon({{0, 0}, {1000, 0}, {1000, 400}, {600, 400}, {600, 800}, {0, 800}})));
  int stops = 0;
  for (int row = 0; row < model.rowCount(); ++row) {
    if (cell(model, row, CornerModel::Treatment) == "exact stop") {
      ++stops;
      EXPECT_EQ(cell(model, row, CornerModel::Angle), "270°");
      for (const int column : {CornerModel::Speed, CornerModel::Widest, CornerModel::Relief}) {
        EXPECT_EQ(cell(model, row, column), "–");
      }
    }
  }
  EXPECT_EQ(stops, 1);
}

TEST(CornerModel, MarksACornerWithoutReliefBySignAndNumber) {
  recipe::Recipe deep;
  deep.depth = 5;
  CornerModel model;
  model.setPlan(planOf(test::polygon({{0, 0}, {800, 0}, {800, 600}, {0, 600}}), deep));
  const QModelIndex relief = model.index(0, CornerModel::Relief);
  EXPECT_FALSE(relief.data(Qt::DecorationRole).isNull());
  EXPECT_TRUE(relief.data().toString().startsWith('-'));
}

TEST(CornerModel, EmptiesWithItsPlan) {
  CornerModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  model.setPlan(planOf(test::triangle600()));
  model.setPlan(nullptr);
  EXPECT_EQ(model.rowCount(), 0);
}

TEST(ProblemModel, ShowsTheWorstFirstInWordsWithThePlace) {
  ProblemModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  pattern::Pattern pattern = test::polygon({{0, 0}, {1450, 0}, {1450, 700}}); // wider than the travel with the wheel
  pattern.repairs.push_back(base::Problem(base::Code::GapClosed, {{"size_mm", 0.02}}).at({1450, 0}));
  const PlanPointer plan = planOf(pattern);
  model.setPlan(plan);
  ASSERT_GE(model.rowCount(), 2);
  EXPECT_GT(model.count(base::Severity::Error), 0);
  EXPECT_EQ(base::severityOf(model.problem(0)), base::Severity::Error);
  EXPECT_TRUE(QString::fromStdString(cell(model, 0, 0)).startsWith("Error: "));
  EXPECT_NE(cell(model, 0, 0).find("(at\u00a0X\u00a0"), std::string::npos);
  EXPECT_EQ(model.problem(model.rowCount() - 1).code, base::Code::GapClosed);
  EXPECT_TRUE(QString::fromStdString(cell(model, model.rowCount() - 1, 0)).startsWith("Repaired: A gap of"));
  for (int row = 0; row < model.rowCount(); ++row) {
    EXPECT_EQ(model.rowOf(model.problem(row)), row);
  }
  EXPECT_EQ(model.rowOf(base::Problem(base::Code::NoContour)), -1);
  // The repair's place is on the table like all others.
  EXPECT_TRUE(
      model.problem(model.rowCount() - 1).where->isApprox(plan->job.placement.motion * geometry::Point(1450, 0)));
}

TEST(TimeModel, SumsUpToTheWholeProgram) {
  TimeModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  const PlanPointer plan = planOf(test::triangle600());
  model.setPlan(plan);
  double sum = 0;
  for (const double seconds : plan->job.byPhase) {
    sum += seconds;
  }
  EXPECT_NEAR(sum, plan->job.duration, 1e-9);
  const int last = model.rowCount() - 1;
  EXPECT_EQ(cell(model, last, TimeModel::What), "Whole program");
  EXPECT_EQ(cell(model, last, TimeModel::Share), "100\u00a0%");
}

TEST(RecipeModel, ShowsNamesWithWhatTellsRecipesApart) {
  RecipeModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  recipe::Recipe thin;
  thin.thickness = 3.5;
  thin.depth = 0.125;
  model.setRecipes({{"thin", thin}, {"thick", {}}});
  EXPECT_EQ(model.rowCount(), 2);
  EXPECT_EQ(cell(model, 0, RecipeModel::Name), "thin");
  EXPECT_EQ(cell(model, 0, RecipeModel::Thickness), "3.5");
  EXPECT_EQ(cell(model, 0, RecipeModel::Depth), "0.125");
  EXPECT_EQ(model.rowOf("thick"), 1);
  EXPECT_EQ(model.rowOf("other"), -1);
  model.setRecipes({});
  EXPECT_EQ(model.rowCount(), 0);
}

TEST(TimeModel, IsEmptyWhereNothingCanBeGround) {
  TimeModel model;
  const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  model.setPlan(planOf(test::polygon({{0, 0}, {1450, 0}, {1450, 700}})));
  EXPECT_EQ(model.rowCount(), 0);
}

} // namespace
} // namespace arris::ui
