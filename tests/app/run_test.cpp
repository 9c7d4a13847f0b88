#include "tests/app/process.h"
#include "tests/support/scratch.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <thread>

namespace arris::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

namespace fs = std::filesystem;

std::vector<std::string> fastRun(const Scratch& scratch, std::initializer_list<std::string> more = {}) {
  std::vector<std::string> arguments{
      "run",         sample("triangle.dxf"),       "--speed",   "fast",
      "--state-dir", (scratch / "state").string(), "--profile", (scratch / "a.csv").string()};
  arguments.insert(arguments.end(), more);
  return arguments;
}

std::size_t linesIn(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

std::size_t recordsIn(const Scratch& scratch) {
  const fs::path folder = scratch / "state/records";
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(Run, OfAJobIsThePlanRowByRowAndLeavesARecord) {
  const Scratch scratch;
  const Outcome run = arris(fastRun(scratch));
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, IsEmpty());
  EXPECT_THAT(run.out, HasSubstr("Ground in"));
  ASSERT_EQ(arris({"plan", sample("triangle.dxf"), "--profile", (scratch / "p.csv").string()}).status, 0);
  const std::string actual = contentOf((scratch / "a.csv").string());
  EXPECT_EQ(linesIn(actual), linesIn(contentOf((scratch / "p.csv").string())));
  EXPECT_THAT(actual, StartsWith("t_s,x_mm,y_mm,z_mm,"));
  EXPECT_THAT(actual, HasSubstr(",x_cmd_mm,y_cmd_mm,z_cmd_mm,vx_meas_mm_s"));
  EXPECT_EQ(recordsIn(scratch), 1U);
  EXPECT_FALSE(fs::exists(scratch / "state/resume.json")); // nothing is left to resume
  EXPECT_EQ(
      arris({"plot", (scratch / "p.csv").string(), (scratch / "a.csv").string(), "-o", (scratch / "both.svg").string()})
          .status,
      0);
}

TEST(Run, WithAFaultEndsWithThreeAndIsResumed) {
  const Scratch scratch;
  const Outcome broken = arris(fastRun(scratch, {"--inject", "spindle-loss@60"}));
  EXPECT_EQ(broken.status, 3);
  EXPECT_THAT(broken.err, AllOf(HasSubstr("[spindle-loss]"), HasSubstr("remedy:")));
  const std::size_t rows = linesIn(contentOf((scratch / "a.csv").string()));
  EXPECT_GT(rows, 60000U); // what was executed until then
  EXPECT_LT(rows, 75000U);
  EXPECT_THAT(contentOf((scratch / "state/resume.json").string()), HasSubstr("\"fault\""));
  EXPECT_THAT(contentOf((scratch / "state/alarms.jsonl").string()), HasSubstr("spindle-loss"));

  const Outcome resumed = arris(fastRun(scratch, {"--resume"}));
  EXPECT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_FALSE(fs::exists(scratch / "state/resume.json"));
  EXPECT_EQ(recordsIn(scratch), 2U);
}

TEST(Run, ResumesOnlyThePatternThatWasBrokenOff) {
  const Scratch scratch;
  EXPECT_EQ(arris(fastRun(scratch, {"--inject", "emergency-stop@50"})).status, 3);
  const Outcome other =
      arris({"run", sample("arcs.dxf"), "--speed", "fast", "--resume", "--state-dir", (scratch / "state").string()});
  EXPECT_EQ(other.status, 2);
  EXPECT_THAT(other.err, HasSubstr("another pattern"));
}

TEST(Run, ResumesOnlyOnTheAxesThatMoved) {
  const Scratch scratch;
  EXPECT_EQ(arris(fastRun(scratch, {"--inject", "emergency-stop@50"})).status, 3);
  const Outcome other = arris(
      {"run", sample("triangle.dxf"), "--axes", "linuxcnc", "--resume", "--state-dir", (scratch / "state").string()});
  EXPECT_EQ(other.status, 2);
  EXPECT_THAT(other.err, HasSubstr("axes was simulated, now it is linuxcnc"));
}

TEST(Run, WithoutAJobThatWasBrokenOffHasNothingToResume) {
  const Scratch scratch;
  const Outcome outcome = arris(fastRun(scratch, {"--resume"}));
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.err, HasSubstr("no job to resume"));
}

