#include "tests/ui/support/locales.h"
#include "ui/text/number_input.h"

#include <gtest/gtest.h>

#include <ostream>

namespace arris::ui {

void PrintTo(NumberInput::Kind kind, std::ostream* out) {
  *out << static_cast<int>(kind);
}

namespace {

using Kind = NumberInput::Kind;

const QLocale kFrench(QLocale::French, QLocale::France);

struct Case {
  const char* name;
  const char* text;
  QLocale locale;
  Kind kind;
  double value;
  double grouped = 0;
};

class NumberInputTable : public testing::TestWithParam<Case> {};

TEST_P(NumberInputTable, IsRead) {
  const Case& row = GetParam();
  const NumberInput input = readNumber(QString::fromUtf8(row.text), row.locale);
  EXPECT_EQ(input.kind, row.kind);
  EXPECT_DOUBLE_EQ(input.value, row.value);
  EXPECT_DOUBLE_EQ(input.grouped, row.grouped);
}

INSTANTIATE_TEST_SUITE_P(
    Rows, NumberInputTable,
    testing::Values(Case{"Whole", "75", test::kEnglish, Kind::Number, 75},
                    Case{"PointInEnglish", "0.13", test::kEnglish, Kind::Number, 0.13},
                    Case{"CommaInEnglish", "0,13", test::kEnglish, Kind::Number, 0.13},
                    Case{"PointInGerman", "0.13", test::kGerman, Kind::Number, 0.13},
                    Case{"CommaInGerman", "0,13", test::kGerman, Kind::Number, 0.13},
                    Case{"WithoutLeadingZero", ",5", test::kGerman, Kind::Number, 0.5},
                    Case{"WithoutDecimals", "12.", test::kEnglish, Kind::Number, 12},
                    Case{"BlanksAround", " 20 ", test::kEnglish, Kind::Number, 20},
                    Case{"Negative", "-1.5", test::kEnglish, Kind::Number, -1.5},
                    Case{"TypographicMinus", "−1,5", test::kGerman, Kind::Number, -1.5},
                    Case{"ThreeDecimalsThatNobodyGroups", "0.130", test::kGerman, Kind::Number, 0.13},
                    Case{"DecimalCommaWithThreeDecimalsInGerman", "3,600", test::kGerman, Kind::Number, 3.6},
                    Case{"DecimalPointWithThreeDecimalsInEnglish", "3.600", test::kEnglish, Kind::Number, 3.6},
                    Case{"NoGroupingByPointInFrench", "3.600", kFrench, Kind::Number, 3.6},
                    Case{"PerhapsGroupedInGerman", "3.600", test::kGerman, Kind::Ambiguous, 3.6, 3600},
                    Case{"PerhapsGroupedInEnglish", "3,600", test::kEnglish, Kind::Ambiguous, 3.6, 3600},
                    Case{"Grouped", "1,234,567", test::kEnglish, Kind::NotANumber, 0},
                    Case{"GroupedWithDecimals", "1.234,5", test::kGerman, Kind::NotANumber, 0},
                    Case{"GroupedByBlanks", "3 600", kFrench, Kind::NotANumber, 0},
                    Case{"Empty", "", test::kEnglish, Kind::Empty, 0},
                    Case{"Blank", "  ", test::kEnglish, Kind::Empty, 0},
                    Case{"Word", "abc", test::kEnglish, Kind::NotANumber, 0},
                    Case{"NotANumber", "nan", test::kEnglish, Kind::NotANumber, 0},
                    Case{"Infinite", "inf", test::kEnglish, Kind::NotANumber, 0},
                    Case{"Exponent", "1e3", test::kEnglish, Kind::NotANumber, 0},
                    Case{"SignAlone", "-", test::kEnglish, Kind::NotANumber, 0},
                    Case{"PointAlone", ".", test::kEnglish, Kind::NotANumber, 0},
                    Case{"TwoSigns", "--1", test::kEnglish, Kind::NotANumber, 0}),
    [](const testing::TestParamInfo<Case>& row) { return std::string(row.param.name); });

} // namespace
} // namespace arris::ui
