#include "core/files/recipe_json.h"
#include "core/recipe/fields.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>
#include <limits>
#include <random>

namespace arris::files {
namespace {

using base::Code;
using base::describe;
using recipe::Machine;
using recipe::Recipe;
using testing::HasSubstr;

std::string recipeWith(std::string_view members) {
  return fmt::format("{{\"arris_recipe\": 1, {}}}", members);
}

std::string machineWith(std::string_view members) {
  return fmt::format("{{\"arris_machine\": 1, {}}}", members);
}

std::string firstProblem(const base::Problems& problems) {
  return problems.empty() ? "no problem" : describe(problems.front());
}

// A recipe that differs from the default in every field.
Recipe unusualRecipe() {
  std::mt19937 random(4711);
  Recipe result;
  for (const auto& field : recipe::numberFields()) {
    result.*field.member = std::uniform_real_distribution(field.least, field.most)(random);
  }
  for (const auto& field : recipe::choiceFields()) {
    field.set(result, static_cast<int>(field.words.size()) - 1);
  }
  for (const auto& field : recipe::placeFields()) {
    result.*field.member = Eigen::Vector2d(-0.1, 1234.000001);
  }
  for (const auto& field : recipe::listFields()) {
    result.*field.member = {"GLASS", "Glaskante außen", "玻璃 \"1\""};
  }
  for (const auto& field : recipe::flagFields()) {
    result.*field.member = true;
  }
  return result;
}

TEST(RecipeJson, WhatIsWrittenIsReadBackExactly) {
  for (const Recipe& recipe : {Recipe{}, unusualRecipe()}) {
    const auto read = readRecipe(writeRecipe(recipe), "a.json");
    EXPECT_TRUE(read.problems.empty()) << firstProblem(read.problems);
    EXPECT_EQ(read.value, recipe);
  }
}

TEST(RecipeJson, EveryFieldOfAnUnusualRecipeStandsInTheFileUnderItsKey) {
  const Recipe recipe = unusualRecipe();
  EXPECT_FALSE(recipe == Recipe{});
  const std::string text = writeRecipe(recipe);
  const auto expectKeys = [&](const auto& fields) {
    for (const auto& field : fields) {
      EXPECT_THAT(text, HasSubstr(fmt::format("\"{}\": ", field.key)));
    }
  };
  expectKeys(recipe::numberFields());
  expectKeys(recipe::choiceFields());
  expectKeys(recipe::placeFields());
  expectKeys(recipe::listFields());
  expectKeys(recipe::flagFields());
}

TEST(RecipeJson, TheDefaultRecipeLooksLikeThis) {
  EXPECT_EQ(writeRecipe(Recipe{}), R"({
  "arris_recipe": 1,
  "wheel_radius_mm": 75,
  "wheel_height_mm": 30,
  "wheel_z_mm": 0,
  "depth_mm": 0.13,
  "thickness_mm": 12,
  "support_mm": 40,
  "clearance_mm": 10,
  "feed_mm_min": 3600,
  "accel_x_mm_s2": 20,
  "accel_y_mm_s2": 20,
  "accel_z_mm_s2": 20,
  "spindle_r_min": 6000,
  "corner_speed_percent": 100,
  "size_correction_mm": 0,
  "lead_mm": 20,
  "overlap_mm": 10,
  "rotate_deg": 0,
  "gap_mm": 0.05,
  "smooth_mm": 0.01,
  "acceleration_rule": "per-axis",
  "direction": "cw",
  "mirror": "none",
  "accept_unreached": false
}
)");
}

TEST(RecipeJson, KeysThatAreAbsentKeepTheirDefaults) {
  Recipe defaults;
  defaults.feed = 1234;
  const auto read = readRecipe(recipeWith("\"depth_mm\": 0.2"), "a.json", defaults);
  EXPECT_TRUE(read.problems.empty());
  defaults.depth = 0.2;
  EXPECT_EQ(read.value, defaults);
}

TEST(RecipeJson, WholeNumbersAndExponentsAreNumbersToo) {
  const auto read = readRecipe(recipeWith("\"feed_mm_min\": 36e2, \"depth_mm\": 1, \"start_mm\": [1, 2.5]"), "a.json");
  EXPECT_TRUE(read.problems.empty());
  EXPECT_EQ(read.value.feed, 3600);
  EXPECT_EQ(read.value.depth, 1);
  EXPECT_EQ(read.value.start, Eigen::Vector2d(1, 2.5));
}

TEST(RecipeJson, EveryNumberOutsideItsRangeOrOfAnotherTypeIsRefusedByName) {
  for (const auto& field : recipe::numberFields()) {
    const std::string below = fmt::format("{}", std::nextafter(field.least, -1e300));
    const std::string above = fmt::format("{}", std::nextafter(field.most, 1e300));
    for (const std::string& value :
         {below, above, std::string("1e300"), std::string("null"), std::string("true"), std::string("\"75\""),
          std::string("\"75 mm\""), std::string("[75]"), std::string("{\"mm\": 75}"), std::string("\"nan\"")}) {
      const auto read = readRecipe(recipeWith(fmt::format("\"{}\": {}", field.key, value)), "a.json");
      ASSERT_EQ(read.problems.size(), 1u) << field.key << ": " << value;
      EXPECT_TRUE(hasErrors(read.problems));
      EXPECT_THAT(describe(read.problems[0]), HasSubstr(std::string(field.key)));
      EXPECT_THAT(describe(read.problems[0]), HasSubstr(std::string(field.unit)));
    }
  }
}

struct Refusal {
  const char* name;
  const char* members;
  const char* sentence;
};

void PrintTo(const Refusal& row, std::ostream* stream) {
  *stream << row.members;
}

class RecipeRefusal : public testing::TestWithParam<Refusal> {};

TEST_P(RecipeRefusal, SaysWhatIsWrongAndWhatIsAllowed) {
  EXPECT_EQ(firstProblem(readRecipe(recipeWith(GetParam().members), "a.json").problems), GetParam().sentence);
}

INSTANTIATE_TEST_SUITE_P(
    Table, RecipeRefusal,
    testing::Values(
        Refusal{"NumberAsText", R"("depth_mm": "0.13 mm")", "depth_mm must be a number in mm, not \"0.13 mm\"."},
        Refusal{"NumberNull", R"("feed_mm_min": null)", "feed_mm_min must be a number in mm/min, not \"null\"."},
        Refusal{"NumberNegative", R"("wheel_radius_mm": -75)",
                "wheel_radius_mm is -75 mm; it must be from 0.5 to 500 mm."},
        Refusal{"NumberZero", R"("accel_x_mm_s2": 0)", "accel_x_mm_s2 is 0 mm/s²; it must be from 0.1 to 20000 mm/s²."},
        Refusal{"ChoiceUnknown", R"("direction": "left")", "direction is \"left\"; it must be one of: cw, ccw."},
        Refusal{"ChoiceOfOtherCase", R"("units": "MM")", "units is \"MM\"; it must be one of: mm, cm, m, inch, foot."},
        Refusal{"ChoiceAsNumber", R"("mirror": 1)", "mirror must be one of: none, x, y, not 1."},
        Refusal{"PlaceTooShort", R"("start_mm": [1])", "start_mm must be [x, y] in mm, not [1]."},
        Refusal{"PlaceTooLong", R"("place_mm": [1, 2, 3])", "place_mm must be [x, y] in mm, not [1,2,3]."},
        Refusal{"PlaceOfText", R"("place_mm": "1,2")", "place_mm must be [x, y] in mm, not \"1,2\"."},
        Refusal{"PlaceAbsurd", R"("place_mm": [0, 1e9])",
                "place_mm (y) is 1000000000 mm; it must be from -100000 to 100000 mm."},
        Refusal{"LayersAsText", R"("layers": "GLASS")", "layers must be a list of names, not \"GLASS\"."},
        Refusal{"LayersOfNumbers", R"("layers": [0])", "layers must be a list of names, not [0]."},
        Refusal{"FlagAsNumber", R"("accept_unreached": 1)", "accept_unreached must be true or false, not 1."}),
    [](const auto& row) { return row.param.name; });

TEST(RecipeJson, EveryWrongValueIsReportedAtOnce) {
  const auto read = readRecipe(recipeWith(R"("feed_mm_min": "fast", "depth_mm": 77, "direction": 3)"), "a.json");
  EXPECT_EQ(read.problems.size(), 3u);
}

TEST(RecipeJson, AnUnknownKeyIsAWarningThatNamesIt) {
  const auto read = readRecipe(recipeWith("\"feed_mm_s\": 60, \"depth_mm\": 0.2"), "a.json");
  ASSERT_EQ(read.problems.size(), 1u);
  EXPECT_FALSE(hasErrors(read.problems));
  EXPECT_EQ(firstProblem(read.problems), "a.json has a key \"feed_mm_s\" that Arris does not know; it is ignored.");
  EXPECT_EQ(read.value.depth, 0.2);
}

TEST(RecipeJson, ANewerVersionIsRefused) {
  EXPECT_EQ(firstProblem(readRecipe("{\"arris_recipe\": 2, \"feed_mm_min\": 100}", "a.json").problems),
            "a.json was written by a newer Arris (\"arris_recipe\": 2); this one reads up to 1.");
  EXPECT_TRUE(hasErrors(readRecipe("{\"arris_recipe\": 2}", "a.json").problems));
}

TEST(RecipeJson, AFileOfAnotherKindIsRefused) {
  EXPECT_EQ(firstProblem(readRecipe("{\"arris_machine\": 1}", "a.json").problems),
            "a.json has no \"arris_recipe\": it is not such a file.");
  for (const char* version : {"\"1\"", "1.5", "0", "-1", "null", "true", "[1]"}) {
    const auto read = readRecipe(fmt::format("{{\"arris_recipe\": {}}}", version), "a.json");
    EXPECT_TRUE(hasErrors(read.problems)) << version;
  }
}

TEST(RecipeJson, MalformedTextIsRefusedWithLineAndColumn) {
  EXPECT_THAT(firstProblem(readRecipe("{\n  \"arris_recipe\": 1,\n  \"feed_mm_min\": NaN\n}", "a.json").problems),
              HasSubstr("a.json is not valid JSON: line 3, column 18: "));
  for (const char* text : {"", " ", "{", "}", "[]", "1", "null", "{\"arris_recipe\": 1", "{\"arris_recipe\": 1,}",
                           "{'arris_recipe': 1}", "{\"arris_recipe\": 1} x", "{\"arris_recipe\": 1}{}", "\xff\xfe",
                           "{\"arris_recipe\": 1, \"depth_mm\": 1e999}", "{\"arris_recipe\": 1, \"\xff\": 1}"}) {
    const auto read = readRecipe(text, "a.json");
    ASSERT_EQ(read.problems.size(), 1u) << text;
    EXPECT_EQ(read.problems[0].code, Code::JsonMalformed) << text;
  }
}

TEST(RecipeJson, AKeyThatStandsTwiceIsRefused) {
  EXPECT_EQ(firstProblem(readRecipe(recipeWith("\"depth_mm\": 0.1, \"depth_mm\": 0.2"), "a.json").problems),
            "a.json is not valid JSON: the key \"depth_mm\" stands twice.");
}

TEST(RecipeJson, DeepNestingAndHugeTextsAreRefusedWithoutHarm) {
  for (const char* piece : {"[", "{\"a\":"}) {
    std::string deep;
    for (int i = 0; i < 200000; ++i) {
      deep += piece;
    }
    EXPECT_TRUE(hasErrors(readRecipe(deep, "a.json").problems));
    EXPECT_TRUE(hasErrors(readRecipe(recipeWith("\"start_mm\": " + deep), "a.json").problems));
  }
  const std::string closed = std::string(100000, '[') + std::string(100000, ']');
  EXPECT_THAT(firstProblem(readRecipe(recipeWith("\"start_mm\": " + closed), "a.json").problems), HasSubstr("deep"));
  const std::string longName(5'000'000, 'x');
  const auto read = readRecipe(recipeWith("\"direction\": \"" + longName + "\""), "a.json");
  EXPECT_LT(firstProblem(read.problems).size(), 200u);
}

TEST(RecipeJson, CorruptedFilesAreReadOrRefusedAndNeverGiveAValueOutsideItsRange) {
  const std::string whole = writeRecipe(unusualRecipe());
  std::mt19937 random(20240607);
  int refused = 0;
  for (int round = 0; round < 4000; ++round) {
    std::string text = whole;
    const int wounds = 1 + static_cast<int>(random() % 3);
    for (int i = 0; i < wounds; ++i) {
      const std::size_t at = random() % text.size();
      switch (random() % 4) {
      case 0:
        text[at] = static_cast<char>(random() % 256);
        break;
      case 1:
        text.erase(at, 1 + random() % 20);
        break;
      case 2:
        text.insert(at, text.substr(random() % text.size(), random() % 20));
        break;
      default:
        text[at] = "0123456789eE+-.,:\"{}[]"[random() % 22];
      }
    }
    const auto read = readRecipe(text, "a.json");
    refused += hasErrors(read.problems) ? 1 : 0;
    if (!hasErrors(read.problems)) {
      EXPECT_TRUE(recipe::check(read.value).empty()) << text;
    }
  }
  EXPECT_GT(refused, 2000);
  EXPECT_LT(refused, 4000);
}

TEST(RecipeJson, IsTheSameInEveryLocale) {
  const std::string text = writeRecipe(unusualRecipe());
  for (const char* locale : {"de_DE.UTF-8", "it_IT.UTF-8", "zh_CN.UTF-8"}) {
    ASSERT_NE(std::setlocale(LC_ALL, locale), nullptr) << locale;
    EXPECT_EQ(writeRecipe(unusualRecipe()), text);
    EXPECT_EQ(readRecipe(text, "a.json").value, unusualRecipe());
    std::setlocale(LC_ALL, "C");
  }
}

TEST(MachineJson, WhatIsWrittenIsReadBackExactly) {
  Machine machine;
  machine.travel = {3000.5, 2000, 250};
  machine.maxSpeed = {1, 2, 3};
  machine.maxAccel = {0.1, 20000, 1.0 / 3};
  machine.plungeFeed = 77;
  machine.park = {3000.5, 0.25, 250};
  machine.period = 0.00025;
  machine.homeAt = {3000.5, 1, 0};
  machine.backOff = 7.25;
  machine.jogEnableRequired = true;
  for (const Machine& m : {machine, Machine{}}) {
    const auto read = readMachine(writeMachine(m), "m.json");
    EXPECT_TRUE(read.problems.empty()) << firstProblem(read.problems);
    EXPECT_EQ(read.value, m);
  }
}

TEST(MachineJson, TheDefaultMachineLooksLikeThis) {
  const auto read = readMachine(R"({"arris_machine": 1, "travel_mm": [1500, 2500, 120],
      "max_speed_mm_min": [12000, 12000, 3000], "max_accel_mm_s2": [500, 500, 500], "plunge_feed_mm_min": 1000,
      "park_mm": [0, 0, 120], "period_s": 0.001, "home_at_mm": [0, 0, 120], "home_search_mm_min": 1500,
      "home_latch_mm_min": 60, "jog_mm_min": 3000, "set_point_lead_s": 0.03, "following_error_mm": 1,
      "back_off_mm": 5, "back_off_after_s": 2, "spindle_wait_s": 15, "jog_enable_required": false})",
                                "m.json");
  EXPECT_TRUE(read.problems.empty());
  EXPECT_EQ(read.value, Machine{});
}

