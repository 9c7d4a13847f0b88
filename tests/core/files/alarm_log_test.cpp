#include "core/files/alarm_log.h"
#include "core/files/whole_file.h"
#include "tests/support/lines_of.h"
#include "tests/support/scratch.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <random>

namespace arris::files {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Alarm alarmNumber(int number) {
  return {fmt::format("2031-05-06T07:08:{:09.6f}", number * 1e-6),
          "following-error",
          "The X axis is 1.25 mm behind.",
          {{"axis", std::string("X")}, {"error_mm", 1.25}, {"limit_mm", 1.0}, {"count", std::int64_t{3}}},
          false};
}

// Without waiting for the disk.
void putText(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream stream(file, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

std::vector<Alarm> alarmsIn(const std::filesystem::path& log) {
  const auto alarms = readAlarms(log);
  EXPECT_TRUE(alarms) << describe(alarms.error());
  return alarms.value_or(std::vector<Alarm>());
}

TEST(AlarmLog, GivesBackWhatWasAppendedInItsOrder) {
  const test::Scratch scratch;
  EXPECT_THAT(alarmsIn(scratch / "alarms.jsonl"), IsEmpty());
  ASSERT_TRUE(appendAlarm(scratch / "alarms.jsonl", alarmNumber(1)));
  ASSERT_TRUE(appendAlarm(scratch / "alarms.jsonl", alarmNumber(2)));
  EXPECT_THAT(alarmsIn(scratch / "alarms.jsonl"), ElementsAre(alarmNumber(1), alarmNumber(2)));
}

TEST(AlarmLog, IsOneObjectALine) {
  const test::Scratch scratch;
  Alarm alarm = alarmNumber(1);
  alarm.text = "two\nlines, \"quoted\", Glaskante, 玻璃, and no UTF-8: \xFF";
  ASSERT_TRUE(appendAlarm(scratch / "a", alarm));
  EXPECT_EQ(readFile(scratch / "a").value(),
            "{\"time\":\"2031-05-06T07:08:00.000001\",\"code\":\"following-error\",\"text\":\"two\\nlines, "
            "\\\"quoted\\\", Glaskante, 玻璃, and no UTF-8: \uFFFD\",\"values\":{\"axis\":\"X\",\"error_mm\":1.25,"
            "\"limit_mm\":1.0,\"count\":3},\"acknowledged\":false}\n");
}

TEST(AlarmLog, AnAcknowledgementTakesTheAlarmsPlace) {
  const test::Scratch scratch;
  for (const int number : {1, 2}) {
    ASSERT_TRUE(appendAlarm(scratch / "a", alarmNumber(number)));
  }
  Alarm acknowledged = alarmNumber(1);
  acknowledged.acknowledged = true;
  ASSERT_TRUE(appendAlarm(scratch / "a", acknowledged));
  EXPECT_THAT(alarmsIn(scratch / "a"), ElementsAre(acknowledged, alarmNumber(2)));
}

TEST(AlarmLog, TwoAxesMayFailInOneSecond) {
  const test::Scratch scratch;
  const std::filesystem::path log = scratch / "alarms.jsonl";
  Alarm x{"2031-05-06T07:08:09", "drive-fault", "The drive of X reports a fault.", {}};
  const Alarm y{"2031-05-06T07:08:09", "drive-fault", "The drive of Y reports a fault.", {}};
  ASSERT_TRUE(appendAlarm(log, x));
  ASSERT_TRUE(appendAlarm(log, y));
  x.acknowledged = true;
  ASSERT_TRUE(appendAlarm(log, x));
  EXPECT_EQ(readAlarms(log).value(), (std::vector{x, y}));
}

TEST(AlarmLog, AFigureThatIsNoNumberIsLeftOutAndTheAlarmIsKept) {
  const test::Scratch scratch;
  Alarm alarm = alarmNumber(1);
  alarm.values = {{"error_mm", std::numeric_limits<double>::quiet_NaN()},
                  {"limit_mm", std::numeric_limits<double>::infinity()},
                  {"count", std::int64_t{7}}};
  ASSERT_TRUE(appendAlarm(scratch / "a", alarm));
  alarm.values = {{"count", std::int64_t{7}}};
  EXPECT_THAT(alarmsIn(scratch / "a"), ElementsAre(alarm));
}

TEST(AlarmLog, AHalfLastLineIsPassedOverAndTakesNoOtherWithIt) {
  const test::Scratch scratch;
  ASSERT_TRUE(appendAlarm(scratch / "a", alarmNumber(1)));
  const std::string whole = readFile(scratch / "a").value();
  for (std::size_t length = 0; length + 1 < whole.size(); length += 7) { // without its line end it is whole
    putText(scratch / "a", whole + whole.substr(0, length));
    ASSERT_THAT(alarmsIn(scratch / "a"), ElementsAre(alarmNumber(1))) << length;
    ASSERT_TRUE(appendAlarm(scratch / "a", alarmNumber(2)));
    ASSERT_THAT(alarmsIn(scratch / "a"), ElementsAre(alarmNumber(1), alarmNumber(2))) << length;
    ASSERT_EQ(readAlarmLog(scratch / "a")->brokenLines, length == 0 ? 0 : 1) << length;
  }
}

TEST(AlarmLog, StaysBelowItsSizeAndKeepsTheYoungest) {
  const test::Scratch scratch;
  constexpr std::size_t kLargest = 10000;
  for (int i = 0; i < 200; ++i) {
    ASSERT_TRUE(appendAlarm(scratch / "a", alarmNumber(i), kLargest));
    ASSERT_LT(std::filesystem::file_size(scratch / "a"), kLargest);
  }
  const auto alarms = alarmsIn(scratch / "a");
  EXPECT_GT(alarms.size(), 20U);
  for (std::size_t i = 0; i < alarms.size(); ++i) { // the last ones, without a gap
    EXPECT_EQ(alarms[i], alarmNumber(200 - static_cast<int>(alarms.size() - i)));
  }
  EXPECT_EQ(kLargestAlarmLog, 10'000'000U);
}

TEST(AlarmLog, DamagedLogsAreReadWithoutHarm) {
  const test::Scratch scratch;
  for (int i = 0; i < 5; ++i) {
    ASSERT_TRUE(appendAlarm(scratch / "a", alarmNumber(i)));
  }
  const std::string whole = readFile(scratch / "a").value();
  std::mt19937 random(11);
  for (int round = 0; round < 500; ++round) {
    std::string text = whole;
    for (int i = 0; i < 3; ++i) {
      text[random() % text.size()] = static_cast<char>(random() % 256);
    }
    putText(scratch / "a", text);
    ASSERT_LE(alarmsIn(scratch / "a").size(), 8U); // three more line ends at most
  }
}

TEST(AlarmLog, WhatCannotBeWrittenOrReadIsAnErrorWithItsReason) {
  const test::Scratch scratch;
  const auto missing = appendAlarm(scratch / "missing/a", alarmNumber(1));
  ASSERT_FALSE(missing);
  EXPECT_THAT(describe(missing.error()), testing::HasSubstr("cannot be written: No such file or directory."));
  EXPECT_EQ(describe(appendAlarm("/dev/full", alarmNumber(1)).error()),
            "/dev/full cannot be written: No space left on device.");
  EXPECT_FALSE(readAlarms(scratch / "."));
}

} // namespace
} // namespace arris::files
