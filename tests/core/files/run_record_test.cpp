#include "core/files/file_hash.h"
#include "core/files/row_coding.h"
#include "core/files/run_record.h"
#include "core/files/whole_file.h"
#include "core/recipe/fields.h"
#include "tests/support/dice.h"
#include "tests/support/lines_of.h"
#include "tests/support/panes.h"
#include "tests/support/run_rows.h"
#include "tests/support/scratch.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <random>

namespace arris::files {
namespace {

using base::Code;
using std::filesystem::path;
using testing::HasSubstr;

RecordHeader headerOfARun() {
  RecordHeader header{"Scheibe 1 玻璃.dxf", fileHash("a drawing"), "2031-05-06T07:08:09+02:00", 7, {}, {}};
  for (const auto& field : recipe::numberFields()) {
    header.recipe.*field.member = field.least + 0.3 * (field.most - field.least);
  }
  header.recipe.layers = {"GLASS"};
  header.machine.park = {1, 2, 3};
  return header;
}

Eigen::Vector3d vectorUpTo(test::Dice& dice, double most) {
  const double size = dice.logBetween(1e-12, most);
  return {dice.between(-size, size), dice.between(-size, size), dice.between(-size, size)};
}

std::vector<RunRow> randomRows(std::uint64_t seed, int count, double most) {
  test::Dice dice(seed);
  std::vector<RunRow> rows(static_cast<std::size_t>(count));
  constexpr std::array<std::string_view, 4> kPhases{"cruise", "hold", "dwell", "step"};
  double time = 0;
  for (RunRow& run : rows) {
    run.row = {time,
               vectorUpTo(dice, most),
               vectorUpTo(dice, most),
               vectorUpTo(dice, most),
               dice.between(0, most),
               dice.between(0, most),
               static_cast<int>(dice.between(0, 9)),
               static_cast<int>(dice.between(0, 2e9)),
               kPhases.at(static_cast<std::size_t>(dice.between(0, 4))),
               static_cast<int>(dice.between(0, 3)),
               dice.between(0, most)};
    run.commanded = vectorUpTo(dice, most);
    run.measuredVelocity = vectorUpTo(dice, most);
    time += dice.logBetween(2e-9, 10);
  }
  return rows;
}

std::vector<double> numbersOf(const RunRow& run) {
  const ProfileRow& row = run.row;
  std::vector<double> numbers{row.time, row.speed, row.path, row.corner != 0 ? row.distance : 0};
  for (const Eigen::Vector3d& v : {row.position, row.velocity, row.acceleration, run.commanded, run.measuredVelocity}) {
    numbers.insert(numbers.end(), v.begin(), v.end());
  }
  return numbers;
}

// As recorded: to half a unit, or to the rounding of a double where that is more.
bool areSame(const RunRow& a, const RunRow& b) {
  const std::vector<double> x = numbersOf(a);
  const std::vector<double> y = numbersOf(b);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(std::abs(x[i] - y[i]) <= 0.5001 * kRecordUnit + 3e-16 * std::abs(x[i]))) {
      return false;
    }
  }
  return a.row.contour == b.row.contour && a.row.segment == b.row.segment && a.row.corner == b.row.corner &&
         a.row.phase == b.row.phase;
}

bool areSame(const std::vector<RunRow>& a, const std::vector<RunRow>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const RunRow& x, const RunRow& y) { return areSame(x, y); });
}

