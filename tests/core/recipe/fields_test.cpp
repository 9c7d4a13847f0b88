#include "core/recipe/fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace arris::recipe {
namespace {

using base::Code;
using base::describe;
using testing::AllOf;
using testing::HasSubstr;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(RecipeFields, AreTheContractWithItsDefaultsAndRanges) {
  struct Row {
    std::string_view key, option;
    double value, least, most;
    bool operator==(const Row&) const = default;
  };

  const std::vector<Row> contract = {
      {"wheel_radius_mm", "wheel-radius", 75, 0.5, 500},
      {"wheel_height_mm", "wheel-height", 30, 1, 200},
      {"wheel_z_mm", "wheel-z", 0, -100, 100},
      {"depth_mm", "depth", 0.13, 0, 5},
      {"thickness_mm", "thickness", 12, 1, 100},
      {"support_mm", "support", 40, 0, 1000},
      {"clearance_mm", "clearance", 10, 1, 500},
      {"feed_mm_min", "feed", 3600, 1, 60000},
      {"accel_x_mm_s2", "accel-x", 20, 0.1, 20000},
      {"accel_y_mm_s2", "accel-y", 20, 0.1, 20000},
      {"accel_z_mm_s2", "accel-z", 20, 0.1, 20000},
      {"spindle_r_min", "spindle", 6000, 0, 60000},
      {"corner_speed_percent", "corner-speed", 100, 10, 100},
      {"size_correction_mm", "size-correction", 0, -5, 5},
      {"lead_mm", "lead", 20, 1, 500},
      {"overlap_mm", "overlap", 10, 0, 1000},
      {"rotate_deg", "rotate", 0, -360, 360},
      {"gap_mm", "gap", 0.05, 0, 1},
      {"smooth_mm", "smooth", 0.01, 0, 1},
  };
  std::vector<Row> fields;
  for (const NumberField& field : numberFields()) {
    fields.push_back({field.key, field.option, Recipe{}.*field.member, field.least, field.most});
  }
  EXPECT_EQ(fields, contract);
}

TEST(RecipeFields, KeysAndOptionsAreUsedOnce) {
  std::multiset<std::string_view> keys;
  std::multiset<std::string_view> options;
  const auto collect = [&](const auto& fields) {
    for (const auto& field : fields) {
      keys.insert(field.key);
      options.insert(field.option);
    }
  };
  collect(numberFields());
  collect(choiceFields());
  collect(placeFields());
  collect(listFields());
  collect(flagFields());
  EXPECT_EQ(std::set(keys.begin(), keys.end()).size(), keys.size());
  EXPECT_EQ(std::set(options.begin(), options.end()).size(), options.size());
  EXPECT_EQ(keys.size(), 27u);
}

TEST(RecipeFields, EveryChoiceIsReadBackAsItWasSet) {
  for (const ChoiceField& field : choiceFields()) {
    const int none = field.key == "units" ? -1 : 0;
    for (int index = none; index < static_cast<int>(field.words.size()); ++index) {
      Recipe recipe;
      field.set(recipe, index);
      EXPECT_EQ(field.get(recipe), index) << field.key;
    }
    EXPECT_EQ(field.get(Recipe{}), none) << field.key;
  }
}

TEST(RecipeCheck, TheDefaultsAreValid) {
  EXPECT_TRUE(check(Recipe{}, Machine{}).empty());
  EXPECT_TRUE(check(Machine{}).empty());
}

TEST(RecipeCheck, TheEndsOfEveryRangeAreValidAndWhatLiesBeyondIsRefusedByName) {
  Machine machine;
  machine.maxAccel.setConstant(20000);
  for (const NumberField& field : numberFields()) {
    for (const double value : {field.least, field.most}) {
      Recipe recipe;
      recipe.*field.member = value;
      EXPECT_TRUE(check(recipe, machine).empty()) << field.key << " " << value;
    }
    const double below = std::nextafter(field.least, -kInfinity);
    const double above = std::nextafter(field.most, kInfinity);
    for (const double value : {below, above, -1e300, 1e300, kNaN, kInfinity, -kInfinity}) {
      Recipe recipe;
      recipe.*field.member = value;
      const base::Problems problems = check(recipe, machine);
      ASSERT_EQ(problems.size(), 1u) << field.key << " " << value;
      EXPECT_THAT(describe(problems[0]), AllOf(HasSubstr(std::string(field.key)), HasSubstr(std::string(field.unit))));
    }
  }
}

TEST(RecipeCheck, AValueJustOutsideItsRangeDoesNotReadAsIfItWereInside) {
  Recipe recipe;
  recipe.feed = 60000.001;
  EXPECT_EQ(describe(check(recipe).at(0)), "feed_mm_min is 60000.001 mm/min; it must be from 1 to 60000 mm/min.");
}

TEST(RecipeCheck, AValueThatIsNoNumberIsRefusedWithItsUnit) {
  Recipe recipe;
  recipe.accelX = kNaN;
  EXPECT_EQ(describe(check(recipe, Machine{}).at(0)), "accel_x_mm_s2 must be a number in mm/s², not \"nan\".");
}

TEST(RecipeCheck, AccelerationsAreNotAboveTheMachines) {
  Machine machine;
  machine.maxAccel = {100, 200, 300};
  Recipe recipe;
  recipe.accelX = 100;
  recipe.accelY = 200;
  recipe.accelZ = 300;
  EXPECT_TRUE(check(recipe, machine).empty());
  recipe.accelY = 200.5;
  ASSERT_EQ(check(recipe, machine).size(), 1u);
  EXPECT_EQ(describe(check(recipe, machine)[0]), "accel_y_mm_s2 is 200.5 mm/s²; the machine allows 200 mm/s² at most.");
  recipe.accelY = 1e6; // outside the range anyway: said once
  ASSERT_EQ(check(recipe, machine).size(), 1u);
  EXPECT_EQ(check(recipe, machine)[0].code, Code::ValueOutOfRange);
}

TEST(RecipeCheck, PlacesAreFiniteAndNotAbsurd) {
  for (const PlaceField& field : placeFields()) {
    for (int axis = 0; axis < 2; ++axis) {
      for (const double value : {kNaN, kInfinity, 100000.5, -100000.5}) {
        Recipe recipe;
        recipe.*field.member = Eigen::Vector2d(5, 5);
        (*(recipe.*field.member))[axis] = value;
        ASSERT_EQ(check(recipe).size(), 1u) << field.key << " " << value;
        EXPECT_THAT(describe(check(recipe)[0]), HasSubstr(std::string(field.key) + (axis == 0 ? " (x)" : " (y)")));
      }
    }
  }
}

TEST(MachineCheck, EveryNumberIsFiniteAndInItsRange) {
  for (const MachineNumberField& field : machineNumberFields()) {
    for (const double value :
         {std::nextafter(field.least, -kInfinity), std::nextafter(field.most, kInfinity), -1.0, kNaN, kInfinity}) {
      Machine machine;
      machine.*field.member = value;
      ASSERT_EQ(check(machine).size(), 1u) << field.key << " " << value;
      EXPECT_THAT(describe(check(machine)[0]), HasSubstr(std::string(field.key)));
    }
  }
  for (const MachineAxesField& field : machineAxesFields()) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double value : {std::nextafter(field.least, -kInfinity), -1.0, 1e12, kNaN, kInfinity}) {
        Machine machine;
        (machine.*field.member)[axis] = value;
        ASSERT_FALSE(check(machine).empty()) << field.key << " " << value;
        EXPECT_THAT(describe(check(machine)[0]), HasSubstr(std::string(field.key)));
      }
    }
  }
}

TEST(MachineCheck, TheServoPeriodIsFromAQuarterToTwentyMilliseconds) {
  for (const double period : {0.00025, 0.001, 0.02}) {
    Machine machine;
    machine.period = period;
    EXPECT_TRUE(check(machine).empty()) << period;
  }
  for (const double period : {0.00024, 0.021, 1.0}) { // 1: a period given in ms
    Machine machine;
    machine.period = period;
    EXPECT_EQ(check(machine).size(), 1u) << period;
  }
}

TEST(MachineCheck, TheParkPositionLiesInsideTheTravel) {
  Machine machine;
  machine.park = machine.travel;
  EXPECT_TRUE(check(machine).empty());
  machine.park.z() = 120.5;
  ASSERT_EQ(check(machine).size(), 1u);
  EXPECT_EQ(describe(check(machine)[0]), "park_mm (z) is 120.5 mm; it must be from 0 to 120 mm.");
}

} // namespace
} // namespace arris::recipe
