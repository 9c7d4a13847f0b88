#include "core/files/record_folder.h"
#include "core/files/whole_file.h"
#include "tests/support/scratch.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <set>

namespace arris::files {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

void makeFile(const fs::path& file, std::size_t size, int minute) {
  std::ofstream(file) << std::string(size, 'x');
  fs::last_write_time(file, fs::file_time_type(std::chrono::hours(100'000) + std::chrono::minutes(minute)));
}

std::set<std::string> namesIn(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

TEST(RecordFolder, NamesARecordByItsStartAndNeverByATakenName) {
  const test::Scratch scratch;
  const fs::path folder = scratch / ".";
  std::vector<std::string> names;
  for (int i = 0; i < 3; ++i) {
    const fs::path file = newRecordFile(folder, "2031-05-06T07:08:09+02:00");
    EXPECT_EQ(file.parent_path(), folder);
    names.push_back(file.filename().string());
    makeFile(file, 1, 0);
  }
  EXPECT_THAT(names, ElementsAre("run-2031-05-06T07-08-09+02-00.arrisrun", "run-2031-05-06T07-08-09+02-00-2.arrisrun",
                                 "run-2031-05-06T07-08-09+02-00-3.arrisrun"));
}

TEST(RecordFolder, ATimeStampCannotLeadOutOfTheFolder) {
  EXPECT_EQ(newRecordFile("/records", "../../etc/x y\n").string(), "/records/run-..-..-etc-x-y-.arrisrun");
}

TEST(RecordFolder, TakesNoNameOfALinkToNothing) {
  const test::Scratch scratch;
  fs::create_symlink("nowhere", scratch / "run-now.arrisrun");
  EXPECT_EQ(newRecordFile(scratch / ".", "now").filename(), "run-now-2.arrisrun");
}

TEST(RecordFolder, DropsTheOldestRecordsBeyondTheCount) {
  const test::Scratch scratch;
  for (int i = 0; i < 7; ++i) { // the names do not tell the age
    makeFile(scratch / fmt::format("run-{}.arrisrun", (i * 3) % 7).c_str(), 10, i);
  }
  ASSERT_TRUE(dropOldRecords(scratch / ".", 3));
  EXPECT_THAT(namesIn(scratch / "."), ElementsAre("run-1.arrisrun", "run-4.arrisrun", "run-5.arrisrun"));
}

TEST(RecordFolder, DropsTheOldestRecordsBeyondTheSize) {
  const test::Scratch scratch;
  for (int i = 0; i < 5; ++i) {
    makeFile(scratch / fmt::format("run-{}.arrisrun", i).c_str(), 100, i);
  }
  ASSERT_TRUE(dropOldRecords(scratch / ".", 100, 300));
  EXPECT_THAT(namesIn(scratch / "."), ElementsAre("run-2.arrisrun", "run-3.arrisrun", "run-4.arrisrun"));
  ASSERT_TRUE(dropOldRecords(scratch / ".", 100, 299));
  EXPECT_THAT(namesIn(scratch / "."), ElementsAre("run-3.arrisrun", "run-4.arrisrun"));
}

TEST(RecordFolder, TheNewestStaysHoweverLarge) {
  const test::Scratch scratch;
  makeFile(scratch / "run-old.arrisrun", 1, 0);
  makeFile(scratch / "run-new.arrisrun", 1000, 1);
  ASSERT_TRUE(dropOldRecords(scratch / ".", 0, 10));
  EXPECT_THAT(namesIn(scratch / "."), ElementsAre("run-new.arrisrun"));
}

TEST(RecordFolder, KeepsAHundredRecordsUnlessToldOtherwise) {
  const test::Scratch scratch;
  for (int i = 0; i < 103; ++i) {
    makeFile(scratch / fmt::format("run-{:03}.arrisrun", i).c_str(), 1, i);
  }
  ASSERT_TRUE(dropOldRecords(scratch / "."));
  EXPECT_EQ(namesIn(scratch / ".").size(), 100U);
  EXPECT_EQ(*namesIn(scratch / ".").begin(), "run-003.arrisrun");
}

TEST(RecordFolder, TouchesNothingElse) {
  const test::Scratch scratch;
  makeFile(scratch / "run-new.arrisrun", 1000, 9);
  makeFile(scratch / "run-a.csv", 1000, 1);
  makeFile(scratch / "kept.arrisrun", 1000, 2);
  fs::create_directory(scratch / "run-folder.arrisrun");
  fs::create_symlink("kept.arrisrun", scratch / "run-link.arrisrun");
  const auto before = namesIn(scratch / ".");
  ASSERT_TRUE(dropOldRecords(scratch / ".", 1, 1));
  EXPECT_EQ(namesIn(scratch / "."), before);
}

TEST(RecordFolder, AMissingFolderHasNoRecordsAndAFileInItsPlaceIsAnError) {
  const test::Scratch scratch;
  EXPECT_TRUE(dropOldRecords(scratch / "missing"));
  ASSERT_TRUE(writeWholeFile(scratch / "file", "text"));
  const auto dropped = dropOldRecords(scratch / "file");
  ASSERT_FALSE(dropped);
  EXPECT_EQ(dropped.error().code, base::Code::CannotRead);
}

} // namespace
} // namespace arris::files
