#include "tests/ui/support/recorded_runs.h"

#include "core/files/file_hash.h"
#include "core/files/profile_csv.h"
#include "core/files/run_record.h"
#include "tests/support/run_rows.h"

#include <gtest/gtest.h>

namespace arris::test {

std::filesystem::path recordOf(const job::Job& job, const Scratch& scratch) {
  std::filesystem::path file = scratch / "run.arrisrun";
  auto writer = files::RecordWriter::open(
      file, {"triangle.dxf", files::fileHash("a pane"), "2031-05-06T07:08:09Z", 1, job.recipe, job.machine});
  EXPECT_TRUE(writer);
  for (const files::RunRow& row : runOf(job)) {
    EXPECT_TRUE(writer->add(row));
  }
  EXPECT_TRUE(writer->close());
  return file;
}

std::filesystem::path profileOf(const job::Job& job, const Scratch& scratch) {
  std::filesystem::path file = scratch / "profile.csv";
  EXPECT_TRUE(files::writeWholeFile(file, [&](files::Output& output) { files::writeProfile(job, output); }));
  return file;
}

std::filesystem::path cutAt(double share, const std::filesystem::path& file, const Scratch& scratch) {
  std::filesystem::path cut = scratch / "cut.arrisrun";
  std::filesystem::copy_file(file, cut);
  std::filesystem::resize_file(
      cut, static_cast<std::uintmax_t>(share * static_cast<double>(std::filesystem::file_size(file))));
  return cut;
}

} // namespace arris::test
