#include "core/files/profile_columns.h"
#include "core/files/run_row.h"
#include "core/files/whole_file.h"
#include "tests/support/lines_of.h"
#include "tests/support/scratch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace arris::files {
namespace {

std::vector<RunRow> throughVelocities(const std::vector<RunRow>& rows, double period) {
  MeasuredVelocities velocities(period);
  std::vector<RunRow> result;
  for (const RunRow& row : rows) {
    if (const auto out = velocities.add(row)) {
      result.push_back(*out);
    }
  }
  while (const auto out = velocities.finish()) {
    result.push_back(*out);
  }
  return result;
}

std::vector<RunRow> rowsWithConstantAcceleration(double period, int count, const Eigen::Vector3d& acceleration) {
  std::vector<RunRow> rows(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    RunRow& run = rows[static_cast<std::size_t>(i)];
    run.row.time = i * period;
    run.row.position = acceleration * (0.5 * run.row.time * run.row.time);
    run.row.segment = i;
  }
  return rows;
}

// The difference of a parabola is its slope in the middle of what the difference spans: of 20 ms within the run, of
// less at its ends.
TEST(MeasuredVelocities, AreDifferencesOverTwentyMillisecondsWhateverThePeriod) {
  const Eigen::Vector3d acceleration(20, -7, 0.5);
  for (const double period : {0.00025, 0.0005, 0.001, 0.002, 0.005, 0.01}) {
    for (const int count : {2, 3, 7, 30, 500}) {
      const auto rows = throughVelocities(rowsWithConstantAcceleration(period, count, acceleration), period);
      ASSERT_EQ(rows.size(), static_cast<std::size_t>(count));
      const double end = (count - 1) * period;
      for (int i = 0; i < count; ++i) {
        const RunRow& run = rows[static_cast<std::size_t>(i)];
        const double middle = (std::max(0.0, i * period - 0.01) + std::min(end, i * period + 0.01)) / 2;
        ASSERT_EQ(run.row.segment, i);
        ASSERT_LT((run.measuredVelocity - acceleration * middle).norm(), 1e-9) << period << " " << count << " " << i;
      }
    }
  }
}

TEST(MeasuredVelocities, WithALongerPeriodReachToTheNeighbours) {
  const auto rows = throughVelocities(rowsWithConstantAcceleration(0.02, 10, {20, 0, 0}), 0.02);
  EXPECT_NEAR(rows.at(5).measuredVelocity.x(), 20 * 0.1, 1e-12);
  EXPECT_NEAR(rows.front().measuredVelocity.x(), 20 * 0.01, 1e-12);
}

TEST(MeasuredVelocities, DelayARowByTenMilliseconds) {
  MeasuredVelocities velocities(0.001);
  const auto rows = rowsWithConstantAcceleration(0.001, 40, {20, 0, 0});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto out = velocities.add(rows[i]);
    ASSERT_EQ(out.has_value(), i >= 10);
    if (out) {
      EXPECT_EQ(out->row.segment, static_cast<int>(i) - 10);
    }
  }
}

TEST(MeasuredVelocities, OfARunOfOneRowOrNoneAreNothing) {
  RunRow lone;
  lone.row.position = {1, 2, 3};
  const auto rows = throughVelocities({lone}, 0.001);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].measuredVelocity, Eigen::Vector3d(0, 0, 0));
  EXPECT_TRUE(throughVelocities({}, 0.001).empty());
}

TEST(PhaseWords, AreThoseOfAPlanInTheirOrderAndThoseOfARun) {
  for (int i = 0; i < job::kPhaseCount; ++i) {
    EXPECT_EQ(phaseNumber(job::name(static_cast<job::Phase>(i))), static_cast<std::size_t>(i));
  }
  EXPECT_EQ(phaseNumber("dwell"), 12U);
  EXPECT_EQ(phaseNumber("hold"), 13U);
  EXPECT_EQ(phaseNumber("step"), 14U);
  EXPECT_FALSE(phaseNumber("crawl"));
}

TEST(RunProfile, HasTheColumnsOfAPlanAndThenThoseOfARun) {
  RunRow held{
      {0.25, {1, -2.5, 46}, {3, 4, 0}, {0.5, -0.25, 0}, 5, 12.5, 1, 2, "hold", 0, 99}, {1.5, -2.25, 46}, {0, 0, 0}};
  RunRow turning{
      {0.251, {1.123456789, 2, 46}, {3, 4, 0}, {0, 0, 0}, 5, 13, 1, 2, "transition", 3, 75.5}, {7, 8, 9}, {3.5, 4, 0}};
  const test::Scratch scratch;
  ASSERT_TRUE(writeWholeFile(scratch / "a.csv", [&](Output& output) {
    RunProfileWriter writer(output);
    writer.add(held);
    writer.add(turning);
    writer.flush();
  }));
  const std::string text = readFile(scratch / "a.csv").value();
  EXPECT_EQ(text,
            "t_s,x_mm,y_mm,z_mm,vx_mm_s,vy_mm_s,vz_mm_s,ax_mm_s2,ay_mm_s2,az_mm_s2,speed_mm_s,path_mm,contour,segment,"
            "phase,corner,distance_mm,x_cmd_mm,y_cmd_mm,z_cmd_mm,vx_meas_mm_s,vy_meas_mm_s,vz_meas_mm_s\n"
            "0.25,1.000000000,-2.500000000,46.000000000,3,4,0,0.5,-0.25,0,5,12.5,1,2,hold,0,,1.500000000,-2.250000000,"
            "46.000000000,0,0,0\n"
            "0.251,1.123456789,2.000000000,46.000000000,3,4,0,0,0,0,5,13,1,2,transition,3,75.5,7.000000000,8.000000000,"
            "9.000000000,3.5,4,0\n");
  const auto read = readProfile(text, "a.csv");
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->at(0).phase, "hold");
  EXPECT_EQ(read->at(1).position, turning.row.position);
}

} // namespace
} // namespace arris::files
