// What a machine has done in its life, against the plan of what it did.

#include "core/control/counter_keeper.h"
#include "core/files/whole_file.h"
#include "tests/support/bench.h"
#include "tests/support/panes.h"
#include "tests/support/scratch.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace arris::control {
namespace {

using test::Bench;

constexpr double kPeriodOfTest = 0.001; // s
const std::string kNow = "2031-05-06T07:08:09";

double waySummed(const job::Job& job) {
  double way = 0;
  for (const motion::Segment& segment : job.track) {
    way += motion::isAlongContour(segment.move) ? motion::arcLength(segment, motion::parameterLength(segment)) : 0;
  }
  return way;
}

/// Grinds one pane and tells every report to the keeper; gives the periods with drives and spindle on.
std::pair<std::int64_t, std::int64_t> grindOnePane(const job::Job& job, CounterKeeper& keeper) {
  Bench bench(job.machine);
  std::int64_t drives = 0;
  std::int64_t spindle = 0;
  bench.onPeriod = [&](const Report& report, const Cycle& cycle) {
    drives += report.drivesReady ? 1 : 0;
    spindle += cycle.outputs.spindleSpeed > 0 ? 1 : 0;
    keeper.add(report);
  };
  bench.getReady(job);
  EXPECT_TRUE(bench.supervisor.start());
  EXPECT_TRUE(bench.until([&] { return bench.supervisor.panesDone() == 1; }, 2 * job.duration + 10));
  return {drives, spindle};
}

files::Counters countersIn(const std::filesystem::path& file) {
  const auto text = files::readFile(file);
  EXPECT_TRUE(text);
  const auto read = files::readCounters(text.value_or(""), "counters.json");
  EXPECT_TRUE(read.problems.empty());
  return read.value;
}

TEST(CounterKeeper, CountsWhatThePlanSaysAndGoesOnFromItTheNextTime) {
  const test::Scratch scratch;
  const std::filesystem::path file = scratch / "state/counters.json";
  const job::Job job = job::planJob(test::triangle600(), recipe::Recipe{}, recipe::Machine{});
  files::Counters first;
  {
    CounterKeeper keeper(file, kPeriodOfTest, kNow);
    const auto [drives, spindle] = grindOnePane(job, keeper);
    first = keeper.counters();
    EXPECT_NEAR(first.drivesOn, static_cast<double>(drives) * kPeriodOfTest, 1e-9);
    EXPECT_NEAR(first.spindleOn, static_cast<double>(spindle) * kPeriodOfTest, 1e-9);
    EXPECT_NEAR(first.ground, waySummed(job), 0.5); // each way onto the contour begins within one period, 0.06 mm
    EXPECT_GT(first.grinding, waySummed(job) / (job.recipe.feed / 60));
    EXPECT_LT(first.grinding, job.duration);
    EXPECT_EQ(first.panes, 1);
    EXPECT_EQ(first.since, kNow);
    EXPECT_FALSE(keeper.takeFailure());
  }
  EXPECT_EQ(countersIn(file), first);
  CounterKeeper keeper(file, kPeriodOfTest, "2032-01-01T00:00:00");
  EXPECT_EQ(keeper.counters(), first);
  grindOnePane(job, keeper);
  EXPECT_NEAR(keeper.counters().ground, 2 * first.ground, 1e-6);
  EXPECT_NEAR(keeper.counters().drivesOn, 2 * first.drivesOn, 1e-6);
  EXPECT_EQ(keeper.counters().panes, 2);
  EXPECT_EQ(keeper.counters().since, kNow);
}

Report drivesOnAt(std::int64_t tick) {
  Report report;
  report.tick = tick;
  report.drivesReady = true;
  return report;
}

TEST(CounterKeeper, CountsPeriodsWhoseReportsWereLost) {
  const test::Scratch scratch;
  CounterKeeper keeper(scratch / "counters.json", kPeriodOfTest, kNow);
  keeper.add(drivesOnAt(10));
  keeper.add(drivesOnAt(11));
  keeper.add(drivesOnAt(2010));
  EXPECT_NEAR(keeper.counters().drivesOn, 2.001, 1e-9);
  keeper.add(drivesOnAt(2010)); // nothing new
  EXPECT_NEAR(keeper.counters().drivesOn, 2.001, 1e-9);
}

TEST(CounterKeeper, DoesNotTakePanesOfBeforeForItsOwnWhereItBeginsInAMiddle) {
  const test::Scratch scratch;
  CounterKeeper keeper(scratch / "counters.json", kPeriodOfTest, kNow);
  Report report = drivesOnAt(5000);
  report.jobsEnded = 7;
  keeper.add(report);
  report.jobsEnded = 8;
  keeper.add(report);
  EXPECT_EQ(keeper.counters().panes, 1);
}

TEST(CounterKeeper, WritesNothingWhereNothingWasCounted) {
  const test::Scratch scratch;
  {
    CounterKeeper keeper(scratch / "counters.json", kPeriodOfTest, kNow);
    keeper.add(Report());
  }
  EXPECT_FALSE(std::filesystem::exists(scratch / "counters.json"));
}

TEST(CounterKeeper, SetsADamagedFileAsideTellsItAndCountsFromZero) {
  const test::Scratch scratch;
  const std::filesystem::path file = scratch / "counters.json";
  for (const char* text : {"", "{\"arris_counters\": 1, \"grinding_s\":", "{\"arris_counters\": 1}", "[]",
                           "{\"arris_counters\":1,\"since\":\"x\",\"drives_on_s\":-1,\"spindle_on_s\":0,"
                           "\"grinding_s\":0,\"ground_mm\":0,\"panes\":0}"}) {
    ASSERT_TRUE(files::writeWholeFile(file, text));
    {
      CounterKeeper keeper(file, kPeriodOfTest, kNow);
      ASSERT_TRUE(keeper.damage()) << text;
      EXPECT_EQ(keeper.damage()->code, base::Code::CountersDamaged);
      const std::filesystem::path kept = std::get<std::string>(keeper.damage()->values.at(1).value);
      EXPECT_EQ(files::readFile(kept), text);
      EXPECT_EQ(keeper.counters(), files::Counters{kNow});
      keeper.add(drivesOnAt(1));
    }
    EXPECT_NEAR(countersIn(file).drivesOn, 0.001, 1e-12);
  }
}

TEST(CounterKeeper, TellsWhatItCannotWrite) {
  const test::Scratch scratch;
  ASSERT_TRUE(files::writeWholeFile(scratch / "state", "a file where the folder should be"));
  CounterKeeper keeper(scratch / "state/counters.json", kPeriodOfTest, kNow);
  keeper.add(drivesOnAt(1));
  std::optional<base::Problem> failure;
  for (int i = 0; i < 10000 && !failure; ++i) { // on a thread of its own
    failure = keeper.takeFailure();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->code, base::Code::CannotWrite);
}

} // namespace
} // namespace arris::control
