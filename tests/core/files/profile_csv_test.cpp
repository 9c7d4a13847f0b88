#include "core/base/numbers.h"
#include "core/files/profile_csv.h"
#include "tests/support/lines_of.h"
#include "tests/support/panes.h"
#include "tests/support/random_panes.h"
#include "tests/support/scratch.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <random>
#include <regex>

namespace arris::files {
namespace {

using base::Code;
using job::Job;
using testing::HasSubstr;

constexpr const char* kHeader = "t_s,x_mm,y_mm,z_mm,vx_mm_s,vy_mm_s,vz_mm_s,ax_mm_s2,ay_mm_s2,az_mm_s2,speed_mm_s,"
                                "path_mm,contour,segment,phase,corner,distance_mm";

const Job& plannedTriangle() {
  static const Job kJob = job::planJob(test::triangle600(), {}, {});
  return kJob;
}

std::string profileOf(const Job& job) {
  const test::Scratch scratch;
  const auto written = writeWholeFile(scratch / "a.csv", [&](Output& output) { writeProfile(job, output); });
  EXPECT_TRUE(written);
  return readFile(scratch / "a.csv").value_or("");
}

const std::string& triangleProfile() {
  static const std::string kText = profileOf(plannedTriangle());
  return kText;
}

std::vector<std::string> fieldsOf(const std::string& line) {
  std::vector<std::string> result{""};
  for (const char c : line) {
    if (c == ',') {
      result.emplace_back();
    } else {
      result.back() += c;
    }
  }
  return result;
}

std::string problemOf(const std::string& text) {
  const auto read = readProfile(text, "a.csv");
  return read ? "no problem" : describeWithPlace(read.error());
}

TEST(ProfileCsv, HasTheContractsHeaderAndOneRowPerPeriodAndOneAtTheExactEnd) {
  const std::vector<std::string> lines = test::linesOf(triangleProfile());
  EXPECT_EQ(lines.front(), kHeader);
  EXPECT_EQ(lines.size(), 1 + job::Sampler(plannedTriangle()).count());
  EXPECT_EQ(lines[1].substr(0, lines[1].find(",0,0,0,")), "0,0.000000000,0.000000000,120.000000000");
  for (std::size_t i = 1; i + 1 < lines.size(); ++i) { // no drift, no rounding noise in the time
    ASSERT_EQ(std::stod(lines[i]), std::stod(fmt::format("{}.{:03}", (i - 1) / 1000, (i - 1) % 1000)));
    ASSERT_LE(lines[i].find(','), 7U);
  }
  EXPECT_NEAR(base::parseNumber<double>(fieldsOf(lines.back())[0]).value_or(0), plannedTriangle().duration, 1e-9);
  EXPECT_EQ(triangleProfile().back(), '\n');
}

TEST(ProfileCsv, PositionsHaveNineDecimalsAndTheRestAtLeastNineSignificantDigits) {
  const std::regex position("-?[0-9]+\\.[0-9]{9}");
  job::Sampler sampler(plannedTriangle());
  const std::vector<std::string> lines = test::linesOf(triangleProfile());
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const job::Sample sample = sampler.next();
    if (i % 97 != 0) {
      continue;
    }
    const std::vector<std::string> fields = fieldsOf(lines[i]);
    const auto number = [&](std::size_t at) { return base::parseNumber<double>(fields.at(at)).value(); };
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_TRUE(std::regex_match(fields.at(1 + axis), position)) << fields.at(1 + axis);
      EXPECT_NEAR(number(1 + axis), sample.setPoint.position[static_cast<int>(axis)], 0.5001e-9);
    }
    const auto expectDigits = [&](std::size_t at, double value) {
      EXPECT_NEAR(number(at), value, std::max(1e-12, 0.5e-8 * std::abs(value)));
    };
    expectDigits(0, sample.setPoint.time);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      expectDigits(4 + axis, sample.setPoint.velocity[static_cast<int>(axis)]);
      expectDigits(7 + axis, sample.setPoint.axisAcceleration[static_cast<int>(axis)]);
    }
    expectDigits(10, sample.speed);
    expectDigits(11, sample.path);
    EXPECT_EQ(fields.at(14), job::name(sample.phase));
    EXPECT_EQ(fields.at(16).empty(), sample.corner == 0);
    if (sample.corner != 0) {
      expectDigits(16, sample.distance);
    }
  }
}

