#include "core/control/alarms.h"

#include <gtest/gtest.h>

namespace arris::control {
namespace {

TEST(Alarms, EveryFaultComesBackFromTheLogWithItsAxisAndFigure) {
  for (const FaultInfo& row : allFaults()) {
    FaultReport fault{17, row.fault, -1, 0};
    fault.axis = row.text.find("{axis}") != std::string_view::npos ? 2 : -1;
    fault.value = row.text.find("{value}") != std::string_view::npos ? 1.25 : 0;
    const files::Alarm alarm = alarmOf(fault, "2031-05-06T07:08:09");
    EXPECT_EQ(alarm.code, row.name);
    EXPECT_EQ(alarm.text, describe(fault));
    EXPECT_FALSE(alarm.acknowledged);
    const auto back = faultOf(alarm);
    ASSERT_TRUE(back) << row.name;
    EXPECT_EQ(back->fault, fault.fault);
    EXPECT_EQ(back->axis, fault.axis);
    EXPECT_EQ(back->value, fault.value);
  }
}

TEST(Alarms, AStrangersLineIsNoFaultAndOddValuesDoNoHarm) {
  files::Alarm alarm{"2031-05-06T07:08:09", "of-a-later-arris", "Something new.", {}, false};
  EXPECT_FALSE(faultOf(alarm));
  alarm.code = "following-error";
  alarm.values = {{"axis", std::string("ABC")}, {"value", std::string("much")}};
  ASSERT_TRUE(faultOf(alarm));
  EXPECT_EQ(faultOf(alarm)->axis, -1);
  EXPECT_EQ(faultOf(alarm)->value, 0);
  alarm.values = {{"axis", std::string()}, {"value", std::int64_t{3}}};
  EXPECT_EQ(faultOf(alarm)->axis, -1);
  EXPECT_EQ(faultOf(alarm)->value, 3);
}

} // namespace
} // namespace arris::control