// Without waiting for the disk.
void putBytes(const path& file, const std::string& bytes) {
  std::ofstream stream(file, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

std::string outcomeOf(const base::Expected<RunRecord>& read) {
  return read ? "read" : describe(read.error());
}

void addAll(RecordWriter& writer, const std::vector<RunRow>& rows) {
  for (const RunRow& row : rows) {
    const auto added = writer.add(row);
    ASSERT_TRUE(added) << describe(added.error());
  }
}

TEST(RunRecord, GivesBackWhatWasWrittenToTheUnit) {
  const test::Scratch scratch;
  const std::vector<RunEvent> events{{1.5, "override", {{"percent", 50.0}}},
                                     {-0.5, "fault", {{"axis", std::string("X")}, {"count", std::int64_t{3}}}},
                                     {1e6, "pane-done", {}}};
  for (const double most : {1.0, 1e3, 1e9}) {
    const path file = scratch / fmt::format("{}.arrisrun", most).c_str();
    const auto rows = randomRows(1, 5000, most);
    auto writer = RecordWriter::open(file, headerOfARun());
    ASSERT_TRUE(writer) << describe(writer.error());
    addAll(*writer, rows);
    for (const RunEvent& event : events) {
      ASSERT_TRUE(writer->add(event));
    }
    ASSERT_TRUE(writer->close());
    const auto read = readRecord(file);
    ASSERT_TRUE(read) << outcomeOf(read);
    EXPECT_TRUE(read->header == headerOfARun());
    EXPECT_TRUE(areSame(read->rows, rows)) << most;
    EXPECT_EQ(read->events, events);
    EXPECT_TRUE(read->complete);
    EXPECT_TRUE(read->damage.empty());
    EXPECT_TRUE(readRecordHeader(file).value() == headerOfARun());
  }
}

const job::Job& plannedPane() {
  static const job::Job kJob = job::planJob(test::triangle600(), {}, {});
  return kJob;
}

const std::vector<RunRow>& triangleRun() {
  static const std::vector<RunRow> kRows = test::runOf(plannedPane());
  return kRows;
}

void writeRun(const path& file, const std::vector<RunRow>& rows) {
  auto writer = RecordWriter::open(file, headerOfARun());
  ASSERT_TRUE(writer);
  addAll(*writer, rows);
  ASSERT_TRUE(writer->close());
}

TEST(RunRecord, TakesNoMoreThanFortyBytesAPeriod) {
  const test::Scratch scratch;
  writeRun(scratch / "a", triangleRun());
  const double perRow =
      static_cast<double>(std::filesystem::file_size(scratch / "a")) / static_cast<double>(triangleRun().size());
  RecordProperty("bytes_per_period", fmt::format("{:.2f}", perRow));
  EXPECT_LE(perRow, 40);
}

TEST(RunRecord, TheProfileFromItIsThatOfTheRunDigitForDigitOfTheContract) {
  const test::Scratch scratch;
  writeRun(scratch / "a", triangleRun());
  ASSERT_TRUE(writeWholeFile(scratch / "direct.csv", [&](Output& output) {
    RunProfileWriter writer(output);
    std::for_each(triangleRun().begin(), triangleRun().end(), [&](const RunRow& row) { writer.add(row); });
    writer.flush();
  }));
  ASSERT_TRUE(writeWholeFile(scratch / "record.csv",
                             [&](Output& output) { EXPECT_TRUE(writeProfile(scratch / "a", output)->complete); }));
  const std::string direct = readFile(scratch / "direct.csv").value();
  const std::string record = readFile(scratch / "record.csv").value();
  EXPECT_EQ(test::linesOf(record).front(), test::linesOf(direct).front());
  const auto expected = readProfile(direct, "direct.csv").value();
  const auto found = readProfile(record, "record.csv").value();
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_EQ(found[i].time, expected[i].time);
    ASSERT_EQ(found[i].position, expected[i].position);
    ASSERT_EQ(found[i].phase, expected[i].phase);
    ASSERT_LT((found[i].velocity - expected[i].velocity).cwiseAbs().maxCoeff(), 0.51e-9);
    ASSERT_LT((found[i].acceleration - expected[i].acceleration).cwiseAbs().maxCoeff(), 0.51e-9);
    ASSERT_NEAR(found[i].distance, expected[i].distance, 0.51e-9);
  }
}

/// A small record of five blocks of rows and two events, and where each of its blocks ends.
struct SmallRecord {
  std::string bytes;
  std::vector<std::size_t> ends;           ///< of what each flush wrote, the header first
  std::vector<std::vector<RunRow>> blocks; ///< what stands before the end of the same number
};

SmallRecord smallRecord() {
  const test::Scratch scratch;
  const path file = scratch / "small";
  SmallRecord result;
  const auto rows = randomRows(2, 20, 1000);
  auto writer = RecordWriter::open(file, headerOfARun()).value();
  const auto note = [&](std::vector<RunRow> block) {
    result.ends.push_back(std::filesystem::file_size(file));
    result.blocks.push_back(std::move(block));
  };
  note({});
  for (std::size_t i = 0; i < 5; ++i) {
    const std::vector<RunRow> block(rows.begin() + static_cast<std::ptrdiff_t>(4 * i),
                                    rows.begin() + static_cast<std::ptrdiff_t>(4 * i + 4));
    addAll(writer, block);
    EXPECT_TRUE(writer.flush());
    note(block);
  }
  for (const char* code : {"hold", "resume"}) {
    EXPECT_TRUE(writer.add(RunEvent{1, code, {{"percent", 10.0}}}));
    EXPECT_TRUE(writer.flush());
    note({});
  }
  EXPECT_TRUE(writer.close());
  note({});
  result.bytes = readFile(file).value();
  return result;
}

TEST(RunRecord, ThatBreaksOffAnywhereIsReadUpToItsLastWholeBlock) {
  const test::Scratch scratch;
  const SmallRecord small = smallRecord();
  for (std::size_t length = 0; length <= small.bytes.size(); ++length) {
    putBytes(scratch / "cut", small.bytes.substr(0, length));
    const auto read = readRecord(scratch / "cut");
    if (length < small.ends.front()) {
      ASSERT_FALSE(read) << length;
      ASSERT_EQ(read.error().code, Code::RecordMalformed);
      continue;
    }
    ASSERT_TRUE(read) << outcomeOf(read);
    std::vector<RunRow> expected;
    std::size_t wholeEnd = 0;
    for (std::size_t i = 0; i < small.ends.size() && small.ends[i] <= length; ++i) {
      expected.insert(expected.end(), small.blocks[i].begin(), small.blocks[i].end());
      wholeEnd = small.ends[i];
    }
    ASSERT_TRUE(areSame(read->rows, expected)) << length;
    ASSERT_EQ(read->complete, length == small.bytes.size());
    ASSERT_EQ(read->damage.size(), read->complete ? 0U : 1U);
    if (!read->complete) {
      ASSERT_EQ(describe(read->damage[0]),
                fmt::format("{} is not whole: it breaks off at byte {}. What can be read is used.",
                            (scratch / "cut").string(), wholeEnd));
    }
  }
}

TEST(RunRecord, EveryFlippedBitIsNoticedAndSpoilsItsBlockOnly) {
  const test::Scratch scratch;
  const SmallRecord small = smallRecord();
  for (std::size_t bit = 0; bit < 8 * small.bytes.size(); ++bit) {
    std::string bytes = small.bytes;
    const std::size_t at = bit / 8;
    bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ (1U << (bit % 8)));
    putBytes(scratch / "flipped", bytes);
    const auto read = readRecord(scratch / "flipped");
    if (at < small.ends.front()) {
      ASSERT_FALSE(read) << bit;
      continue;
    }
    ASSERT_TRUE(read) << outcomeOf(read);
    ASSERT_FALSE(read->complete);
    ASSERT_EQ(read->damage.size(), 1U);
    std::vector<RunRow> expected;
    constexpr std::size_t kHead = 9;
    for (std::size_t i = 1; i < small.ends.size(); ++i) {
      const bool isHit = at >= small.ends[i - 1] && at < small.ends[i];
      if (isHit && at < small.ends[i - 1] + kHead) { // its length may be hit: what follows may be lost
        break;
      }
      if (!isHit) {
        expected.insert(expected.end(), small.blocks[i].begin(), small.blocks[i].end());
      } else {
        const auto place = static_cast<std::int64_t>(small.ends[i - 1]);
        ASSERT_EQ(read->damage[0].values.at(2), (base::Value{"byte", place}));
      }
    }
    ASSERT_GE(read->rows.size(), expected.size()) << bit;
    ASSERT_TRUE(std::equal(expected.begin(), expected.end(), read->rows.begin(), [](const RunRow& a, const RunRow& b) {
      return areSame(a, b);
    })) << bit;
  }
}