TEST(ProfileCsv, NeverShowsANegativeZero) {
  EXPECT_EQ(triangleProfile().find("-0.000000000,"), std::string::npos);
  EXPECT_EQ(triangleProfile().find(",-0,"), std::string::npos);
}

TEST(ProfileCsv, IsReadBackAsItWasWritten) {
  const auto rows = readProfile(triangleProfile(), "a.csv");
  ASSERT_TRUE(rows) << describeWithPlace(rows.error());
  job::Sampler sampler(plannedTriangle());
  ASSERT_EQ(rows->size(), sampler.count());
  for (const ProfileRow& row : *rows) {
    const job::Sample sample = sampler.next();
    ASSERT_NEAR(row.time, sample.setPoint.time, 1e-9);
    ASSERT_LT((row.position - sample.setPoint.position).norm(), 1e-9);
    ASSERT_LT((row.velocity - sample.setPoint.velocity).norm(), 1e-9);
    ASSERT_LT((row.acceleration - sample.setPoint.axisAcceleration).norm(), 1e-9);
    ASSERT_NEAR(row.speed, sample.speed, 1e-9);
    ASSERT_NEAR(row.path, sample.path, 1e-8);
    ASSERT_EQ(row.contour, sample.contour);
    ASSERT_EQ(row.segment, sample.segment);
    ASSERT_EQ(row.corner, sample.corner);
    ASSERT_EQ(row.phase, job::name(sample.phase));
    ASSERT_NEAR(row.distance, sample.distance, 1e-9);
  }
}

TEST(ProfileCsv, NoSecondDifferenceOfThePositionsIsAboveAnAxisLimit) {
  std::uint64_t seed = 4200;
  for (int i = 0; i < 5; ++i) {
    const Job job = i == 0 ? plannedTriangle() : test::randomJob(seed);
    const auto rows = readProfile(profileOf(job), "a.csv");
    ASSERT_TRUE(rows);
    const double period = job.machine.period;
    for (std::size_t k = 2; k + 1 < rows->size(); ++k) {
      const Eigen::Vector3d second =
          ((*rows)[k].position - 2 * (*rows)[k - 1].position + (*rows)[k - 2].position) / (period * period);
      for (int axis = 0; axis < 3; ++axis) {
        ASSERT_LE(std::abs(second[axis]), job.limits.acceleration[axis] + 0.002) << "at " << (*rows)[k].time << " s";
      }
    }
  }
}

TEST(ProfileCsv, IsTheSameInEveryLocale) {
  for (const char* locale : {"de_DE.UTF-8", "it_IT.UTF-8", "zh_CN.UTF-8"}) {
    ASSERT_NE(std::setlocale(LC_ALL, locale), nullptr) << locale;
    EXPECT_TRUE(profileOf(plannedTriangle()) == triangleProfile()) << locale;
    EXPECT_TRUE(readProfile(triangleProfile(), "a.csv").has_value()) << locale;
    std::setlocale(LC_ALL, "C");
  }
}

TEST(ProfileCsv, StopsAtAFullDiskAndTellsHowFarItIs) {
  double share = -1;
  const auto progress = [&](double now) {
    EXPECT_GT(now, share);
    share = now;
  };
  EXPECT_FALSE(writeWholeFile("/dev/full", [&](Output& output) { writeProfile(plannedTriangle(), output, progress); }));
  EXPECT_LT(share, 0.5);
  share = -1;
  EXPECT_TRUE(writeWholeFile("/dev/null", [&](Output& output) { writeProfile(plannedTriangle(), output, progress); }));
  EXPECT_GT(share, 0.8);
  EXPECT_LT(share, 1);
}

// A profile of two rows to spoil.
const std::string kSmall = std::string(kHeader) +
                           "\n0,1.000000000,2.000000000,3.000000000,4,5,0,6,7,0,8,9,1,2,cruise,0,\n"
                           "0.001,1.000000000,2.000000000,3.000000000,4,5,0,6,7,0,8,9,1,2,transition,3,75.5\n";

std::string with(const std::string& text, const std::string& old, const std::string& replacement) {
  std::string result = text;
  EXPECT_NE(result.find(old), std::string::npos) << old;
  return result.replace(result.find(old), old.size(), replacement);
}

