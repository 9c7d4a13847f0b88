// Work that is no longer wanted ends soon and says so.

#include "core/base/numbers.h"
#include "core/job/job.h"
#include "tests/support/dxf_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

namespace arris::job {
namespace {

using base::Code;
using base::Stage;

/// A wavy pane of many chords and a cut-out.
std::string drawing() {
  test::DxfText text;
  text.insUnits(4);
  std::vector<geometry::Point> outline;
  std::vector<geometry::Point> cutOut;
  for (int i = 0; i < 3000; ++i) {
    const double angle = 2 * base::kPi * i / 3000;
    const double radius = 500 + 40 * std::cos(8 * angle);
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    cutOut.emplace_back(150 * std::cos(angle), 150 * std::sin(angle));
  }
  text.addGroups(test::polylineGroups(outline, true)).addGroups(test::polylineGroups(cutOut, true));
  return text.text();
}

/// Asks for a stop as one stage begins, and notes those that begin.
struct StopAt {
  explicit StopAt(Stage stage) : last(stage) {}

  base::Monitor monitor() {
    return {stop.get_token(), [this](Stage stage) {
              begun.push_back(stage);
              if (stage == last) {
                stop.request_stop();
              }
            }};
  }

  Stage last;
  std::stop_source stop;
  std::vector<Stage> begun;
};

std::vector<Code> codesOf(const base::Problems& problems) {
  std::vector<Code> codes;
  for (const base::Problem& problem : problems) {
    codes.push_back(problem.code);
  }
  return codes;
}

pattern::ImportOptions smoothedWithin(double tolerance) {
  pattern::ImportOptions options;
  options.smooth = tolerance;
  return options;
}

TEST(Cancelled, ReadingEndsWhereItIsAndSaysSo) {
  StopAt stop(Stage::Reading);
  const std::string whole = drawing();
  // What is wrong at the end is not met any more.
  const pattern::Pattern pattern = pattern::readDxf(whole.substr(0, whole.size() - 20), {}, stop.monitor());
  EXPECT_THAT(codesOf(pattern.problems), testing::ElementsAre(Code::Cancelled));
  EXPECT_THAT(stop.begun, testing::ElementsAre(Stage::Reading));
}

TEST(Cancelled, JoiningEndsWhereItIsAndSaysSo) {
  StopAt stop(Stage::Joining);
  const pattern::Pattern pattern = pattern::readDxf(drawing(), {}, stop.monitor());
  EXPECT_THAT(codesOf(pattern.problems), testing::ElementsAre(Code::Cancelled));
  EXPECT_TRUE(pattern.contours.empty());
  EXPECT_THAT(stop.begun, testing::ElementsAre(Stage::Reading, Stage::Joining));
}

TEST(Cancelled, PlanningEndsWithTheStageThatItIsInAndCannotBeGround) {
  const pattern::Pattern pattern = pattern::readDxf(drawing(), smoothedWithin(0));
  ASSERT_TRUE(planJob(pattern, {}, {}).canBeGround());
  StopAt inPath(Stage::WheelPath);
  const Job withoutPath = planJob(pattern, {}, {}, toolpath::Leads::With, inPath.monitor());
  EXPECT_THAT(codesOf(withoutPath.problems), testing::ElementsAre(Code::Cancelled));
  EXPECT_FALSE(withoutPath.canBeGround());
  EXPECT_TRUE(withoutPath.toolpath.chains.empty());
  EXPECT_THAT(inPath.begun, testing::ElementsAre(Stage::WheelPath));

  StopAt inSpeeds(Stage::Speeds);
  const Job withoutSpeeds = planJob(pattern, {}, {}, toolpath::Leads::With, inSpeeds.monitor());
  EXPECT_THAT(codesOf(withoutSpeeds.problems), testing::ElementsAre(Code::Cancelled));
  EXPECT_TRUE(withoutSpeeds.intervals.empty());
  EXPECT_TRUE(withoutSpeeds.pieces.empty());
}

// Wherever in the work the stop comes, what comes out is either whole or cancelled.
TEST(Cancelled, WorkIsWholeOrCancelledWheneverTheStopComes) {
  const std::string text = drawing();
  for (int wait = 0; wait < 40; ++wait) {
    std::stop_source stop;
    std::jthread later([&] {
      std::this_thread::sleep_for(std::chrono::microseconds(500 * wait));
      stop.request_stop();
    });
    const base::Monitor monitor{stop.get_token(), {}};
    const pattern::Pattern pattern = pattern::readDxf(text, smoothedWithin(wait % 2 == 0 ? 0.01 : 0), monitor);
    const Job job = planJob(pattern, {}, {}, toolpath::Leads::With, monitor);
    if (job.canBeGround()) {
      EXPECT_FALSE(job.pieces.empty());
    } else {
      EXPECT_THAT(codesOf(job.problems), testing::ElementsAre(Code::Cancelled));
    }
  }
}

} // namespace
} // namespace arris::job