// CRC-32 as in Ethernet and PNG, bit by bit.
std::uint32_t crcOf(std::string_view bytes) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xEDB88320 : 0);
    }
  }
  return ~crc;
}

std::string fourBytes(std::uint32_t number) {
  std::string bytes;
  for (unsigned shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>(number >> shift);
  }
  return bytes;
}

std::string sealed(char kind, const std::string& payload) {
  const std::string head = kind + fourBytes(static_cast<std::uint32_t>(payload.size()));
  return head + fourBytes(crcOf(head + payload)) + payload;
}

std::string magicAndHeader() {
  static const SmallRecord kRecord = smallRecord();
  return kRecord.bytes.substr(0, kRecord.ends.front());
}

TEST(RunRecord, IsMadeOfBlocksWithAStandardChecksum) {
  const SmallRecord small = smallRecord();
  const std::string header = magicAndHeader();
  constexpr std::size_t kMagicSize = 11;
  EXPECT_EQ(header.substr(0, kMagicSize), "\x89"
                                          "ARRISRUN\r\n");
  EXPECT_EQ(header.substr(kMagicSize), sealed('H', header.substr(kMagicSize + 9)));
  EXPECT_EQ(small.bytes.substr(small.ends.at(small.ends.size() - 2)), sealed('Z', ""));
  EXPECT_THAT(header, HasSubstr("\"arris_record\": 1"));
  EXPECT_THAT(header, HasSubstr("\"wheel_radius_mm\": "));
  EXPECT_THAT(header, HasSubstr("\"park_mm\": [1, 2, 3]"));
}

