#include "core/files/whole_file.h"
#include "tests/support/scratch.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <clocale>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

namespace arris::files {
namespace {

using std::filesystem::path;
using std::filesystem::perms;
using testing::HasSubstr;

std::string contentOf(const path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::size_t filesIn(const path& folder) {
  return static_cast<std::size_t>(
      std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
}

std::string reasonOf(const base::Expected<void>& written) {
  return written ? "written" : describe(written.error());
}

TEST(WholeFile, WritesAllPiecesInTheirOrder) {
  const test::Scratch scratch;
  const path file = scratch / "a.csv";
  const auto written = writeWholeFile(file, [](Output& output) {
    for (int i = 0; i < 1000; ++i) {
      output.write(std::to_string(i) + "\n");
    }
  });
  ASSERT_TRUE(written) << reasonOf(written);
  EXPECT_EQ(contentOf(file).substr(0, 8), "0\n1\n2\n3\n");
  EXPECT_EQ(contentOf(file).size(), 3890u);
  EXPECT_EQ(filesIn(file.parent_path()), 1u);
}

TEST(WholeFile, TakesTheOldFilesPlaceAndKeepsItsPermissions) {
  const test::Scratch scratch;
  const path file = scratch / "a.json";
  ASSERT_TRUE(writeWholeFile(file, "a longer old text"));
  std::filesystem::permissions(file, perms::owner_read | perms::owner_write | perms::group_read);
  ASSERT_TRUE(writeWholeFile(file, "new"));
  EXPECT_EQ(contentOf(file), "new");
  EXPECT_EQ(std::filesystem::status(file).permissions(), perms::owner_read | perms::owner_write | perms::group_read);
}

TEST(WholeFile, ANewFileHasThePermissionsThatTheUserMaskAllows) {
  const test::Scratch scratch;
  const mode_t before = umask(022);
  ASSERT_TRUE(writeWholeFile(scratch / "a", "text"));
  umask(before);
  EXPECT_EQ(static_cast<int>(std::filesystem::status(scratch / "a").permissions()), 0644);
}

TEST(WholeFile, FollowsLinksAndLeavesThemLinks) {
  const test::Scratch scratch;
  std::filesystem::create_directory(scratch / "folder");
  std::filesystem::create_symlink("folder/real.json", scratch / "link.json"); // does not exist yet
  std::filesystem::create_symlink(scratch / "link.json", scratch / "link of link.json");
  for (const char* text : {"first", "second"}) {
    ASSERT_TRUE(writeWholeFile(scratch / "link of link.json", text));
    EXPECT_TRUE(std::filesystem::is_symlink(scratch / "link.json"));
    EXPECT_FALSE(std::filesystem::is_symlink(scratch / "folder/real.json"));
    EXPECT_EQ(contentOf(scratch / "folder/real.json"), text);
  }
}

TEST(WholeFile, ALinkToItselfIsAnError) {
  const test::Scratch scratch;
  std::filesystem::create_symlink("loop", scratch / "loop");
  EXPECT_FALSE(writeWholeFile(scratch / "loop", "text"));
}

TEST(WholeFile, WritesToWhatIsNoRegularFileDirectly) {
  EXPECT_TRUE(writeWholeFile("/dev/null", "text"));
  testing::internal::CaptureStdout();
  ASSERT_TRUE(writeWholeFile("/dev/stdout", "to the standard output"));
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "to the standard output");
}

TEST(WholeFile, AFullDiskIsAnErrorWithItsReason) {
  EXPECT_EQ(reasonOf(writeWholeFile("/dev/full", "text")), "/dev/full cannot be written: No space left on device.");
}

TEST(WholeFile, AClosedPipeIsAnErrorAndDoesNotEndTheProgram) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  close(ends[0]);
  const std::string name = "/dev/fd/" + std::to_string(ends[1]);
  EXPECT_FALSE(writeWholeFile(name, "text"));
  close(ends[1]);
}

TEST(WholeFile, AFolderInTheFilesPlaceIsAnError) {
  const test::Scratch scratch;
  std::filesystem::create_directory(scratch / "a.json");
  EXPECT_THAT(reasonOf(writeWholeFile(scratch / "a.json", "text")), HasSubstr("cannot be written: Is a directory."));
  EXPECT_EQ(filesIn(scratch / "."), 1u);
}

TEST(WholeFile, AMissingFolderIsAnErrorInEveryLocaleInEnglish) {
  const test::Scratch scratch;
  ASSERT_NE(std::setlocale(LC_ALL, "de_DE.UTF-8"), nullptr);
  EXPECT_THAT(reasonOf(writeWholeFile(scratch / "missing/a.json", "text")), HasSubstr("No such file or directory"));
  std::setlocale(LC_ALL, "C");
}

// The next two limit the process, so each runs in one of its own.

int writeUnderAFileSizeLimit(const path& file) {
  const rlimit limit{4096, 4096};
  setrlimit(RLIMIT_FSIZE, &limit);
  const auto written = writeWholeFile(file, std::string(10000, 'x'));
  return !written && reasonOf(written).find("File too large") != std::string::npos ? 0 : 1;
}

TEST(WholeFileDeathTest, AFailureHalfwayLeavesTheOldFileWholeAndNoOther) {
  const test::Scratch scratch;
  ASSERT_TRUE(writeWholeFile(scratch / "a.csv", "old text"));
  EXPECT_EXIT(std::_Exit(writeUnderAFileSizeLimit(scratch / "a.csv")), testing::ExitedWithCode(0), "");
  EXPECT_EQ(contentOf(scratch / "a.csv"), "old text");
  EXPECT_EQ(filesIn(scratch / "."), 1u);
}

int writeAsSomebodyElse(const path& folder) {
  constexpr uid_t kNobody = 65534;
  if (geteuid() == 0 && (setgid(kNobody) != 0 || setuid(kNobody) != 0)) {
    return 2;
  }
  const auto newFile = writeWholeFile(folder / "closed/new.json", "text");
  const auto readOnly = writeWholeFile(folder / "open/read-only.json", "text");
  const bool refused = reasonOf(newFile).find("Permission denied") != std::string::npos &&
                       reasonOf(readOnly).find("Permission denied") != std::string::npos;
  const auto unreadable = readFile(folder / "open/unreadable.json");
  return refused && !unreadable && unreadable.error().code == base::Code::CannotOpen ? 0 : 1;
}

TEST(WholeFileDeathTest, WhatTheUserMayNotWriteOrReadIsRefused) {
  const test::Scratch scratch;
  std::filesystem::create_directory(scratch / "closed");
  std::filesystem::create_directory(scratch / "open");
  ASSERT_TRUE(writeWholeFile(scratch / "open/read-only.json", "old text"));
  ASSERT_TRUE(writeWholeFile(scratch / "open/unreadable.json", "secret"));
  std::filesystem::permissions(scratch / "open/read-only.json", perms::owner_read | perms::others_read);
  std::filesystem::permissions(scratch / "open/unreadable.json", perms::none);
  std::filesystem::permissions(scratch / "closed", perms::owner_read | perms::owner_exec | perms::others_exec);
  std::filesystem::permissions(scratch / "open", perms::all);
  std::filesystem::permissions(scratch / ".", perms::all);
  EXPECT_EXIT(std::_Exit(writeAsSomebodyElse(scratch / ".")), testing::ExitedWithCode(0), "");
  EXPECT_EQ(contentOf(scratch / "open/read-only.json"), "old text");
  EXPECT_EQ(filesIn(scratch / "open"), 2u);
  std::filesystem::permissions(scratch / "closed", perms::owner_all);
}

TEST(ReadFile, GivesEveryByte) {
  const test::Scratch scratch;
  std::string bytes;
  for (int i = 0; i < 3'000'000; ++i) {
    bytes += static_cast<char>(i % 256);
  }
  ASSERT_TRUE(writeWholeFile(scratch / "bytes", bytes));
  const auto read = readFile(scratch / "bytes");
  ASSERT_TRUE(read);
  EXPECT_TRUE(*read == bytes);
  EXPECT_EQ(readFile("/dev/null").value(), "");
}

TEST(ReadFile, WhatIsMissingOrAFolderIsAnErrorWithItsReason) {
  const test::Scratch scratch;
  EXPECT_EQ(describe(readFile("/nowhere/a.dxf").error()),
            "/nowhere/a.dxf cannot be opened: No such file or directory.");
  EXPECT_THAT(describe(readFile(scratch / ".").error()), HasSubstr("cannot be read: Is a directory."));
}

TEST(ReadFile, ANamedPipeIsReadToItsEndAndNotWaitedForWhereNobodyWrites) {
  const test::Scratch scratch;
  const std::filesystem::path pipe = scratch / "pipe.dxf";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(readFile(pipe).value(), "");
  const int end = open(pipe.c_str(), O_RDWR); // so that there is a writer from the first
  ASSERT_GE(end, 0);
  std::thread writer([end] {
    const std::string text(1'000'000, 'x');
    for (std::size_t sent = 0; sent < text.size();) {
      sent += static_cast<std::size_t>(write(end, text.data() + sent, text.size() - sent));
    }
    close(end);
  });
  const std::string read = readFile(pipe).value();
  writer.join();
  EXPECT_EQ(read, std::string(1'000'000, 'x'));
}

TEST(ReadFile, AFileBeyondAllReasonIsRefusedUnread) {
  const test::Scratch scratch;
  ASSERT_TRUE(writeWholeFile(scratch / "sparse", ""));
  std::filesystem::resize_file(scratch / "sparse", kLargestFile + 1);
  EXPECT_THAT(describe(readFile(scratch / "sparse").error()), HasSubstr("cannot be read: File too large."));
}

} // namespace
} // namespace arris::files
