#include "tests/app/process.h"
#include "tests/support/scratch.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace arris::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::StartsWith;

namespace fs = std::filesystem;

std::vector<std::string> planWithAllOutputs(const std::string& pattern, const Scratch& scratch) {
  return {"plan",      pattern,
          "--report",  (scratch / "r.json").string(),
          "--profile", (scratch / "p.csv").string(),
          "--gcode",   (scratch / "g.ngc").string(),
          "--preview", (scratch / "v.svg").string(),
          "--plot",    (scratch / "t.pdf").string()};
}

std::vector<std::string> contentsOf(const Scratch& scratch) {
  std::vector<std::string> result;
  for (const char* file : {"r.json", "p.csv", "g.ngc", "v.svg", "t.pdf"}) {
    result.push_back(contentOf((scratch / file).string()));
  }
  return result;
}

TEST(Plan, OfTheTriangleShowsThePapersFigures) {
  const Scratch scratch;
  auto arguments = planWithAllOutputs(sample("triangle.dxf"), scratch);
  arguments.insert(arguments.end(), {"--acceleration-rule", "combined"});
  const Outcome outcome = arris(arguments);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, testing::IsEmpty());
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("60.00°"), HasSubstr("20.000"), HasSubstr("12.990"), HasSubstr("93.750")));
  const json report = json::parse(contentOf((scratch / "r.json").string()));
  ASSERT_EQ(report["corners"].size(), 3U);
  for (const json& corner : report["corners"]) {
    EXPECT_NEAR(corner["t_m_s"].get<double>(), 12.99038, 5e-6);
    EXPECT_NEAR(corner["L_d_mm"].get<double>(), 56.5685, 5e-5);
  }
}

TEST(Plan, WritesEveryOutputInItsFormat) {
  const Scratch scratch;
  EXPECT_EQ(arris(planWithAllOutputs(sample("arcs.dxf"), scratch)).status, 0);
  const auto contents = contentsOf(scratch);
  EXPECT_THAT(contents[0], StartsWith("{"));
  EXPECT_THAT(contents[1], StartsWith("t_s,x_mm,y_mm,z_mm,"));
  EXPECT_THAT(contents[2], HasSubstr("G17 G21 G40 G54 G61 G90 G94"));
  EXPECT_THAT(contents[3], AllOf(StartsWith("<?xml"), HasSubstr("</svg>")));
  EXPECT_THAT(contents[4], StartsWith("%PDF"));
  const std::string png = (scratch / "v.PNG").string();
  EXPECT_EQ(arris({"plan", sample("arcs.dxf"), "--preview", png}).status, 0);
  EXPECT_THAT(contentOf(png), StartsWith("\x89PNG"));
}

TEST(Plan, GivesTheSameBytesInEveryLocale) {
  const Scratch scratch;
  const auto arguments = planWithAllOutputs(sample("balustrade.dxf"), scratch);
  const std::string out = arris(arguments, {{"LC_ALL", "C.UTF-8"}}).out;
  const auto expected = contentsOf(scratch);
  for (const char* locale : {"de_DE.UTF-8", "it_IT.UTF-8", "zh_CN.UTF-8", "C"}) {
    // A locale that is not installed would prove nothing.
    locale_t installed = newlocale(LC_ALL_MASK, locale, nullptr);
    ASSERT_NE(installed, nullptr) << locale;
    freelocale(installed);
    const Outcome outcome = arris(arguments, {{"LC_ALL", locale}, {"LANG", locale}, {"LANGUAGE", locale}});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.out, out) << locale;
    // Only whether: the difference of large files is nothing to print.
    EXPECT_TRUE(contentsOf(scratch) == expected) << locale;
  }
}

TEST(Plan, OfAnOpenContourSaysWhereAndWritesOnlyReportAndPreview) {
  const Scratch scratch;
  const std::string pattern = (scratch / "open.dxf").string();
  writeTo(pattern, "0\nSECTION\n2\nENTITIES\n"
                   "0\nLINE\n8\n0\n10\n0\n20\n0\n11\n500\n21\n0\n"
                   "0\nLINE\n8\n0\n10\n500\n20\n0\n11\n0\n21\n400\n"
                   "0\nLINE\n8\n0\n10\n0\n20\n400\n11\n0\n21\n7.5\n"
                   "0\nENDSEC\n0\nEOF\n");
  const Outcome outcome = arris(planWithAllOutputs(pattern, scratch));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("open-chain"), HasSubstr("7.5"), HasSubstr(" mm in the drawing: ")));
  EXPECT_TRUE(fs::exists(scratch / "r.json"));
  EXPECT_TRUE(fs::exists(scratch / "v.svg"));
  EXPECT_FALSE(fs::exists(scratch / "p.csv"));
  EXPECT_FALSE(fs::exists(scratch / "g.ngc"));
  EXPECT_FALSE(fs::exists(scratch / "t.pdf"));
}

TEST(Plan, OfAMalformedPatternNamesTheLine) {
  const Scratch scratch;
  const std::string pattern = (scratch / "broken.dxf").string();
  writeTo(pattern, "0\nSECTION\n2\nENTITIES\n0\nLINE\n10\nabc\n");
  for (const char* call : {"plan", "inspect"}) {
    const Outcome outcome = arris({call, pattern});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("line 8"));
  }
}

