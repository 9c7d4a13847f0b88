#pragma once

#include "core/job/job.h"
#include "core/program/input_point.h"

#include <vector>

namespace arris::program {

/// What a program is for: the job, from its beginning or from a place where it was broken off; a step along the way
/// while it is held; a way at height (outline trace, go to park).
enum class Kind { Job, Step, Positioning };

/// Motion from rest to rest, ready to be streamed to the controller.
struct Program {
  Kind kind = Kind::Job;
  std::vector<motion::Segment> track;
  std::vector<motion::Interval> intervals;
  std::vector<JobStretch> places; ///< by segment of the track
  motion::AxisLimits limits;
  std::vector<job::CornerResult>
      corners{}; ///< what the profile makes of the job's corners, index = corner − 1; or none
};

/// The whole job. Its track and limits are the job's own, bit for bit.
[[nodiscard]] Program jobProgram(const job::Job& job);

} // namespace arris::program
