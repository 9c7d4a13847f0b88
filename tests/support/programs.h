#pragma once

#include "core/program/program.h"

#include <gtest/gtest.h>

#include <vector>

namespace arris::test {

/// Jobs that can be ground, the same each time: convex and hollow panes, and panes with concave corners, notches and
/// cut-outs.
[[nodiscard]] std::vector<job::Job> jobsOfAllKinds(int ofEach);

/// From `start` to rest at its end without a gap, tangentially but where it stops, every segment with its place.
[[nodiscard]] testing::AssertionResult isOneMotion(const program::Program& program, const Eigen::Vector3d& start);

/// Run to its end at 1 ms, the second differences of the positions keep the acceleration of each axis and the
/// velocities its speed.
[[nodiscard]] testing::AssertionResult keepsTheLimits(const program::Program& program);

/// Places along a segment, from its start to its end, each 1 mm or closer.
[[nodiscard]] std::vector<double> placesAlong(const motion::Segment& segment);

/// Where the wheel is at a place of the job's way, `beside` it away from the glass, mm.
[[nodiscard]] Eigen::Vector3d wheelAt(const job::Job& job, const program::JobPlace& place, double beside = 0);

} // namespace arris::test