TEST(ProfileCsv, ColumnsMayStandInAnyOrderAndOthersBesideThem) {
  const auto read = readProfile("note,distance_mm,corner,phase,segment,contour,path_mm,speed_mm_s,az_mm_s2,ay_mm_s2,"
                                "ax_mm_s2,vz_mm_s,vy_mm_s,vx_mm_s,z_mm,y_mm,x_mm,t_s,x_cmd_mm\r\n"
                                "hello,75.5,3,hold,2,1,9,8,-7,-6,-5,-4,-3,-2,-1,-0.5,1e3,0.5,nan\r\n",
                                "a.csv");
  ASSERT_TRUE(read) << describeWithPlace(read.error());
  const ProfileRow& row = read->at(0);
  EXPECT_EQ(row.time, 0.5);
  EXPECT_EQ(row.position, Eigen::Vector3d(1000, -0.5, -1));
  EXPECT_EQ(row.velocity, Eigen::Vector3d(-2, -3, -4));
  EXPECT_EQ(row.acceleration, Eigen::Vector3d(-5, -6, -7));
  EXPECT_EQ(row.speed, 8);
  EXPECT_EQ(row.path, 9);
  EXPECT_EQ(row.phase, "hold");
  EXPECT_EQ(row.distance, 75.5);
}

TEST(ProfileCsv, WhatIsNoProfileIsRefusedWithTheLine) {
  ASSERT_EQ(problemOf(kSmall), "no problem");
  const auto expectRefusal = [](const std::string& text, const std::string& place, const std::string& reason) {
    EXPECT_EQ(problemOf(text),
              fmt::format("error: line {}: a.csv is not a profile of Arris: {}. [csv-malformed]", place, reason));
  };
  expectRefusal("", "1", "the file is empty");
  expectRefusal("\n", "1", "the column t_s is missing");
  expectRefusal(std::string(kHeader) + "\n", "1", "it has no rows");
  expectRefusal(with(kSmall, "vx_mm_s", "vx"), "1", "the column vx_mm_s is missing");
  expectRefusal(with(kSmall, "distance_mm", "distance_mm,x_mm"), "1", "the column x_mm stands twice");
  expectRefusal(with(kSmall, ",cruise", ""), "2", "16 fields instead of 17");
  expectRefusal(with(kSmall, "75.5", "75.5,1"), "3", "18 fields instead of 17");
  expectRefusal(kSmall + "\n", "4", "1 fields instead of 17");
  expectRefusal(with(kSmall, "75.5", ""), "3", "distance_mm must be a finite number, not \"\"");
  expectRefusal(with(kSmall, "cruise,0,", "cruise,0,1"), "2", "distance_mm must be empty where corner is 0");
  expectRefusal(with(kSmall, "\n0,1.000000000", "\n0,nan"), "2", "x_mm must be a finite number, not \"nan\"");
  expectRefusal(with(kSmall, ",4,5,", ",inf,5,"), "2", "vx_mm_s must be a finite number, not \"inf\"");
  expectRefusal(with(kSmall, ",4,5,", ",4 ,5,"), "2", "vx_mm_s must be a finite number, not \"4 \"");
  expectRefusal(with(kSmall, "cruise", "crawl"), "2", "\"crawl\" is no phase");
  expectRefusal(with(kSmall, ",1,2,cruise", ",1.5,2,cruise"), "2",
                "contour must be a whole number from 0 on, not \"1.5\"");
  expectRefusal(with(kSmall, ",1,2,cruise", ",1,-2,cruise"), "2",
                "segment must be a whole number from 0 on, not \"-2\"");
  expectRefusal(with(kSmall, "\n0.001", "\n0"), "3", "the time does not increase");
}

TEST(ProfileCsv, CorruptedProfilesAreReadOrRefusedWithoutHarm) {
  std::mt19937 random(7);
  int refused = 0;
  for (int round = 0; round < 5000; ++round) {
    std::string text = kSmall;
    const std::size_t at = random() % text.size();
    if (round % 3 == 0) {
      text[at] = static_cast<char>(random() % 256);
    } else if (round % 3 == 1) {
      text.erase(at, 1 + random() % 40);
    } else {
      text.insert(at, text.substr(random() % text.size(), random() % 40));
    }
    refused += readProfile(text, "a.csv") ? 0 : 1;
  }
  EXPECT_GT(refused, 3000);
  EXPECT_LT(refused, 5000);
}

} // namespace
} // namespace arris::files
