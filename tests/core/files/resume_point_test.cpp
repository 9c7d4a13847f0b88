#include "core/files/file_hash.h"
#include "core/files/resume_point.h"
#include "core/files/whole_file.h"
#include "core/recipe/fields.h"
#include "tests/support/dice.h"
#include "tests/support/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace arris::files {
namespace {

using testing::HasSubstr;
using TestJson = nlohmann::ordered_json;

ResumePoint somewhere(test::Dice& dice) {
  ResumePoint point;
  point.patternFile = "/home/operator/Scheibe 1/玻璃.dxf";
  point.patternHash = fileHash(std::to_string(dice.between(0, 1)));
  for (const auto& field : recipe::numberFields()) {
    point.recipe.*field.member = dice.between(field.least, field.most);
  }
  for (const auto& field : recipe::choiceFields()) {
    field.set(point.recipe, static_cast<int>(field.words.size()) - 1);
  }
  point.recipe.start = {dice.between(0, 1500), dice.between(0, 2500)};
  point.recipe.layers = {"GLASS", "außen"};
  point.recipe.acceptUnreached = dice.chance(0.5);
  for (const auto& field : recipe::machineNumberFields()) {
    point.machine.*field.member = dice.between(field.least, field.most);
  }
  point.machine.jogEnableRequired = dice.chance(0.5);
  point.place = {static_cast<int>(dice.between(-1, 100'000)), dice.logBetween(1e-9, 1e6)};
  point.position = {dice.between(-10, 1510), dice.between(-10, 2510), dice.between(0, 120)};
  point.contour = static_cast<int>(dice.between(0, 50));
  point.time = dice.between(0, 1e5);
  point.pane = static_cast<int>(dice.between(1, 100));
  point.panes = point.pane + static_cast<int>(dice.between(0, 100));
  point.ended = static_cast<Ended>(static_cast<int>(dice.between(0, 6)));
  point.axes = dice.between(0, 1) < 0.5 ? Axes::Simulated : Axes::Linuxcnc;
  return point;
}

std::string problemsOf(const std::string& text) {
  std::string result;
  for (const base::Problem& problem : readResumePoint(text, "resume.json").problems) {
    result += describe(problem) + "\n";
  }
  return result;
}

// A sound point with one member set, or taken away.
std::string with(const std::string& pointer, const TestJson& value) {
  test::Dice dice(3);
  TestJson json = TestJson::parse(writeResumePoint(somewhere(dice)));
  json[TestJson::json_pointer(pointer)] = value;
  return json.dump();
}

std::string without(const std::string& key) {
  test::Dice dice(3);
  TestJson json = TestJson::parse(writeResumePoint(somewhere(dice)));
  json.erase(key);
  return json.dump();
}

TEST(ResumePoint, WhatIsWrittenIsReadBackExactly) {
  test::Dice dice(1);
  for (int round = 0; round < 200; ++round) {
    const ResumePoint point = somewhere(dice);
    const auto read = readResumePoint(writeResumePoint(point), "resume.json");
    ASSERT_FALSE(hasErrors(read.problems)) << problemsOf(writeResumePoint(point));
    ASSERT_TRUE(read.value == point);
  }
}

TEST(ResumePoint, OfTheFirstVersionIsOfAnyAxes) {
  const auto read = readResumePoint(without("axes"), "resume.json");
  EXPECT_TRUE(read.problems.empty());
  EXPECT_FALSE(read.value.axes);
}

TEST(ResumePoint, EveryAbsentValueIsAnErrorByName) {
  for (const char* key : {"pattern", "segment", "lambda_mm", "position_mm", "contour", "t_s", "pane", "panes", "ended",
                          "recipe", "machine"}) {
    EXPECT_THAT(problemsOf(without(key)), HasSubstr(std::string(key) + " must be ")) << key;
  }
  EXPECT_EQ(problemsOf(without("arris_resume")), "resume.json has no \"arris_resume\": it is not such a file.\n");
}

struct WrongValue {
  const char* name;
  const char* pointer;
  TestJson value;
  const char* sentence;
};

TEST(ResumePoint, EveryWrongValueIsToldWithItsRange) {
  const std::vector<WrongValue> rows{
      {"segment of another type", "/segment", 1.5, "segment must be a whole number from -1 to 2147483646, not 1.5."},
      {"segment below", "/segment", -2, "segment must be a whole number from -1 to 2147483646, not -2."},
      {"segment beyond int", "/segment", 1e10, "segment must be a whole number"},
      {"segment beyond 64 bits", "/segment", 18446744073709551615U, "not 18446744073709551615."},
      {"lambda below", "/lambda_mm", -0.001, "lambda_mm is -0.001 mm; it must be from 0 to 10000000 mm."},
      {"lambda above", "/lambda_mm", 1e300, "lambda_mm is 1e+300 mm; it must be from 0 to 10000000 mm."},
      {"lambda null", "/lambda_mm", nullptr, "lambda_mm must be a number in mm, not null."},
      {"position far away", "/position_mm/1", 100001,
       "position_mm is 100001 mm; it must be from -100000 to 100000 mm."},
      {"position too short", "/position_mm", {1, 2}, "position_mm must be [x, y, z] in mm, not [1,2]."},
      {"position of texts", "/position_mm/0", "1", "position_mm must be [x, y, z] in mm"},
      {"contour below", "/contour", -1, "contour must be a whole number from 0"},
      {"time below", "/t_s", -1, "t_s is -1 s; it must be from 0 to 1000000000 s."},
      {"pane below", "/pane", 0, "pane must be a whole number from 1 to 1000000, not 0."},
      {"fewer panes than the pane", "/panes", 0, "panes must be a whole number from "},
      {"ended somehow", "/ended", "tired",
       "ended is \"tired\"; it must be one of: running, held, stopped, fault, emergency-stop, interrupted."},
      {"axes of another kind", "/axes", "real", "axes is \"real\"; it must be one of: simulated, linuxcnc."},
      {"no fingerprint", "/pattern/hash", "0123", "hash must be a fingerprint of 16 digits, not \"0123\"."},
      {"no file", "/pattern/file", 7, "file must be a text, not 7."},
      {"pattern a text", "/pattern", "a.dxf", "pattern must be an object, not \"a.dxf\"."},
      {"recipe's value", "/recipe/depth_mm", 99, "depth_mm is 99 mm; it must be from 0 to 5 mm."},
      {"machine's value", "/machine/period_s", "x", "period_s must be a number in s, not \"x\"."},
  };
  for (const WrongValue& row : rows) {
    EXPECT_THAT(problemsOf(with(row.pointer, row.value)), HasSubstr(row.sentence)) << row.name;
  }
}

TEST(ResumePoint, AnUnknownKeyIsAWarningAndANewerVersionIsRefused) {
  const auto read = readResumePoint(with("/mood", "good"), "resume.json");
  ASSERT_EQ(read.problems.size(), 1U);
  EXPECT_EQ(read.problems[0].code, base::Code::UnknownKey);
  EXPECT_THAT(problemsOf(with("/arris_resume", 2)), HasSubstr("written by a newer Arris"));
}

TEST(ResumePoint, BrokenFilesAreRefusedWithoutHarm) {
  test::Dice dice(3);
  const std::string whole = writeResumePoint(somewhere(dice));
  for (std::size_t length = 0; length + 2 < whole.size(); ++length) {
    ASSERT_TRUE(hasErrors(readResumePoint(whole.substr(0, length), "resume.json").problems)) << length;
  }
}

// The process is killed while it writes one point after the other; whenever that is, a whole point is there.
TEST(ResumePointDeathTest, IsWholeWheneverTheProgramIsKilled) {
  const test::Scratch scratch;
  const std::filesystem::path file = scratch / "resume.json";
  test::Dice dice(5);
  ASSERT_TRUE(writeWholeFile(file, writeResumePoint(somewhere(dice))));
  for (int round = 0; round < 20; ++round) {
    const pid_t child = fork();
    if (child == 0) {
      for (;;) {
        (void)writeWholeFile(file, writeResumePoint(somewhere(dice)));
      }
    }
    usleep(static_cast<useconds_t>(dice.between(1000, 20000)));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    const auto read = readResumePoint(readFile(file).value(), "resume.json");
    ASSERT_FALSE(hasErrors(read.problems));
  }
}

} // namespace
} // namespace arris::files
