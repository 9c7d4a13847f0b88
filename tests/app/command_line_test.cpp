#include "core/recipe/fields.h"
#include "tests/app/process.h"
#include "tests/support/scratch.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace arris::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr int kDone = 0;
constexpr int kWrongUsage = 2;
constexpr int kSystemFailure = 4;

TEST(CommandLine, TellsItsVersion) {
  const Outcome outcome = arris({"--version"});
  EXPECT_EQ(outcome.status, kDone);
  EXPECT_THAT(outcome.out, testing::MatchesRegex("Arris [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(CommandLine, HelpNamesEveryCall) {
  for (const auto& arguments : {std::vector<std::string>{"help"}, {"--help"}, {"-h"}, {"help", "help"}}) {
    const Outcome outcome = arris(arguments);
    EXPECT_EQ(outcome.status, kDone);
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("arris plan"), HasSubstr("arris inspect"), HasSubstr("arris plot"),
                                   HasSubstr("--version")));
  }
}

TEST(CommandLine, HelpForACallNamesEveryOptionWithItsRange) {
  const Outcome outcome = arris({"help", "plan"});
  EXPECT_EQ(outcome.status, kDone);
  for (const recipe::NumberField& field : recipe::numberFields()) {
    EXPECT_THAT(outcome.out, HasSubstr(fmt::format("--{} ", field.option)));
    EXPECT_THAT(outcome.out, HasSubstr(fmt::format("({} to {} {}, default", field.least, field.most, field.unit)));
  }
  for (const char* option : {"--acceleration-rule", "--direction", "--mirror", "--units", "--start", "--place",
                             "--layer", "--accept-unreached", "--recipe", "--machine", "--report", "--profile",
                             "--gcode", "--preview", "--plot", "--gcode-transition"}) {
    EXPECT_THAT(outcome.out, HasSubstr(option));
  }
  EXPECT_EQ(arris({"plan", "--help"}).out, outcome.out);
}

TEST(CommandLine, InspectOffersOnlyWhatConcernsTheDrawing) {
  const std::string help = arris({"help", "inspect"}).out;
  EXPECT_THAT(help, AllOf(HasSubstr("--units"), HasSubstr("--layer"), HasSubstr("--gap"), HasSubstr("--smooth")));
  EXPECT_THAT(help, AllOf(Not(HasSubstr("--feed")), Not(HasSubstr("--gcode"))));
}

TEST(CommandLine, WithoutADisplayTheWindowSaysInOneLineWhatToDo) {
  for (const auto& arguments : {std::vector<std::string>{}, {"pane.dxf"}}) {
    const Outcome outcome = arris(arguments);
    EXPECT_EQ(outcome.status, kSystemFailure);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("no display"), HasSubstr("arris plan"), testing::EndsWith("\n")));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
  }
}

TEST(CommandLine, ADisplayThatCannotBeReachedIsNoCrash) {
  const Outcome outcome = arris({}, {{"DISPLAY", ":987"}});
  EXPECT_EQ(outcome.status, kSystemFailure);
  EXPECT_THAT(outcome.err, HasSubstr("no display"));
}

TEST(CommandLine, TheWindowTakesTheAxesThatAreAskedFor) {
  for (const char* axes : {"simulated", "linuxcnc"}) {
    const Outcome outcome = arris({"--axes", axes});
    EXPECT_EQ(outcome.status, kSystemFailure);
    EXPECT_THAT(outcome.err, HasSubstr("no display")); // and nothing else is wrong
  }
}

struct Usage {
  const char* name;
  std::vector<std::string> arguments;
  const char* named; ///< what the complaint must name
};

void PrintTo(const Usage& usage, std::ostream* out) {
  *out << usage.name;
}

class WrongUsage : public testing::TestWithParam<Usage> {};

TEST_P(WrongUsage, IsNamedAndEndsWithTwo) {
  const Outcome outcome = arris(GetParam().arguments);
  EXPECT_EQ(outcome.status, kWrongUsage);
  EXPECT_THAT(outcome.err, HasSubstr(GetParam().named));
  EXPECT_THAT(outcome.out, IsEmpty());
}

const std::string kTriangle = sample("triangle.dxf");