base::Expected<RunRecord> readBytes(const std::string& bytes) {
  const test::Scratch scratch;
  putBytes(scratch / "bytes", bytes);
  return readRecord(scratch / "bytes");
}

TEST(RunRecord, BlocksOfAKindFromTheFutureArePassedOver) {
  const auto read = readBytes(magicAndHeader() + sealed('Q', "?") + sealed('R', encodeRows(randomRows(3, 4, 1))) +
                              sealed('Z', "") + "whatever stands behind the end");
  ASSERT_TRUE(read) << outcomeOf(read);
  EXPECT_TRUE(read->complete);
  EXPECT_EQ(read->rows.size(), 4U);
}

TEST(RunRecord, SoundBlocksWithUnsoundContentsAreDamage) {
  const auto rows = randomRows(3, 8, 1);
  const std::string first = encodeRows(std::span(rows).first(4));
  for (const std::string& block :
       {sealed('R', ""), sealed('R', first + "x"), sealed('R', first.substr(0, first.size() - 1)), sealed('R', first),
        sealed('E', ""), sealed('E', "{}"), sealed('E', R"({"t_s": 1e300, "code": "hold", "values": {}})"),
        sealed('E', R"({"t_s": 1, "code": 7, "values": {}})"), sealed('E', std::string(1000, '['))}) {
    const auto read = readBytes(magicAndHeader() + sealed('R', first) + block +
                                sealed('R', encodeRows(std::span(rows).last(4))) + sealed('Z', ""));
    ASSERT_TRUE(read) << outcomeOf(read);
    EXPECT_FALSE(read->complete);
    EXPECT_EQ(read->damage.size(), 1U);
    EXPECT_TRUE(areSame(read->rows, rows)); // time would stand still where the first block comes twice
  }
}

