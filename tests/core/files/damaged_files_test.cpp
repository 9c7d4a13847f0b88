// Files that a power failure, a bad disk or a person has changed are read or refused: without a crash, without end and
// in little memory, and what is read lies in its ranges.

#include "core/files/alarm_log.h"
#include "core/files/file_hash.h"
#include "core/files/resume_point.h"
#include "core/files/row_coding.h"
#include "core/files/run_record.h"
#include "core/files/whole_file.h"
#include "core/recipe/fields.h"
#include "tests/support/limited_process.h"
#include "tests/support/mutation.h"
#include "tests/support/panes.h"
#include "tests/support/run_rows.h"
#include "tests/support/scratch.h"

#include <boost/crc.hpp>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace arris::files {
namespace {

constexpr unsigned kMostSeconds = 60;
constexpr unsigned kMostMegabytes = 500;

/// Counts what became of the files; a broken promise ends it.
struct Readings {
  int refused = 0;
  int read = 0;
  std::string broken;
};

std::string textOf(const Readings& readings) {
  return readings.broken.empty() ? fmt::format("{} {}", readings.read > 100, readings.refused > 100) : readings.broken;
}

void expectHarmless(const std::function<Readings()>& work) {
  const test::Outcome outcome = test::inLimitedProcess(kMostSeconds, kMostMegabytes, [&] { return textOf(work()); });
  EXPECT_TRUE(outcome.ended) << outcome.failure;
  EXPECT_EQ(outcome.text, "true true"); // many were read, many refused
}

void overwrite(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

bool isInRange(const recipe::Recipe& recipe, const recipe::Machine& machine) {
  return !hasErrors(check(recipe)) && !hasErrors(check(machine));
}

std::string soundPoint() {
  ResumePoint point;
  point.patternFile = "pane.dxf";
  point.patternHash = fileHash("a drawing");
  point.recipe.layers = {"GLASS", "CUT"};
  point.place = {17, 123.456};
  point.position = {10, 20.5, 46};
  point.contour = 1;
  point.time = 45.6;
  point.pane = 2;
  point.panes = 5;
  return writeResumePoint(point);
}

TEST(DamagedResumePoint, IsRefusedOrInItsRanges) {
  expectHarmless([] {
    Readings readings;
    test::Dice dice(1);
    for (int round = 0; round < 4000 && readings.broken.empty(); ++round) {
      const std::string text = mutated(soundPoint(), dice);
      const auto read = readResumePoint(text, "resume.json");
      if (hasErrors(read.problems)) {
        ++readings.refused;
        continue;
      }
      ++readings.read;
      const ResumePoint& point = read.value;
      const bool isSound = isInRange(point.recipe, point.machine) && isFileHash(point.patternHash) &&
                           point.place.segment >= -1 && point.place.lambda >= 0 && point.position.allFinite() &&
                           point.contour >= 0 && point.time >= 0 && point.pane >= 1 && point.panes >= point.pane &&
                           readResumePoint(writeResumePoint(point), "").value == point;
      readings.broken = isSound ? "" : text;
    }
    return readings;
  });
}

constexpr std::size_t kRecordMagicSize = 11;
constexpr std::size_t kHeadSize = 9; ///< of a block: kind, length, checksum

// Checksums that fit to whatever now stands in the blocks, so that damage gets past them.
void seal(std::string& record) {
  const auto number = [&](std::size_t at) {
    std::uint32_t result = 0;
    for (std::size_t i = 4; i-- > 0;) {
      result = result << 8U | static_cast<unsigned char>(record[at + i]);
    }
    return result;
  };
  for (std::size_t at = kRecordMagicSize; at + kHeadSize <= record.size();) {
    const std::size_t length = std::min<std::size_t>(number(at + 1), record.size() - at - kHeadSize);
    for (std::size_t i = 0; i < 4; ++i) {
      record[at + 1 + i] = static_cast<char>(length >> 8 * i);
    }
    boost::crc_32_type crc;
    crc.process_bytes(record.data() + at, 5);
    crc.process_bytes(record.data() + at + kHeadSize, length);
    for (std::size_t i = 0; i < 4; ++i) {
      record[at + 5 + i] = static_cast<char>(crc.checksum() >> 8 * i);
    }
    at += kHeadSize + length;
  }
}

std::string soundRecord(const std::filesystem::path& file) {
  const job::Job job = job::planJob(test::triangle600(), recipe::Recipe{}, recipe::Machine{});
  auto writer = RecordWriter::open(file, {"pane.dxf", fileHash("a drawing"), "2031-05-06T07:08:09", 3, {}, {}});
  const std::vector<RunRow> rows = test::runOf(job);
  for (std::size_t i = 0; i < 120; ++i) {
    EXPECT_TRUE(writer->add(rows[i + 20000]));
    if (i % 40 == 0) {
      EXPECT_TRUE(writer->add(RunEvent{rows[i + 20000].row.time, "override", {{"percent", 80.0}}}));
      EXPECT_TRUE(writer->flush());
    }
  }
  EXPECT_TRUE(writer->close());
  return readFile(file).value();
}

bool isSound(const RunRecord& record) {
  const auto increases = [](const RunRow& a, const RunRow& b) { return a.row.time < b.row.time; };
  return isInRange(record.header.recipe, record.header.machine) && record.header.pane >= 1 &&
         record.header.pane <= kMostPanes && record.rows.size() <= 10 * kMostRowsOfBlock &&
         std::all_of(record.rows.begin(), record.rows.end(), [](const RunRow& r) { return checkRow(r).has_value(); }) &&
         std::is_sorted(record.rows.begin(), record.rows.end(), increases) &&
         std::all_of(record.events.begin(), record.events.end(),
                     [](const RunEvent& event) { return std::abs(event.time) <= kMostRecorded; }) &&
         record.complete == record.damage.empty();
}

TEST(DamagedRecord, IsRefusedOrInItsRangesAlsoWhereItsChecksumsFit) {
  const test::Scratch scratch;
  const std::string whole = soundRecord(scratch / "whole.arrisrun");
  expectHarmless([&] {
    Readings readings;
    test::Dice dice(2);
    for (int round = 0; round < 3000 && readings.broken.empty(); ++round) {
      std::string bytes = mutated(whole, dice);
      if (round % 4 != 0) {
        seal(bytes);
      }
      overwrite(scratch / "a.arrisrun", bytes);
      const auto read = readRecord(scratch / "a.arrisrun");
      ++(read ? readings.read : readings.refused);
      readings.broken = read && !isSound(*read) ? fmt::format("round {}", round) : "";
    }
    return readings;
  });
}

TEST(DamagedAlarmLog, GivesTheAlarmsOfItsSoundLines) {
  const test::Scratch scratch;
  const std::filesystem::path log = scratch / "alarms.jsonl";
  for (int i = 0; i < 6; ++i) {
    ASSERT_TRUE(appendAlarm(log, {fmt::format("2031-05-06T07:08:{:02}", i),
                                  "following-error",
                                  "X stands 2 mm away.",
                                  {{"axis", std::string("X")}, {"value", 2.5}},
                                  i % 2 == 0}));
  }
  const std::string whole = readFile(log).value();
  expectHarmless([&] {
    Readings readings;
    test::Dice dice(3);
    for (int round = 0; round < 3000 && readings.broken.empty(); ++round) {
      const std::string text = mutated(whole, dice);
      overwrite(log, text);
      const auto alarms = readAlarms(log);
      const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
      readings.broken = alarms && alarms->size() <= lines ? "" : text;
      ++(alarms && alarms->size() == 6 ? readings.read : readings.refused); // refused: some of them
    }
    return readings;
  });
}

} // namespace
} // namespace arris::files
