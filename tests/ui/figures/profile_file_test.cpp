#include "core/files/whole_file.h"
#include "tests/support/panes.h"
#include "tests/ui/support/recorded_runs.h"
#include "ui/figures/profile_file.h"

#include <gtest/gtest.h>

#include <fstream>

namespace arris::ui {
namespace {

const job::Job& profiledJob() {
  static const job::Job kJob = job::planJob(test::triangle600(), {}, {});
  return kJob;
}

double greatestSpeed(const ProfileCurves& curves) {
  return curves.range[static_cast<std::size_t>(Panel::Speed)].second;
}

TEST(ProfileFile, IsReadFromAnExportedProfile) {
  const test::Scratch scratch;
  const ProfileReading reading = readProfileFile(test::profileOf(profiledJob(), scratch));
  ASSERT_TRUE(reading.curves) << describe(reading.curves.error());
  EXPECT_EQ(reading.curves->name, "profile.csv");
  EXPECT_NEAR(reading.curves->duration, profiledJob().duration, 1e-6);
  EXPECT_NEAR(greatestSpeed(*reading.curves), 60, 1e-3); // the feed of 3600 mm/min
  EXPECT_EQ(cornerPasses(*reading.curves).size(), 3U);
  EXPECT_TRUE(reading.damage.empty());
}

TEST(ProfileFile, IsReadFromTheRecordOfARunWhateverItIsCalled) {
  const test::Scratch scratch;
  const std::filesystem::path renamed = scratch / "run.csv";
  std::filesystem::rename(test::recordOf(profiledJob(), scratch), renamed);
  const ProfileReading reading = readProfileFile(renamed);
  ASSERT_TRUE(reading.curves) << describe(reading.curves.error());
  EXPECT_EQ(reading.curves->name, "run.csv");
  EXPECT_NEAR(reading.curves->duration, profiledJob().duration, 0.01);
  EXPECT_EQ(cornerPasses(*reading.curves).size(), 3U);
  EXPECT_TRUE(reading.damage.empty());
}

TEST(ProfileFile, IsReadAsFarAsItIsWholeAndSaysWhereItBreaksOff) {
  const test::Scratch scratch;
  const auto cut = test::cutAt(0.5, test::recordOf(profiledJob(), scratch), scratch);
  const ProfileReading reading = readProfileFile(cut);
  ASSERT_TRUE(reading.curves) << describe(reading.curves.error());
  EXPECT_GT(reading.curves->duration, 0.2 * profiledJob().duration);
  EXPECT_LT(reading.curves->duration, 0.8 * profiledJob().duration);
  ASSERT_EQ(reading.damage.size(), 1U);
  EXPECT_EQ(reading.damage.front().code, base::Code::RecordDamaged);
}

TEST(ProfileFile, ThatIsTooLargeIsNotRead) {
  const test::Scratch scratch;
  const std::filesystem::path file = scratch / "huge.csv";
  std::ofstream(file) << "t_s\n";
  std::filesystem::resize_file(file, files::kLargestFile + 1); // takes no room on the disk
  const ProfileReading reading = readProfileFile(file);
  ASSERT_FALSE(reading.curves);
  EXPECT_EQ(reading.curves.error().code, base::Code::CannotRead);
  EXPECT_NE(describe(reading.curves.error()).find("File too large"), std::string::npos);
}

TEST(ProfileFile, WhoseRowsAreNoLongerWantedIsReadWithoutThem) {
  const test::Scratch scratch;
  const ProfileReading reading = readProfileFile(test::recordOf(profiledJob(), scratch), [] { return false; });
  ASSERT_TRUE(reading.curves);
  EXPECT_TRUE(reading.curves->panels.front().isEmpty());
}

} // namespace
} // namespace arris::ui