TEST(RunRecord, HeadersThatAreNotOneAreRefused) {
  const std::string magic = magicAndHeader().substr(0, 11);
  const auto refusal = [&](const std::string& header) { return outcomeOf(readBytes(magic + sealed('H', header))); };
  EXPECT_THAT(refusal("{}"), HasSubstr("has no \"arris_record\""));
  EXPECT_THAT(refusal("{\"arris_record\": 2}"), HasSubstr("written by a newer Arris"));
  EXPECT_THAT(refusal("{\"arris_record\": 1}"), HasSubstr("pattern must be an object, not absent"));
  EXPECT_THAT(refusal("{"), HasSubstr("is not valid JSON"));
  EXPECT_THAT(outcomeOf(readBytes(magic)), HasSubstr("its header is damaged"));
  EXPECT_THAT(outcomeOf(readBytes(magic + sealed('R', "{}"))), HasSubstr("its header is damaged"));
  EXPECT_THAT(outcomeOf(readBytes("t_s,x_mm\n")), HasSubstr("is not the record of a run: it does not begin like one."));
  EXPECT_THAT(outcomeOf(readRecord("/nowhere/a")), HasSubstr("cannot be opened: No such file or directory."));
  EXPECT_THAT(outcomeOf(readRecord("/")), HasSubstr("cannot be read: Is a directory."));
}

std::string randomBytes(std::mt19937& random, std::size_t most) {
  std::string bytes(random() % (most + 1), '\0');
  std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<char>(random()); });
  return bytes;
}

TEST(RunRecord, RandomBytesAreReadOrRefusedWithoutHarm) {
  std::mt19937 random(4);
  for (int round = 0; round < 300; ++round) {
    std::string bytes = round % 3 == 0 ? "" : magicAndHeader();
    bytes += randomBytes(random, 300);
    if (round % 3 == 2) {
      bytes += sealed(round % 2 == 0 ? 'R' : 'E', randomBytes(random, 300));
    }
    const auto read = readBytes(bytes);
    EXPECT_EQ(read.has_value(), round % 3 != 0);
    EXPECT_FALSE(read && read->complete);
  }
}

TEST(RunRecord, RowsFromDamagedBytesAreFewAndFinite) {
  std::mt19937 random(5);
  const auto rows = randomRows(6, 30, 1e3);
  const std::string whole = encodeRows(rows);
  int decoded = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string bytes = round % 2 == 0 ? randomBytes(random, 200) : whole;
    for (int i = 0; i < 3 && !bytes.empty(); ++i) {
      bytes[random() % bytes.size()] = static_cast<char>(random());
    }
    const auto read = decodeRows(bytes);
    if (!read) {
      continue;
    }
    ++decoded;
    ASSERT_LE(read->size(), kMostRowsOfBlock);
    for (const RunRow& row : *read) {
      ASSERT_TRUE(checkRow(row));
    }
  }
  EXPECT_GT(decoded, 100);
}

TEST(RunRecord, ManyRowsOfNothingButZerosStayWithinABlocksBounds) {
  std::string zeros = "\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\x01"; // 2^64 - 1 rows
  for (int column = 0; column < 23; ++column) {
    zeros += std::string("\0\0", 2) + "\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\x01";
  }
  EXPECT_FALSE(decodeRows(zeros));
}

