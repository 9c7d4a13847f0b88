#include "core/control/broken_job.h"
#include "core/files/whole_file.h"
#include "tests/support/panes.h"
#include "tests/support/scratch.h"

#include <gtest/gtest.h>

#include <fstream>

namespace arris::control {
namespace {

files::ResumePoint triangleBroken() {
  files::ResumePoint point;
  point.patternFile = "triangle.dxf";
  point.patternHash = "0123456789abcdef";
  point.place = {7, 12.5};
  point.origin = {100, 200, -3};
  point.pane = 2;
  point.panes = 5;
  point.ended = files::Ended::Fault;
  return point;
}

TEST(BrokenJob, IsFoundWhereTheKeeperLeftIt) {
  const test::Scratch scratch;
  const files::StateFolder folder{scratch / "state"};
  EXPECT_FALSE(findBrokenJob(folder).job);
  EXPECT_TRUE(findBrokenJob(folder).problems.empty());
  std::filesystem::create_directories(folder.root);
  ASSERT_TRUE(files::writeWholeFile(folder.resumePoint(), files::writeResumePoint(triangleBroken())));
  const FoundJob found = findBrokenJob(folder);
  ASSERT_TRUE(found.job);
  EXPECT_EQ(found.job->point, triangleBroken());
  EXPECT_EQ(found.job->time.size(), std::string("2031-05-06T07:08:09").size());
}

TEST(BrokenJob, OfAnOlderPointHasTheOriginZero) {
  std::string text = files::writeResumePoint(triangleBroken());
  const std::size_t begin = text.find("\"origin_mm\"");
  text.erase(begin, text.find('\n', begin) - begin);
  const auto read = files::readResumePoint(text, "resume.json");
  EXPECT_TRUE(read.problems.empty());
  EXPECT_EQ(read.value.origin, Eigen::Vector3d::Zero());
}

TEST(BrokenJob, ThatIsDamagedIsTold) {
  const test::Scratch scratch;
  const files::StateFolder folder{scratch / "state"};
  std::filesystem::create_directories(folder.root);
  std::ofstream(folder.resumePoint()) << "{ half";
  const FoundJob found = findBrokenJob(folder);
  EXPECT_FALSE(found.job);
  ASSERT_FALSE(found.problems.empty());
  EXPECT_EQ(found.problems.front().code, base::Code::JsonMalformed);
}

TEST(BrokenJob, OfAnotherPatternMachineOrPlaceSaysWhatDiffers) {
  files::ResumePoint point = triangleBroken();
  EXPECT_FALSE(checkPattern(point, point.patternHash));
  const auto pattern = checkPattern(point, "fedcba9876543210");
  ASSERT_TRUE(pattern);
  EXPECT_NE(base::describe(*pattern).find("had the fingerprint 0123456789abcdef, now it has fedcba9876543210"),
            std::string::npos);

  recipe::Machine machine;
  machine.jogSpeed = 1000; // no job is planned by it
  EXPECT_TRUE(checkMachine(point, machine).empty());
  machine.park.z() = 100;
  machine.period = 0.002;
  const base::Problems problems = checkMachine(point, machine);
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_EQ(base::describe(problems[0]), "The job that was broken off was planned for another machine: park_mm was 0, "
                                         "0, 120, now it is 0, 0, 100.");
  EXPECT_NE(base::describe(problems[1]).find("period_s was 0.001, now it is 0.002"), std::string::npos);

  const job::Job job = job::planJob(test::triangle600(), recipe::Recipe{}, recipe::Machine{});
  EXPECT_FALSE(checkPlace(point, job));
  point.place = {static_cast<int>(job.track.size()), 0};
  EXPECT_EQ(checkPlace(point, job).value().code, base::Code::JobPlaceUnknown);
  point.place = {7, motion::parameterLength(job.track[7]) + 1};
  EXPECT_TRUE(checkPlace(point, job));
}

} // namespace
} // namespace arris::control
