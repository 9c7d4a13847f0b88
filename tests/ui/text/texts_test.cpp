#include "core/base/numbers.h"
#include "tests/ui/support/locales.h"
#include "ui/text/job_texts.h"
#include "ui/text/problem_texts.h"
#include "ui/text/quantities.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string_view>

namespace arris::ui {
namespace {

TEST(ProblemTexts, AreTheTemplatesOfCoreInTheSameOrder) {
  ASSERT_EQ(problemTemplates().size(), base::allCodes().size());
  for (std::size_t i = 0; i < problemTemplates().size(); ++i) {
    EXPECT_EQ(problemTemplates()[i], base::allCodes()[i].text) << base::allCodes()[i].name;
  }
}

TEST(ProblemTexts, HaveTheirNumbersInTheOperatorsLocale) {
  const base::Problem gap(base::Code::OpenChain, {{"gap_mm", 1234.5}, {"tolerance_mm", 0.05}});
  EXPECT_EQ(problemText(gap, QLocale::c()).toStdString(), base::describe(gap));
  EXPECT_TRUE(problemText(gap, test::kGerman).contains(QStringLiteral("1234,5 mm")));
}

TEST(ProblemTexts, DoNotTakeBracesInAFileForNames) {
  const base::Problem problem(base::Code::DxfNumber,
                              {{"group", std::int64_t{10}}, {"found", std::string("{group} {found}")}});
  EXPECT_EQ(problemText(problem, QLocale::c()).toStdString(), base::describe(problem));
}

TEST(FieldTexts, CoverEveryFieldOfTheRecipe) {
  for (const recipe::NumberField& field : recipe::numberFields()) {
    EXPECT_TRUE(std::any_of(fieldNames().begin(), fieldNames().end(), [&](const char* name) {
      return field.what == name;
    })) << field.key;
    EXPECT_FALSE(fieldText(field).isEmpty());
  }
}

TEST(FieldTexts, CoverEveryFieldOfTheMachine) {
  std::set<std::string_view> names;
  for (const auto& field : recipe::machineNumberFields()) {
    names.insert(field.what);
  }
  for (const auto& field : recipe::machineAxesFields()) {
    names.insert(field.what);
  }
  for (const auto& field : recipe::machineFlagFields()) {
    names.insert(field.what);
  }
  EXPECT_EQ(std::set<std::string_view>(machineFieldNames().begin(), machineFieldNames().end()), names);
}

TEST(Quantities, AreShortAndNeverGrouped) {
  EXPECT_EQ(numberText(75, 3, test::kEnglish), QStringLiteral("75"));
  EXPECT_EQ(numberText(0.13, 6, test::kGerman), QStringLiteral("0,13"));
  EXPECT_EQ(numberText(60000, 2, test::kEnglish), QStringLiteral("60000"));
  EXPECT_EQ(numberText(1200, 0, test::kEnglish), QStringLiteral("1200"));
  EXPECT_EQ(fixedText(12345.678, 1, test::kGerman), QStringLiteral("12345,7"));
  EXPECT_EQ(fixedText(-0.0001, 2, test::kEnglish), QStringLiteral("0.00"));
}

TEST(Quantities, AnglesHaveAtMostOneDecimal) {
  EXPECT_EQ(angleText(base::radians(60), test::kEnglish), QStringLiteral("60°"));
  EXPECT_EQ(angleText(base::radians(89.46), test::kGerman), QStringLiteral("89,5°"));
}

TEST(Quantities, DurationsNeverShowSixtySeconds) {
  EXPECT_EQ(durationText(12.34, test::kEnglish), QStringLiteral("12.3 s"));
  EXPECT_EQ(durationText(59.96, test::kEnglish), QStringLiteral("1 min 0.0 s"));
  EXPECT_EQ(durationText(75.614, test::kEnglish), QStringLiteral("1 min 15.6 s"));
  EXPECT_EQ(durationText(119.97, test::kEnglish), QStringLiteral("2 min 0.0 s"));
  EXPECT_EQ(durationText(3599.97, test::kEnglish), QStringLiteral("1 h 00 min"));
  EXPECT_EQ(durationText(7500, test::kEnglish), QStringLiteral("2 h 05 min"));
}

} // namespace
} // namespace arris::ui