TEST(RecordWriter, TakesNoNumberThatIsNoneAndNoTimeThatStandsStill) {
  const test::Scratch scratch;
  auto writer = RecordWriter::open(scratch / "a", headerOfARun()).value();
  const auto rows = randomRows(7, 2, 1);
  ASSERT_TRUE(writer.add(rows[0]));
  for (const double wrong :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1.1e9}) {
    RunRow row = rows[1];
    row.measuredVelocity.z() = wrong;
    const auto added = writer.add(row);
    ASSERT_FALSE(added);
    EXPECT_THAT(describe(added.error()), HasSubstr("vz_meas_mm_s is "));
    EXPECT_FALSE(writer.add(RunEvent{wrong, "hold", {}}));
  }
  RunRow crawling = rows[1];
  crawling.row.phase = "crawl";
  EXPECT_FALSE(writer.add(crawling));
  RunRow negative = rows[1];
  negative.row.contour = -1;
  EXPECT_FALSE(writer.add(negative));
  EXPECT_FALSE(writer.add(rows[0])) << "the time stands still";
  EXPECT_FALSE(writer.add(RunEvent{1, std::string(2'000'000, 'x'), {}}));
  ASSERT_TRUE(writer.add(rows[1]));
  ASSERT_TRUE(writer.close());
  EXPECT_TRUE(areSame(readRecord(scratch / "a")->rows, rows));
}

TEST(RecordWriter, WritesOverNoFileAndIntoNoMissingFolder) {
  const test::Scratch scratch;
  ASSERT_TRUE(writeWholeFile(scratch / "a", "a former record"));
  EXPECT_THAT(describe(RecordWriter::open(scratch / "a", headerOfARun()).error()),
              HasSubstr("cannot be written: File exists."));
  EXPECT_EQ(readFile(scratch / "a").value(), "a former record");
  EXPECT_THAT(describe(RecordWriter::open(scratch / "missing/a", headerOfARun()).error()),
              HasSubstr("No such file or directory"));
}

TEST(RecordWriter, ThatIsNotClosedLeavesAllButTheLastSecond) {
  const test::Scratch scratch;
  const auto& rows = triangleRun();
  {
    auto writer = RecordWriter::open(scratch / "a", headerOfARun()).value();
    for (std::size_t i = 0; i < 2500; ++i) {
      ASSERT_TRUE(writer.add(rows[i]));
    }
  }
  const auto read = readRecord(scratch / "a").value();
  EXPECT_FALSE(read.complete);
  EXPECT_EQ(read.rows.size(), 2000U);
}

// Limits the process, so it runs in one of its own.
int recordUnderAFileSizeLimit(const path& file) {
  const rlimit limit{20000, 20000};
  setrlimit(RLIMIT_FSIZE, &limit);
  auto writer = RecordWriter::open(file, headerOfARun()).value();
  for (const RunRow& row : randomRows(8, 5000, 1000)) {
    if (const auto added = writer.add(row); !added) {
      const bool stays = !writer.flush() && !writer.close() && !writer.add(RunEvent{});
      return describe(added.error()).find("File too large") != std::string::npos && stays ? 0 : 1;
    }
    (void)writer.add(RunEvent{row.row.time, "hold", {}});
  }
  return 2;
}

TEST(RecordWriterDeathTest, AFullDiskIsAnErrorAndLeavesWhatWasWritten) {
  const test::Scratch scratch;
  const path file = scratch / "a";
  EXPECT_EXIT(std::_Exit(recordUnderAFileSizeLimit(file)), testing::ExitedWithCode(0), "");
  const auto read = readRecord(file);
  ASSERT_TRUE(read) << outcomeOf(read);
  EXPECT_FALSE(read->complete);
}

TEST(RunRecord, IsToldByItsFirstBytesWhateverItsName) {
  const test::Scratch scratch;
  ASSERT_TRUE(writeWholeFile(scratch / "a.csv", magicAndHeader()));
  ASSERT_TRUE(writeWholeFile(scratch / "b.arrisrun", "t_s,x_mm\n"));
  ASSERT_TRUE(writeWholeFile(scratch / "empty", ""));
  EXPECT_TRUE(isRecord(scratch / "a.csv"));
  for (const char* name : {"b.arrisrun", "empty", "missing", "."}) {
    EXPECT_FALSE(isRecord(scratch / name)) << name;
  }
}

} // namespace
} // namespace arris::files