INSTANTIATE_TEST_SUITE_P(
    Of, WrongUsage,
    testing::Values(Usage{"NoPattern", {"plan"}, "PATTERN"},
                    Usage{"TwoPatterns", {"plan", kTriangle, "b.dxf"}, "b.dxf"},
                    Usage{"EmptyName", {"plan", kTriangle, "--report", ""}, "empty"},
                    Usage{"UnknownOption", {"plan", kTriangle, "--fed", "3"}, "--fed"},
                    Usage{"NoValue", {"plan", kTriangle, "--feed"}, "--feed"},
                    Usage{"OptionTwice", {"plan", kTriangle, "--feed", "100", "--feed", "200"}, "--feed"},
                    Usage{"OptionOfAnotherCall", {"inspect", kTriangle, "--feed", "100"}, "--feed"},
                    Usage{"UnknownRule", {"plan", kTriangle, "--acceleration-rule", "fast"}, "per-axis, combined"},
                    Usage{"UnknownUnit", {"plan", kTriangle, "--units", "mile"}, "mm, cm, m, inch, foot"},
                    Usage{"UnknownTransition", {"plan", kTriangle, "--gcode-transition", "nurbs"}, "nurbs"},
                    Usage{"PlaceWithoutY", {"plan", kTriangle, "--place", "100"}, "--place"},
                    Usage{"PlaceNaN", {"plan", kTriangle, "--place", "100,nan"}, "--place"},
                    Usage{"PlaceFarOff", {"plan", kTriangle, "--place", "1e9,0"}, "--place"},
                    Usage{"StartWithBlank", {"plan", kTriangle, "--start", "1, 2"}, "--start"},
                    Usage{"AboveTheMachine", {"plan", kTriangle, "--accel-x", "501"}, "--accel-x"},
                    Usage{"UnknownAxes", {"pane.dxf", "--axes", "real"}, "--axes"},
                    Usage{"UnknownHelp", {"help", "grind"}, "grind"},
                    Usage{"PictureKind", {"plan", kTriangle, "--preview", "a.jpg"}, "--preview"},
                    Usage{"PlotKind", {"plan", kTriangle, "--plot", "plot"}, "--plot"},
                    Usage{"OverTheInput", {"plan", kTriangle, "--gcode", kTriangle}, "--gcode"},
                    Usage{
                        "TwoOutputsInOne", {"plan", kTriangle, "--gcode", "/tmp/x", "--report", "/tmp/x"}, "--gcode"}),
    [](const auto& test) { return std::string(test.param.name); });

class EveryNumberOption : public testing::TestWithParam<recipe::NumberField> {};

void expectRefused(const recipe::NumberField& field, const std::string& value) {
  const std::string option = fmt::format("--{}", field.option);
  const Outcome outcome = arris({"plan", kTriangle, option, value});
  EXPECT_EQ(outcome.status, kWrongUsage) << option << ' ' << value;
  EXPECT_THAT(outcome.err, AllOf(HasSubstr(option), HasSubstr(value), HasSubstr(fmt::format("{}", field.least)),
                                 HasSubstr(fmt::format("{}", field.most)), HasSubstr(std::string(field.unit))));
  EXPECT_THAT(outcome.out, IsEmpty());
}

TEST_P(EveryNumberOption, RefusesWhatIsNoFiniteNumberAndNamesOptionValueAndRange) {
  for (const char* value : {"12abc", "3,600", "nan", "inf", "-inf", "1e999"}) {
    expectRefused(GetParam(), value);
  }
}

TEST(NumberOption, TakesTheWholeTextOrNothing) {
  for (const char* value : {"", "abc", "1.5.2", " 5", "5 ", "+5", "0x10", "5mm", "5,0", "--depth"}) {
    expectRefused(recipe::numberFields().front(), value);
  }
}

TEST_P(EveryNumberOption, RefusesWhatIsOutsideItsRangeAndNamesOptionValueAndRange) {
  const recipe::NumberField& field = GetParam();
  for (const double value : {-1e300, -1e9, field.least - 0.25, field.most + 0.25, 1e9, 1e300}) {
    expectRefused(field, fmt::format("{}", value));
  }
  if (field.least > 0) {
    expectRefused(field, "0");
  }
}

INSTANTIATE_TEST_SUITE_P(Of, EveryNumberOption,
                         testing::ValuesIn(recipe::numberFields().begin(), recipe::numberFields().end()),
                         [](const auto& test) {
                           std::string name(test.param.key);
                           std::replace(name.begin(), name.end(), '_', 'X');
                           return name;
                         });

} // namespace
} // namespace arris::test
