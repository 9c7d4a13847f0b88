// Archives, also such as nobody means well with.

#include "core/files/bundle.h"
#include "core/files/whole_file.h"
#include "tests/support/scratch.h"

#include <archive.h>
#include <archive_entry.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <random>

namespace arris::files {
namespace {

namespace fs = std::filesystem;

/// An entry of a hostile archive.
struct Hostile {
  std::string name;
  unsigned type = AE_IFREG;
  std::string link; ///< symbolic, or hard where the type is that of a file
  std::string bytes = "text";
};

void writeHostile(const fs::path& file, const std::vector<Hostile>& entries) {
  archive* const writer = archive_write_new();
  archive_write_set_format_gnutar(writer);
  archive_write_add_filter_gzip(writer);
  ASSERT_EQ(archive_write_open_filename(writer, file.c_str()), ARCHIVE_OK);
  for (const Hostile& hostile : entries) {
    archive_entry* const entry = archive_entry_new();
    archive_entry_set_pathname(entry, hostile.name.c_str());
    archive_entry_set_filetype(entry, hostile.type);
    archive_entry_set_perm(entry, 0777);
    const bool hasBytes = hostile.type == AE_IFREG && hostile.link.empty();
    archive_entry_set_size(entry, hasBytes ? static_cast<la_int64_t>(hostile.bytes.size()) : 0);
    if (!hostile.link.empty() && hostile.type == AE_IFLNK) {
      archive_entry_set_symlink(entry, hostile.link.c_str());
    } else if (!hostile.link.empty()) {
      archive_entry_set_hardlink(entry, hostile.link.c_str());
    }
    ASSERT_EQ(archive_write_header(writer, entry), ARCHIVE_OK) << archive_error_string(writer);
    if (hasBytes) {
      archive_write_data(writer, hostile.bytes.data(), hostile.bytes.size());
    }
    archive_entry_free(entry);
  }
  ASSERT_EQ(archive_write_close(writer), ARCHIVE_OK);
  archive_write_free(writer);
}

void putBundle(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

std::string complaintAbout(const fs::path& file, const BundleLimits& limits = {}) {
  const auto read = readBundle(file, limits);
  return read ? "it was taken" : describe(read.error());
}

const BundledFiles& someFiles() {
  static const BundledFiles kFiles = {{"machine.json", "{}\n"},
                                      {"recipes/Tür 玻璃.json", std::string(100'000, 'x')},
                                      {"recipes/" + std::string(240, 'n') + ".json", ""},
                                      {"bytes", std::string("\0\xFF\n", 3)}};
  return kFiles;
}

TEST(Bundle, GivesBackItsFilesByteByByteWhateverTheirNames) {
  const test::Scratch scratch;
  ASSERT_TRUE(writeBundle(scratch / "a.tar.gz", someFiles()));
  EXPECT_EQ(readBundle(scratch / "a.tar.gz"), someFiles());
}

TEST(Bundle, CutOffAnywhereIsRefusedOrWhole) {
  const test::Scratch scratch;
  ASSERT_TRUE(writeBundle(scratch / "a", someFiles()));
  const std::string whole = readFile(scratch / "a").value();
  int refused = 0;
  for (std::size_t length = 0; length < whole.size(); length += 1 + length / 50) {
    putBundle(scratch / "cut", whole.substr(0, length));
    const auto read = readBundle(scratch / "cut");
    refused += read ? 0 : 1;
    if (read && !read->empty()) { // what is missing stands to the reader's check of fingerprints
      EXPECT_LE(read->size(), someFiles().size());
    }
  }
  EXPECT_GT(refused, 20);
}

TEST(Bundle, DamagedBytesDoNoHarm) {
  const test::Scratch scratch;
  ASSERT_TRUE(writeBundle(scratch / "a", someFiles()));
  const std::string whole = readFile(scratch / "a").value();
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    std::string bytes = whole;
    for (int i = 0; i < 3; ++i) {
      bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
    }
    putBundle(scratch / "damaged", bytes);
    static_cast<void>(readBundle(scratch / "damaged"));
  }
}

TEST(Bundle, WhatIsNoArchiveIsRefused) {
  const test::Scratch scratch;
  putBundle(scratch / "text", "This is a letter to somebody.\n");
  putBundle(scratch / "png", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16));
  for (const char* name : {"text", "png"}) {
    EXPECT_THAT(complaintAbout(scratch / name), testing::HasSubstr("it is no archive of Arris")) << name;
  }
  EXPECT_THAT(complaintAbout(scratch / "absent"), testing::HasSubstr("cannot be opened: No such file"));
  EXPECT_THAT(complaintAbout(scratch / "."), testing::HasSubstr("cannot be"));
}

TEST(Bundle, LinksFoldersAndDevicesAreRefused) {
  const test::Scratch scratch;
  const std::vector<Hostile> kinds = {{"machine.json", AE_IFLNK, "/etc/passwd"},
                                      {"machine.json", AE_IFREG, "recipe.json"},
                                      {"recipes/", AE_IFDIR, ""},
                                      {"machine.json", AE_IFIFO, ""},
                                      {"machine.json", AE_IFCHR, ""}};
  for (const Hostile& hostile : kinds) {
    writeHostile(scratch / "a", {hostile});
    EXPECT_THAT(complaintAbout(scratch / "a"), testing::HasSubstr("is no plain file")) << hostile.type;
  }
}

TEST(Bundle, AFileThatStandsTwiceIsRefused) {
  const test::Scratch scratch;
  writeHostile(scratch / "a", {{"machine.json", AE_IFREG, "", "one"}, {"machine.json", AE_IFREG, "", "two"}});
  EXPECT_THAT(complaintAbout(scratch / "a"), testing::HasSubstr("machine.json stands there twice"));
}

TEST(Bundle, ABombGoesOffNowhere) {
  const test::Scratch scratch;
  BundleLimits limits;
  limits.file = 1'000'000;
  limits.all = 3'000'000;
  limits.files = 10;
  const std::string large(2'000'000, '\0'); // two thousand bytes in the archive
  const std::string half(900'000, '\0');
  writeHostile(scratch / "large", {{"machine.json", AE_IFREG, "", large}});
  std::vector<Hostile> several;
  std::vector<Hostile> many;
  for (int i = 0; i < 11; ++i) {
    const std::string name = "recipes/" + std::to_string(i) + ".json";
    many.push_back({name, AE_IFREG, "", "x"});
    if (i < 5) {
      several.push_back({name, AE_IFREG, "", half});
    }
  }
  writeHostile(scratch / "several", several);
  writeHostile(scratch / "many", many);
  putBundle(scratch / "long", std::string(limits.archive + 1, '\0'));
  for (const char* name : {"large", "several", "many", "long"}) {
    EXPECT_THAT(complaintAbout(scratch / name, limits), testing::HasSubstr("larger than a back-up can be")) << name;
  }
}

TEST(Bundle, WhatCannotBeWrittenLeavesNothing) {
  const test::Scratch scratch;
  const auto written = writeBundle(scratch / "absent/a.tar.gz", someFiles());
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, base::Code::CannotWrite);
  EXPECT_EQ(describe(writeBundle("/dev/full", someFiles()).error()),
            "/dev/full cannot be written: No space left on device.");
}

} // namespace
} // namespace arris::files