TEST(Run, DoesNotBeginWhereItsFolderCannotBe) {
  const Outcome outcome = arris({"run", sample("triangle.dxf"), "--speed", "fast", "--state-dir", "/dev/null"});
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.err, HasSubstr("/dev/null/records"));
  EXPECT_THAT(outcome.out, IsEmpty());
}

TEST(Run, DoesNotBeginWhereNothingCanBeWrittenInItsFolder) {
  const Scratch scratch;
  fs::create_directory(scratch / "state");
  fs::create_directory_symlink("/proc/self", scratch / "state/records"); // there, but not for files
  const Outcome outcome = arris(fastRun(scratch));
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.err, HasSubstr("state/records"));
  EXPECT_THAT(outcome.out, IsEmpty());
}

TEST(Run, ReadsThePatternOnce) {
  const Scratch scratch;
  const std::string pattern = (scratch / "once.dxf").string();
  ASSERT_EQ(mkfifo(pattern.c_str(), 0600), 0); // what was read from it is gone
  std::thread writer([&] { writeTo(pattern, contentOf(sample("triangle.dxf"))); });
  const Outcome outcome = arris({"run", pattern, "--speed", "fast", "--state-dir", (scratch / "state").string()});
  writer.join();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST(Run, OfSeveralPanesGrindsOneAfterTheOtherAlsoWhenResumed) {
  const Scratch scratch;
  const Outcome broken = arris(fastRun(scratch, {"--count", "2", "--inject", "spindle-loss@60"}));
  EXPECT_EQ(broken.status, 3);
  const std::string point = contentOf((scratch / "state/resume.json").string());
  EXPECT_THAT(point, AllOf(HasSubstr("\"pane\": 1,"), HasSubstr("\"panes\": 2,")));
  const Outcome resumed = arris(fastRun(scratch, {"--resume"}));
  EXPECT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_THAT(resumed.out, AllOf(HasSubstr("Pane 1 of 2: Ground in"), HasSubstr("Pane 2 of 2: Ground in")));
  EXPECT_FALSE(fs::exists(scratch / "state/resume.json"));
  EXPECT_EQ(recordsIn(scratch), 3U);
  EXPECT_EQ(arris(fastRun(scratch, {"--resume", "--count", "2"})).status, 2);
}

TEST(Run, ThatWasBrokenOffAtItsVeryEndHasNothingLeftToResume) {
  const Scratch scratch;
  const Outcome whole = arris(fastRun(scratch));
  const std::size_t at = whole.out.find("Ground in ");
  ASSERT_NE(at, std::string::npos);
  const double seconds = std::stod(whole.out.substr(at + 10));
  const std::string fault = "emergency-stop@" + std::to_string(seconds - 0.2);
  EXPECT_EQ(arris(fastRun(scratch, {"--inject", fault})).status, 3);
  EXPECT_TRUE(fs::exists(scratch / "state/resume.json"));
  const Outcome resumed = arris(fastRun(scratch, {"--resume"}));
  EXPECT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_THAT(resumed.out, HasSubstr("Nothing was left"));
  EXPECT_FALSE(fs::exists(scratch / "state/resume.json"));
  EXPECT_EQ(recordsIn(scratch), 2U);
}

TEST(Run, RefusesWrongValuesByName) {
  const Scratch scratch;
  for (const auto& [option, value] : std::initializer_list<std::pair<const char*, const char*>>{
           {"--override", "9"},
           {"--override", "151"},
           {"--override", "fast"},
           {"--speed", "slow"},
           {"--count", "0"},
           {"--count", "2.5"},
           {"--axes", "mine"},
           {"--inject", "coolant-loss"},
           {"--inject", "coolant-loss@"},
           {"--inject", "coolant-loss@-1"},
           {"--inject", "coolant-loss@nan"},
           {"--inject", "flood@3"},
       }) {
    const Outcome outcome = arris(fastRun(scratch, {option, value}));
    EXPECT_EQ(outcome.status, 2) << option << " " << value;
    EXPECT_THAT(outcome.err, HasSubstr(option)) << value;
  }
}

TEST(Run, OfAJobThatCannotBeGroundDoesNotBegin) {
  const Scratch scratch;
  const Outcome outcome = arris(fastRun(scratch, {"--wheel-radius", "500", "--place", "0,0"}));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_FALSE(fs::exists(scratch / "a.csv"));
}

} // namespace
} // namespace arris::test