TEST(MachineJson, EveryWrongValueIsRefusedByName) {
  for (const auto& [members, sentence] : std::initializer_list<std::pair<const char*, const char*>>{
           {R"("travel_mm": 1500)", "travel_mm must be [x, y, z] in mm, not 1500."},
           {R"("travel_mm": [1500, 2500])", "travel_mm must be [x, y, z] in mm, not [1500,2500]."},
           {R"("travel_mm": [1500, "2500", 120])", "travel_mm must be [x, y, z] in mm, not [1500,\"2500\",120]."},
           {R"("travel_mm": [1500, 0, 120])", "travel_mm (y) is 0 mm; it must be from 1 to 100000 mm."},
           {R"("period_s": 1)", "period_s is 1 s; it must be from 0.00025 to 0.02 s."},
           {R"("period_s": "1 ms")", "period_s must be a number in s, not \"1 ms\"."},
           {R"("plunge_feed_mm_min": -1)", "plunge_feed_mm_min is -1 mm/min; it must be from 1 to 60000 mm/min."},
           {R"("park_mm": [0, 0, 121])", "park_mm (z) is 121 mm; it must be from 0 to 120 mm."},
           {R"("jog_enable_required": 1)", "jog_enable_required must be true or false, not 1."},
           {R"("wheel_radius_mm": 75)",
            "m.json has a key \"wheel_radius_mm\" that Arris does not know; it is ignored."},
       }) {
    EXPECT_EQ(firstProblem(readMachine(machineWith(members), "m.json").problems), sentence);
  }
  EXPECT_TRUE(hasErrors(readMachine("{\"arris_machine\": 2}", "m.json").problems));
  EXPECT_TRUE(hasErrors(readMachine(writeRecipe(Recipe{}), "m.json").problems));
}

} // namespace
} // namespace arris::files
