#include "core/base/numbers.h"
#include "core/files/report.h"
#include "core/recipe/fields.h"
#include "tests/support/panes.h"
#include "tests/support/random_panes.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <clocale>
#include <cmath>
#include <random>
#include <set>

namespace arris::files {
namespace {

using base::Code;
using base::Problem;
using Json = nlohmann::json;
using testing::HasSubstr;

std::set<std::string> keysOf(const Json& object) {
  std::set<std::string> result;
  for (const auto& [key, value] : object.items()) {
    result.insert(key);
  }
  return result;
}

Json reportOf(const pattern::Pattern& pattern, const recipe::Recipe& recipe = {}) {
  return Json::parse(report(pattern, job::planJob(pattern, recipe, {}), "pane.dxf"));
}

recipe::Recipe combined() {
  recipe::Recipe recipe;
  recipe.accelerationRule = recipe::AccelerationRule::Combined;
  return recipe;
}

TEST(Report, OfThePapersTriangleHasTheContractsKeysAndFigures) {
  const Json r = reportOf(test::triangle600(), combined());
  EXPECT_EQ(keysOf(r),
            (std::set<std::string>{"arris", "arris_report", "pattern", "recipe", "machine", "placement", "corners",
                                   "path", "duration_s", "working_s", "duration_by_phase_s", "problems"}));
  EXPECT_EQ(r["arris_report"], 1);

  const Json& pattern = r["pattern"];
  EXPECT_EQ(keysOf(pattern),
            (std::set<std::string>{"file", "units", "units_from", "entities", "layers", "contours", "repairs"}));
  EXPECT_EQ(pattern["file"], "pane.dxf");
  EXPECT_EQ(pattern["units"], "mm");
  const Json& contour = pattern["contours"][0];
  EXPECT_EQ(keysOf(contour), (std::set<std::string>{"id", "kind", "length_mm", "area_mm2", "bounds_mm",
                                                    "fit_deviation_mm", "untouched_mm"}));
  EXPECT_EQ(contour["kind"], "outline");
  EXPECT_NEAR(contour["length_mm"], 1800, 1e-9);
  EXPECT_NEAR(contour["area_mm2"], 155884.57, 0.005); // 600² √3/4
  EXPECT_NEAR(contour["bounds_mm"][0], 450, 1e-9);    // centred in 1500 mm

  ASSERT_EQ(r["corners"].size(), 3U);
  const Json& corner = r["corners"][0];
  EXPECT_EQ(keysOf(corner), (std::set<std::string>{"id",
                                                   "contour",
                                                   "kind",
                                                   "treatment",
                                                   "S_mm",
                                                   "angle_deg",
                                                   "because",
                                                   "A_mm",
                                                   "C_mm",
                                                   "Q_mm",
                                                   "v_trans_mm_s",
                                                   "v_trans_limited_by",
                                                   "a_mm_s2",
                                                   "t_m_s",
                                                   "tip_depth_mm",
                                                   "planned_speed_mm_s",
                                                   "planned_time_s",
                                                   "L_d_mm",
                                                   "L_a_mm",
                                                   "P_d_mm",
                                                   "P_a_mm",
                                                   "widest_mm",
                                                   "relief",
                                                   "relief_margin_mm",
                                                   "relief_eq13"}));
  EXPECT_EQ(corner["kind"], "sharp");
  EXPECT_EQ(corner["treatment"], "transition");
  EXPECT_EQ(corner["v_trans_limited_by"], "angle");
  EXPECT_NEAR(corner["angle_deg"], 60, 1e-9);
  EXPECT_NEAR(corner["v_trans_mm_s"], 20, 1e-9);
  EXPECT_NEAR(corner["a_mm_s2"], 1.5396, 5e-6);
  EXPECT_NEAR(corner["t_m_s"], 12.99038, 5e-6);
  EXPECT_NEAR(corner["L_d_mm"], 56.5685, 5e-5);
  EXPECT_NEAR(corner["L_a_mm"], 56.5685, 5e-5);
  EXPECT_NEAR(corner["widest_mm"], 93.75, 1e-9);
  EXPECT_NEAR(corner["relief_margin_mm"], 93.75 - 75.26, 1e-9);
  EXPECT_EQ(corner["relief"], true);
  EXPECT_EQ(corner["relief_eq13"], true);

  EXPECT_EQ(r["path"]["segments"], 9); // lead-in, four stretches of three sides, three transitions, lead-out
  double phases = 0;
  for (const auto& [phase, seconds] : r["duration_by_phase_s"].items()) {
    phases += seconds.get<double>();
  }
  EXPECT_NEAR(phases, r["duration_s"], 1e-9);
  EXPECT_LT(r["working_s"], r["duration_s"]);
}

TEST(Report, HasEveryKeyOfRecipeAndMachineThatIsInEffect) {
  recipe::Recipe recipe;
  recipe.start = {700, 900};
  recipe.place = {300, 400};
  recipe.units = recipe::Units::Millimetre;
  recipe.rotate = 30;
  recipe.mirror = recipe::Mirror::X;
  const Json r = reportOf(test::triangle600(), recipe);
  const auto expectKeys = [&r](const auto& fields) {
    for (const auto& field : fields) {
      EXPECT_TRUE(r["recipe"].contains(std::string(field.key)) || field.key == "layers") << field.key;
    }
  };
  expectKeys(recipe::numberFields());
  expectKeys(recipe::choiceFields());
  expectKeys(recipe::placeFields());
  expectKeys(recipe::listFields());
  expectKeys(recipe::flagFields());
  EXPECT_EQ(keysOf(r["machine"]),
            (std::set<std::string>{"travel_mm", "max_speed_mm_min", "max_accel_mm_s2", "plunge_feed_mm_min", "park_mm",
                                   "period_s", "home_at_mm", "home_search_mm_min", "home_latch_mm_min", "jog_mm_min",
                                   "set_point_lead_s", "following_error_mm", "back_off_mm", "back_off_after_s",
                                   "spindle_wait_s", "jog_enable_required"}));
  EXPECT_EQ(r["placement"]["x_mm"], 300.0);
  EXPECT_EQ(r["placement"]["y_mm"], 400.0);
  EXPECT_EQ(r["placement"]["rotation_deg"], 30.0);
  EXPECT_EQ(r["placement"]["mirror"], "x");
  EXPECT_EQ(r["placement"]["pattern_origin_mm"].size(), 2U);
  const Json bounds = r["pattern"]["contours"][0]["bounds_mm"]; // on the table too
  EXPECT_NEAR(bounds[0], 300, 1e-9);
  EXPECT_NEAR(bounds[1], 400, 1e-9);
}

TEST(Report, SaysInWordsAndFiguresWhyACornerIsTreatedAsItIs) {
  const Json sharp = reportOf(test::triangle600())["corners"][0]["because"];
  EXPECT_EQ(sharp["code"], "sharp-with-relief");
  EXPECT_EQ(sharp["text"], "On a transition the wheel clears the tip of the blank: at 60° (1 − sin(β/2))² is 0.25, not "
                           "less than 2 d_n/R = 0.00346667.");
  EXPECT_NEAR(sharp["relief_reached"], 0.25, 1e-12);
  EXPECT_NEAR(sharp["relief_needed"], 2 * 0.13 / 75, 1e-15);
  EXPECT_EQ(sharp["depth_mm"], 0.13);
  EXPECT_EQ(sharp["wheel_radius_mm"], 75.0);

  const Json obtuse = reportOf(test::isosceles(145, 500))["corners"];
  const auto blunt = std::find_if(obtuse.begin(), obtuse.end(), [](const Json& c) { return c["kind"] == "blunt"; });
  ASSERT_NE(blunt, obtuse.end());
  EXPECT_EQ((*blunt)["treatment"], "roll");
  EXPECT_EQ((*blunt)["relief"], false);
  EXPECT_EQ((*blunt)["because"]["code"], "blunt-without-relief");
  EXPECT_THAT((*blunt)["because"]["text"].get<std::string>(), HasSubstr("From 120° on a corner is not fragile"));
  EXPECT_NEAR((*blunt)["because"]["relief_reached"], 0.00214, 5e-6); // (1 − sin 72.5°)²
  EXPECT_NEAR((*blunt)["because"]["limit_deg"], 120, 1e-9);
  for (const char* key :
       {"Q_mm", "v_trans_mm_s", "v_trans_limited_by", "a_mm_s2", "t_m_s", "widest_mm", "relief_margin_mm"}) {
    EXPECT_FALSE(blunt->contains(key)) << key; // a roll has none of them
  }

  recipe::Recipe deep;
  deep.depth = 5;
  const Json corner = reportOf(test::polygon({{0, 0}, {800, 0}, {800, 500}, {0, 500}}), deep)["corners"][0];
  EXPECT_EQ(corner["treatment"], "transition");
  EXPECT_EQ(corner["because"]["code"], "sharp-without-relief"); // (1 − sin 45°)² = 0.0858 < 0.1333
  EXPECT_LT(corner["relief_margin_mm"], 0);
}

TEST(Report, OfAJobThatCannotBeGroundHasEveryReasonAndNoPlan) {
  recipe::Recipe recipe;
  recipe.place = {0, 0}; // the wheel would leave the travel
  const Json r = reportOf(test::triangle600(), recipe);
  for (const char* key : {"path", "duration_s", "working_s", "duration_by_phase_s"}) {
    EXPECT_FALSE(r.contains(key)) << key;
  }
  ASSERT_FALSE(r["problems"].empty());
  const Json& problem = r["problems"][0];
  EXPECT_EQ(problem["severity"], "error");
  EXPECT_EQ(problem["code"], "outside-travel");
  EXPECT_THAT(problem["text"].get<std::string>(), HasSubstr("leaves the travel"));
  EXPECT_GT(problem["values"]["excess_mm"], 0);
  EXPECT_EQ(problem["where_mm"].size(), 2U);
  EXPECT_EQ(r["corners"].size(), 3U);
  EXPECT_FALSE(r["corners"][0].contains("planned_time_s"));
  EXPECT_TRUE(r["corners"][0].contains("because"));
}

TEST(Report, OfAnImportTellsWhatWasFoundRepairedAndWrong) {
  pattern::Pattern pattern = test::triangle600();
  pattern.units = recipe::Units::Inch;
  pattern.unitsFrom = pattern::UnitsFrom::InsUnits;
  pattern.entities = {{"LINE", 3}, {"TEXT", 1}};
  pattern.layers = {{"0", {{"LINE", 3}}}, {"NOTES", {{"TEXT", 1}}}};
  pattern.repairs = {Problem(Code::GapClosed, {{"size_mm", 0.02}}).at({1, 2}),
                     Problem(Code::ZeroLengthRemoved, {{"size_mm", 0.0}}).at({3, 4}).onLine(17)};
  Problem tooSmall = Problem(Code::Unreached, {{"wheel_mm", 75.0}, {"length_mm", 20.0}}).at({-3.5, 4}).ofContour(1);
  tooSmall.largestWheel = 20;
  pattern.problems = {Problem(Code::EntityNotSupported, {{"entity", "SPLINE"}}).onLine(123), tooSmall};
  const Json r = Json::parse(report(pattern, "pane.dxf"));
  EXPECT_EQ(keysOf(r), (std::set<std::string>{"arris", "arris_report", "pattern", "problems"}));
  EXPECT_EQ(r["pattern"]["units"], "inch");
  EXPECT_EQ(r["pattern"]["units_from"], "insunits");
  EXPECT_EQ(r["pattern"]["entities"], Json::parse(R"({"LINE": 3, "TEXT": 1})"));
  EXPECT_EQ(r["pattern"]["layers"], Json::parse(R"({"0": {"LINE": 3}, "NOTES": {"TEXT": 1}})"));
  EXPECT_EQ(r["pattern"]["repairs"],
            Json::parse(R"([{"code": "gap-closed", "text": "A gap of 0.02 mm was closed.", "where_mm": [1.0, 2.0],
                             "size_mm": 0.02},
                            {"code": "zero-length-removed", "text": "A piece without length (0 mm) was removed.",
                             "where_mm": [3.0, 4.0], "line": 17, "size_mm": 0.0}])"));
  EXPECT_EQ(r["problems"][0]["line"], 123);
  EXPECT_FALSE(r["problems"][0].contains("where_mm"));
  EXPECT_EQ(r["problems"][1]["where_mm"], Json::parse("[-3.5, 4.0]"));
  EXPECT_EQ(r["problems"][1]["contour"], 1);
  EXPECT_EQ(r["problems"][1]["largest_wheel_mm"], 20.0);
  EXPECT_EQ(r["problems"][1]["values"], Json::parse(R"({"wheel_mm": 75.0, "length_mm": 20.0})"));
}

TEST(Report, NamesTheContourThatEachOtherOneLiesIn) {
  pattern::Pattern pattern = test::polygon({{0, 0}, {800, 0}, {800, 500}, {0, 500}});
  pattern::Contour hole = test::polygon({{300, 200}, {500, 200}, {500, 300}, {300, 300}}).contours.front();
  hole.id = 2;
  hole.kind = pattern::ContourKind::CutOut;
  hole.parent = 1;
  pattern.contours.push_back(hole);
  const Json contours = Json::parse(report(pattern, "pane.dxf"))["pattern"]["contours"];
  EXPECT_FALSE(contours[0].contains("parent"));
  EXPECT_EQ(contours[1]["parent"], 1);
}

TEST(Report, PlacesOfRepairsAreOnTheTableOnceThePaneIs) {
  pattern::Pattern pattern = test::polygon({{0, 0}, {800, 0}, {800, 500}, {0, 500}});
  pattern.repairs = {Problem(Code::GapClosed, {{"size_mm", 0.02}}).at({800, 500})};
  recipe::Recipe recipe;
  recipe.place = {300, 400};
  EXPECT_EQ(reportOf(pattern, recipe)["pattern"]["repairs"][0]["where_mm"], Json::parse("[1100.0, 900.0]"));
}

TEST(Report, OfNothingIsAReportToo) {
  pattern::Pattern pattern;
  pattern.problems = {Problem(Code::NoContour)};
  const Json r = reportOf(pattern);
  EXPECT_FALSE(r.contains("placement"));
  EXPECT_TRUE(r["corners"].empty());
  EXPECT_EQ(r["problems"][0]["code"], "no-contour");
}

TEST(Report, NamesThatAreNoUtf8AreReplacedAndNotFatal) {
  pattern::Pattern pattern = test::triangle600();
  pattern.layers = {{"Gl\xe4ser", {{"LINE", 3}}}};
  const Json r = Json::parse(report(pattern, "fen\xeatre.dxf"));
  EXPECT_EQ(r["pattern"]["file"], "fen\xef\xbf\xbdtre.dxf");
  EXPECT_TRUE(r["pattern"]["layers"].contains("Gl\xef\xbf\xbdser"));
}

TEST(Report, EveryNumberIsFiniteAndExactForRandomPanes) {
  std::uint64_t seed = 8800;
  for (int i = 0; i < 20; ++i) {
    const job::Job job = test::randomJob(seed);
    const std::string text = report({}, job, "pane.dxf");
    EXPECT_EQ(text.find("null"), std::string::npos) << "seed " << seed - 1;
    EXPECT_EQ(text.find("-0,"), std::string::npos) << "seed " << seed - 1;
    const Json corners = Json::parse(text)["corners"];
    for (const toolpath::Corner& corner : job.toolpath.corners) { // to the last bit
      const Json& object = corners[static_cast<std::size_t>(corner.id - 1)];
      EXPECT_EQ(object["A_mm"], (Json{corner.a.x(), corner.a.y()}));
      EXPECT_EQ(object["S_mm"], (Json{corner.s.x(), corner.s.y()}));
    }
  }
}

TEST(Report, IsTheSameEveryTimeAndInEveryLocale) {
  const pattern::Pattern pattern = test::triangle600();
  const auto make = [&pattern] { return report(pattern, job::planJob(pattern, {}, {}), "pane.dxf"); };
  const std::string text = make();
  for (const char* locale : {"de_DE.UTF-8", "it_IT.UTF-8", "zh_CN.UTF-8"}) {
    ASSERT_NE(std::setlocale(LC_ALL, locale), nullptr) << locale;
    EXPECT_EQ(make(), text);
    std::setlocale(LC_ALL, "C");
  }
}

TEST(ReadReport, GivesThePlotItsLimitsAndCorners) {
  const pattern::Pattern pattern = test::isosceles(145, 500);
  const job::Job job = job::planJob(pattern, {}, {});
  const auto figures = readReport(report(pattern, job, "pane.dxf"), "a.json");
  ASSERT_TRUE(figures) << describe(figures.error());
  EXPECT_EQ(figures->feed, 60);
  EXPECT_EQ(figures->accelX, 20);
  EXPECT_EQ(figures->accelY, 20);
  EXPECT_EQ(figures->wheelRadius, 75);
  ASSERT_EQ(figures->corners.size(), job.toolpath.corners.size());
  for (std::size_t i = 0; i < figures->corners.size(); ++i) {
    const toolpath::Corner& corner = job.toolpath.corners[i];
    EXPECT_EQ(figures->corners[i].id, corner.id);
    EXPECT_NEAR(figures->corners[i].angle, corner.angle, 1e-12);
    const bool transition = corner.treatment == toolpath::Treatment::Transition;
    EXPECT_EQ(figures->corners[i].reliefRadius.has_value(), transition);
    if (transition) {
      EXPECT_NEAR(*figures->corners[i].reliefRadius, 75 + corner.tipDepth, 1e-12);
    }
  }
}

TEST(ReadReport, RefusesWhatIsNoReportAndTakesWhatIsThere) {
  EXPECT_EQ(readReport("{", "a.json").error().code, Code::JsonMalformed);
  EXPECT_EQ(readReport("{\"arris_recipe\": 1}", "a.json").error().code, Code::JsonNotThisFormat);
  EXPECT_EQ(readReport("{\"arris_report\": 2}", "a.json").error().code, Code::VersionNewer);
  const auto bare =
      readReport(R"({"arris_report": 1, "recipe": [], "corners": [1, {"id": 1}, {"id": "x"}]})", "a.json");
  ASSERT_TRUE(bare);
  EXPECT_FALSE(bare->feed);
  EXPECT_TRUE(bare->corners.empty());
}

TEST(ReadReport, CorruptedReportsDoNoHarm) {
  const pattern::Pattern pattern = test::triangle600();
  const std::string whole = report(pattern, job::planJob(pattern, {}, {}), "pane.dxf");
  std::mt19937 random(99);
  int refused = 0;
  for (int round = 0; round < 1000; ++round) {
    std::string text = whole;
    const std::size_t at = random() % text.size();
    if (round % 2 == 0) {
      text[at] = static_cast<char>(random() % 256);
    } else {
      text.erase(at, random() % 100);
    }
    refused += readReport(text, "a.json") ? 0 : 1;
  }
  EXPECT_GT(refused, 100);
  EXPECT_LT(refused, 1000);
}

} // namespace
} // namespace arris::files
