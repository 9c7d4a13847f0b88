#include "ui/text/number_input.h"

#include <gtest/gtest.h>

#include <ostream>

namespace arris::ui {

void PrintTo(NumberInput::Kind kind, std::ostream* out) {
  *out << static_cast<int>(kind);
}

namespace {

using Kind = NumberInput::Kind;

const QLocale kEnglish(QLocale::English, QLocale::UnitedStates);
const QLocale kGerman(QLocale::German, QLocale::Germany);
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
    testing::Values(
        Case{"Whole", "75", kEnglish, Kind::Number, 75}, Case{"PointInEnglish", "0.13", kEnglish, Kind::Number, 0.13},
        Case{"CommaInEnglish", "0,13", kEnglish, Kind::Number, 0.13},
        Case{"PointInGerman", "0.13", kGerman, Kind::Number, 0.13},
        Case{"CommaInGerman", "0,13", kGerman, Kind::Number, 0.13},
        Case{"WithoutLeadingZero", ",5", kGerman, Kind::Number, 0.5},
        Case{"WithoutDecimals", "12.", kEnglish, Kind::Number, 12},
        Case{"BlanksAround", " 20 ", kEnglish, Kind::Number, 20},
        Case{"Negative", "-1.5", kEnglish, Kind::Number, -1.5},
        Case{"TypographicMinus", "−1,5", kGerman, Kind::Number, -1.5},
        Case{"ThreeDecimalsThatNobodyGroups", "0.130", kGerman, Kind::Number, 0.13},
        Case{"DecimalCommaWithThreeDecimalsInGerman", "3,600", kGerman, Kind::Number, 3.6},
        Case{"DecimalPointWithThreeDecimalsInEnglish", "3.600", kEnglish, Kind::Number, 3.6},
        Case{"NoGroupingByPointInFrench", "3.600", kFrench, Kind::Number, 3.6},
        Case{"PerhapsGroupedInGerman", "3.600", kGerman, Kind::Ambiguous, 3.6, 3600},
        Case{"PerhapsGroupedInEnglish", "3,600", kEnglish, Kind::Ambiguous, 3.6, 3600},
        Case{"Grouped", "1,234,567", kEnglish, Kind::NotANumber, 0},
        Case{"GroupedWithDecimals", "1.234,5", kGerman, Kind::NotANumber, 0},
        Case{"GroupedByBlanks", "3 600", kFrench, Kind::NotANumber, 0}, Case{"Empty", "", kEnglish, Kind::Empty, 0},
        Case{"Blank", "  ", kEnglish, Kind::Empty, 0}, Case{"Word", "abc", kEnglish, Kind::NotANumber, 0},
        Case{"NotANumber", "nan", kEnglish, Kind::NotANumber, 0},
        Case{"Infinite", "inf", kEnglish, Kind::NotANumber, 0}, Case{"Exponent", "1e3", kEnglish, Kind::NotANumber, 0},
        Case{"SignAlone", "-", kEnglish, Kind::NotANumber, 0}, Case{"PointAlone", ".", kEnglish, Kind::NotANumber, 0},
        Case{"TwoSigns", "--1", kEnglish, Kind::NotANumber, 0}),
    [](const testing::TestParamInfo<Case>& row) { return std::string(row.param.name); });

} // namespace
} // namespace arris::ui
