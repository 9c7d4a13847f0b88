#include "tests/app/process.h"
#include "tests/support/scratch.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

namespace arris::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

namespace fs = std::filesystem;

const std::string kPane = sample("triangle.dxf");

// One line that names the file, and the status for what the system cannot do.
void expectOneLineAbout(const Outcome& outcome, const std::string& file) {
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr(file), testing::StartsWith("error: ")));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

void expectEmpty(const Scratch& scratch) {
  EXPECT_TRUE(fs::is_empty((scratch / "x").parent_path()));
}

TEST(Inputs, ThatAreMissingAreNamed) {
  const Scratch scratch;
  const std::string missing = (scratch / "missing").string();
  expectOneLineAbout(arris({"plan", missing}), missing);
  expectOneLineAbout(arris({"inspect", missing}), missing);
  expectOneLineAbout(arris({"plan", kPane, "--recipe", missing}), missing);
  expectOneLineAbout(arris({"plan", kPane, "--machine", missing}), missing);
  expectOneLineAbout(arris({"plot", missing, "-o", (scratch / "a.svg").string()}), missing);
  expectEmpty(scratch);
}

TEST(Inputs, ThatAreFoldersAreNamed) {
  const Scratch scratch;
  const std::string folder = (scratch / "x").parent_path().string();
  expectOneLineAbout(arris({"plan", folder}), folder);
  expectOneLineAbout(arris({"inspect", folder}), folder);
  expectOneLineAbout(arris({"plan", kPane, "--recipe", folder}), folder);
}

TEST(Outputs, InAFolderThatIsNotThereAreRefused) {
  const Scratch scratch;
  const std::string file = (scratch / "none/report.json").string();
  expectOneLineAbout(arris({"plan", kPane, "--report", file}), file);
  expectEmpty(scratch);
}

TEST(Outputs, InThePlaceOfAFolderAreRefused) {
  const Scratch scratch;
  const std::string folder = (scratch / "x").parent_path().string();
  expectOneLineAbout(arris({"plan", kPane, "--profile", folder}), folder);
  expectEmpty(scratch);
}

TEST(Outputs, OnAFullDiskAreNamedAndTheOthersWritten) {
  const Scratch scratch;
  const std::string gcode = (scratch / "a.ngc").string();
  for (const char* option : {"--report", "--profile"}) {
    const Outcome outcome = arris({"plan", kPane, option, "/dev/full", "--gcode", gcode});
    EXPECT_EQ(outcome.status, 4);
    EXPECT_THAT(outcome.err, HasSubstr("/dev/full"));
    EXPECT_THAT(contentOf(gcode), HasSubstr("M30"));
  }
}

TEST(Outputs, WhereNobodyMayWriteAreNamed) {
  const std::string file = "/proc/arris.svg";
  expectOneLineAbout(arris({"plan", kPane, "--preview", file}), file);
}

TEST(Outputs, StayAsTheyWereWhenTheJobCannotBeGround) {
  const Scratch scratch;
  const std::string gcode = (scratch / "a.ngc").string();
  writeTo(gcode, "of yesterday");
  EXPECT_EQ(arris({"plan", kPane, "--place", "1400,0", "--gcode", gcode}).status, 1);
  EXPECT_EQ(contentOf(gcode), "of yesterday");
}

TEST(Outputs, LeaveNothingHalfWrittenWhenInterrupted) {
  const Scratch scratch;
  const fs::path folder = (scratch / "x").parent_path();
  // At this feed the profile has some hundred million rows.
  const Outcome outcome = interruptedArris({"plan", kPane, "--feed", "1", "--profile", (scratch / "a.csv").string()},
                                           [&] { return !fs::is_empty(folder); });
  EXPECT_EQ(outcome.status, 130);
  EXPECT_THAT(outcome.err, testing::EndsWith("arris: interrupted\n"));
  expectEmpty(scratch);
}

TEST(StandardOutput, ThatIsFullIsAFailure) {
  EXPECT_EQ(std::system((std::string(ARRIS_PROGRAM) + " help >/dev/full 2>/dev/null").c_str()) >> 8, 4);
}

TEST(Outputs, OfOneFileUnderTwoNamesAreRefused) {
  const Scratch scratch;
  const std::string file = (scratch / "a.json").string();
  const std::string roundabout = (scratch / "./a.json").string();
  const std::string link = (scratch / "link.json").string();
  std::filesystem::create_symlink("a.json", link);
  for (const std::string& other : {roundabout, link}) {
    EXPECT_EQ(arris({"plan", kPane, "--report", file, "--profile", other}).status, 2) << other;
    EXPECT_FALSE(std::filesystem::exists(file));
  }
}

TEST(Outputs, ThatAreNoRegularFilesAreWritten) {
  EXPECT_EQ(arris({"plan", kPane, "--report", "/dev/null"}).status, 0);
}

std::string recipeWith(const Scratch& scratch, const std::string& content) {
  std::string file = (scratch / "recipe.json").string();
  writeTo(file, content);
  return file;
}

TEST(RecipeFile, ThatIsMalformedOrOfANewerArrisIsRefused) {
  const Scratch scratch;
  for (const char* content :
       {"", "{", "[1]", "{}", "{\"arris_recipe\": 2}", "{\"arris_recipe\": 1, \"feed_mm_min\": 0}",
        "{\"arris_recipe\": 1, \"feed_mm_min\": \"fast\"}", "{\"arris_recipe\": 1, \"wheel_radius_mm\": 1e999}",
        "{\"arris_recipe\": 1, \"smooth_mm\": 1.5}"}) {
    const Outcome outcome = arris({"plan", kPane, "--recipe", recipeWith(scratch, content)});
    EXPECT_EQ(outcome.status, 2) << content;
    EXPECT_THAT(outcome.err, testing::StartsWith("error: ")) << content;
  }
}

TEST(RecipeFile, MayHoldAKeyThatArrisDoesNotKnow) {
  const Scratch scratch;
  const Outcome outcome =
      arris({"plan", kPane, "--recipe", recipeWith(scratch, "{\"arris_recipe\": 1, \"colour\": \"blue\"}")});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("warning"), HasSubstr("colour")));
}

TEST(RecipeFile, GivesWayToOptions) {
  const Scratch scratch;
  const std::string recipe = recipeWith(scratch, "{\"arris_recipe\": 1, \"feed_mm_min\": 1200, \"depth_mm\": 0.2}");
  const std::string report = (scratch / "report.json").string();
  EXPECT_EQ(arris({"plan", kPane, "--recipe", recipe, "--feed", "2400", "--report", report}).status, 0);
  EXPECT_THAT(contentOf(report), AllOf(HasSubstr("\"feed_mm_min\": 2400"), HasSubstr("\"depth_mm\": 0.2")));
}

TEST(MachineFile, LimitsTheAccelerationsOfTheRecipe) {
  const Scratch scratch;
  const std::string machine = (scratch / "machine.json").string();
  writeTo(machine, "{\"arris_machine\": 1, \"max_accel_mm_s2\": [10, 500, 500]}");
  const Outcome outcome = arris({"plan", kPane, "--machine", machine});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("accel_x_mm_s2"), HasSubstr("10")));
}

} // namespace
} // namespace arris::test
