#pragma once

#include "core/program/program.h"

#include <optional>

namespace arris::program {

// Ways that the operator asks for beside the job's own. Each is planned like the job: values in, value out.

/// Where the wheel stands at rest, table coordinates, mm.
using Position = Eigen::Vector3d;

/// How far the wheel may move off the glass along the normal (mm, at most `most`) from the place on the job's way, and
/// all along that segment of it, without coming nearer to any glass than its radius; 0 where there is no room, and off
/// the contour.
[[nodiscard]] double roomBeside(const job::Job& job, int segment, double most);

/// A step of `distance` mm along the job's way (negative: back) from `place`, with the wheel `beside` the way by so
/// much along the normal, away from the glass, at the height of `at.z()`. Ends at a stop of the way, at the lead-in's
/// start and the lead-out's end, and where there is less room than `beside`. Nothing where the wheel cannot go at all.
struct Step {
  Program program;
  JobPlace end;
};

[[nodiscard]] std::optional<Step> stepProgram(const job::Job& job, const JobPlace& place, double distance,
                                              double beside, const Position& at);

/// The job again from a place where it was broken off: from where the wheel is, up, across, down beside the glass, by a
/// lead-in onto the way `overlap` before the place (mm along the way), and on to the end of the job. Off the contours,
/// and where no lead-in has room near the place, the contour's own lead-in. The wheel must be at rest.
[[nodiscard]] Program resumeProgram(const job::Job& job, const JobPlace& place, double overlap, const Position& at);

/// Once round every contour at clearance height along the job's way, back to where it begins; no plunge.
[[nodiscard]] Program traceProgram(const job::Job& job, const Position& at);

/// Straight up to the top of the travel, across, to the park position.
[[nodiscard]] Program parkProgram(const recipe::Recipe& recipe, const recipe::Machine& machine, const Position& at);

} // namespace arris::program