TEST(Plan, LeavesNothingBesideItsOutputs) {
  const Scratch scratch;
  EXPECT_EQ(arris(planWithAllOutputs(sample("rectangle.dxf"), scratch)).status, 0);
  const fs::path folder = (scratch / "x").parent_path();
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 5);
}

class Samples : public testing::TestWithParam<const char*> {};

TEST_P(Samples, ArePlannedWithTheirRecipe) {
  const Outcome outcome =
      arris({"plan", sample(std::string(GetParam()) + ".dxf"), "--recipe", sample(std::string(GetParam()) + ".json")});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Of, Samples, testing::Values("balustrade", "triangle", "rectangle", "arcs"),
                         [](const auto& test) { return test.param; });

TEST(Samples, TheSplashbackIsGroundCutOutsFirstWithAStopInItsConcaveCorner) {
  const Scratch scratch;
  const std::string file = (scratch / "r.json").string();
  const Outcome outcome =
      arris({"plan", sample("splashback.dxf"), "--recipe", sample("splashback.json"), "--report", file});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, AllOf(StartsWith("warning: "), HasSubstr("[concave-fillet]")));
  EXPECT_THAT(outcome.out, ContainsRegex("cut-out.*\n.*cut-out.*\n.*outline"));
  EXPECT_THAT(outcome.out, ContainsRegex("270\\.00°  stop"));
  EXPECT_THAT(outcome.out, HasSubstr("Not ground: 30.000 of 3600.000 mm of contour 3 (outline)"));
  const json report = json::parse(contentOf(file));
  EXPECT_EQ(report["pattern"]["contours"][0]["parent"], 3); // numbered as they are machined
}

TEST(Samples, TheBalustradeHasThreeSharpCornersOneOfSixtyDegrees) {
  const Scratch scratch;
  const std::string file = (scratch / "r.json").string();
  ASSERT_EQ(arris({"plan", sample("balustrade.dxf"), "--report", file}).status, 0);
  const json report = json::parse(contentOf(file));
  std::vector<double> angles;
  for (const json& corner : report["corners"]) {
    EXPECT_EQ(corner["treatment"], "transition");
    angles.push_back(corner["angle_deg"].get<double>());
  }
  std::sort(angles.begin(), angles.end());
  EXPECT_THAT(angles, testing::Pointwise(testing::DoubleNear(1e-9), {60.0, 90.0, 105.0}));
}

TEST(Inspect, TellsWhatIsInTheDrawing) {
  const Outcome outcome = arris({"inspect", sample("balustrade.dxf")});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("mm (by $INSUNITS)"), HasSubstr("1 ARC, 3 LINE"), HasSubstr("\"GLASS\""),
                                 ContainsRegex("1  outline  - +4 ")));
}

TEST(Inspect, ListsContoursWithWhatTheyLieIn) {
  const Outcome outcome = arris({"inspect", sample("splashback.dxf")});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, AllOf(ContainsRegex("1  outline  - +6 "), ContainsRegex("2  cut-out  1 +8 "),
                                 ContainsRegex("3  cut-out  1 +8 ")));
}

TEST(Inspect, TellsWhatWasRepairedWithCodePlaceAndLine) {
  const Scratch scratch;
  const std::string pattern = (scratch / "twice.dxf").string();
  writeTo(pattern, "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n0\n90\n4\n70\n1\n10\n0\n20\n0\n10\n500\n20\n0\n"
                   "10\n500\n20\n0\n10\n0\n20\n400\n0\nENDSEC\n0\nEOF\n");
  const std::string file = (scratch / "r.json").string();
  const Outcome outcome = arris({"inspect", pattern, "--report", file});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("Repaired (1)"), HasSubstr("line 6: at (500.000, 0.000) mm"),
                                 HasSubstr("[zero-length-removed]")));
  const json repair = json::parse(contentOf(file))["pattern"]["repairs"][0];
  EXPECT_EQ(repair["code"], "zero-length-removed");
  EXPECT_EQ(repair["where_mm"], json::parse("[500.0, 0.0]"));
  EXPECT_EQ(repair["line"], 6);
}

TEST(Inspect, OfHundredsOfRepairsTellsTheFirstOfEachKindAndTheirNumber) {
  const Scratch scratch;
  const std::string pattern = (scratch / "many.dxf").string();
  std::string text = "0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\n0\n10\n0\n20\n0\n40\n200\n";
  for (int i = 0; i < 300; ++i) {
    const std::string x = std::to_string(i);
    text += "0\nLINE\n8\n0\n10\n" + x + "\n20\n0\n11\n" + x + "\n21\n0\n";
  }
  writeTo(pattern, text + "0\nENDSEC\n0\nEOF\n");
  const Outcome outcome = arris({"inspect", pattern});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("Repaired (300)"), HasSubstr("280 more of zero-length-removed")));
  EXPECT_LT(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 40);
}

TEST(Inspect, TakesTheUnitFromTheOption) {
  const Outcome outcome = arris({"inspect", sample("triangle.dxf"), "--units", "cm"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("cm (as told)"), ContainsRegex(" 0\\.000 +6000\\.000 ")));
}

} // namespace
} // namespace arris::test
