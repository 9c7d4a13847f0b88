#pragma once

#include "core/program/program.h"
#include "core/toolpath/glass.h"

#include <optional>

namespace arris::program {

// Ways that the operator asks for beside the job's own. Each is planned like the job: values in, value out.

/// Where the wheel stands at rest, table coordinates, mm.
using Position = Eigen::Vector3d;

/// The room beside the job's way. Refers to the job, which can be ground.
class Room {
public:
  explicit Room(const job::Job& job);

  /// How far the wheel may move off the glass along the normal (mm, at most `most`) from the segment of the job's
  /// track, wherever on it it stands, without coming nearer to any glass than its radius and without leaving the
  /// travel. A lower bound; 0 where there is no room, on leads and off the contours.
  [[nodiscard]] double beside(int segment, double most) const;

  /// Whether it may move so far; true for everything that `beside` returned.
  [[nodiscard]] bool has(int segment, double beside) const;

  /// Whether the wheel's centre may go along the curve at grinding height.
  [[nodiscard]] bool isFree(const geometry::Curve& lineOrArc) const;

private:
  const job::Job& m_job;
  toolpath::Glass m_glass;
};

/// The greatest feed of a step, mm/s.
inline constexpr double kStepFeed = 20;

/// A step of `distance` mm along the job's way (its true length; negative: back) from `place`, with the wheel `beside`
/// the way by so much along the normal, away from the glass, at the height of `at.z()`. `at` is where the wheel is, up
/// to 2 µm from the place. Ends at a stop of the way, at the lead-in's start and the lead-out's end, and where there is
/// less room than `beside`. From beside a kink the wheel first moves over to the normal of the segment that follows.
/// Transitions are followed by arcs (Move::Roll). Nothing where the wheel cannot go at all.
struct Step {
  Program program;
  JobPlace end;
};

[[nodiscard]] std::optional<Step> stepProgram(const job::Job& job, const JobPlace& place, double distance,
                                              double beside, const Position& at);

/// The job again from a place where it was broken off: from where the wheel is, up, across, down beside the glass, by a
/// lead-in onto the way `overlap` before the place (mm along the way) or, where no lead-in has room there, farther
/// before it, and on to the end of the job. With the contour's own lead-in where there is none nearer and where the
/// place lies before the contour; behind the last contour only to the park position. The places of what is not the
/// job's own are −1. Empty where the wheel stands at the park position and nothing is left to do.
[[nodiscard]] Program resumeProgram(const job::Job& job, const JobPlace& place, double overlap, const Position& at);

/// Up, across, and once along every chain of the wheel path at clearance height, leads included; ends at rest at the
/// top of the travel above the end of the last. No plunge; every place is −1.
[[nodiscard]] Program traceProgram(const job::Job& job, const Position& at);

/// Straight up to the top of the travel, across, to the park position. Empty where the wheel stands there.
[[nodiscard]] Program parkProgram(const recipe::Recipe& recipe, const recipe::Machine& machine, const Position& at);

} // namespace arris::program
