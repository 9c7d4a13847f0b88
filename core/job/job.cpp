#include "core/job/job.h"

#include "core/base/window_thread.h"
#include "core/job/contour_numbers.h"
#include "core/job/phases.h"
#include "core/job/placement.h"
#include "core/job/program_track.h"
#include "core/toolpath/size_correction.h"

#include <algorithm>

namespace arris::job {
namespace {

void append(base::Problems& problems, const base::Problems& more) {
  problems.insert(problems.end(), more.begin(), more.end());
}

bool isWork(motion::Move move) {
  using enum motion::Move;
  return move == LeadIn || move == Contour || move == Transition || move == Roll || move == LeadOut;
}

// A note for each axis whose greatest speed is below the feed somewhere on the contours.
base::Problems machineSpeedNotes(const recipe::Recipe& recipe, const recipe::Machine& machine) {
  base::Problems notes;
  for (const auto& [axis, index] : {std::pair{"X", 0}, {"Y", 1}}) {
    if (machine.maxSpeed[index] < recipe.feed) {
      notes.push_back(base::Problem(base::Code::MachineSpeedBinds, {{"axis", axis}}));
    }
  }
  return notes;
}

void timeIt(Job& job) {
  for (const PlannedPiece& piece : job.pieces) {
    job.byPhase[static_cast<std::size_t>(piece.phase)] += piece.motion.duration;
    if (isWork(job.track[static_cast<std::size_t>(piece.motion.segment)].move)) {
      job.working += piece.motion.duration;
    }
  }
  job.duration = job.pieces.back().motion.time + job.pieces.back().motion.duration;
}

// Up to the wheel path; false where that cannot be ground.
bool planWheelPath(Job& job, const pattern::Pattern& pattern, toolpath::Leads leads, const std::stop_token& stop) {
  const recipe::Recipe& recipe = job.recipe;
  const recipe::Machine& machine = job.machine;
  job.placement = placementOf(pattern.contours, recipe, machine);
  job.contours = placed(pattern.contours, job.placement);
  job.problems = placed(pattern.problems, job.placement);
  append(job.problems, checkHeights(recipe, machine));
  append(job.problems, checkPark(job.contours, recipe, machine));
  if (base::hasErrors(pattern.problems)) {
    return false;
  }

  base::Problems ofSize;
  job.contours = toolpath::sizeCorrected(job.contours, recipe.sizeCorrection, ofSize);
  append(job.problems, ofSize);
  if (base::hasErrors(ofSize)) {
    return false;
  }
  job.toolpath = toolpath::makeToolpath(job.contours, recipe, leads, machine.park.head<2>(), stop);
  if (stop.stop_requested()) {
    return false;
  }
  numberContoursAsMachined(job);
  base::Problems problems = job.toolpath.problems;
  append(problems, checkTravel(job.toolpath, machine));
  append(problems, machineSpeedNotes(recipe, machine));
  base::keepFirstOfEachCode(problems);
  append(job.problems, problems);
  return job.canBeGround();
}

void planSpeeds(Job& job, const std::stop_token& stop) {
  job.track = makeTrack(job.toolpath, job.recipe, job.machine);
  job.limits = motion::axisLimits(job.recipe, job.machine);
  job.intervals = motion::speedLimits(job.track, job.limits, stop);
  if (!stop.stop_requested()) {
    job.pieces = planPieces(job.track, job.intervals, job.limits, stop);
  }
  if (!stop.stop_requested()) {
    job.cornerResults = cornerResults(job.track, job.pieces, job.toolpath.corners.size());
    timeIt(job);
  }
}

} // namespace

std::string_view name(Phase phase) {
  static constexpr std::array<std::string_view, kPhaseCount> kNames{"approach",   "plunge",     "lead-in", "cruise",
                                                                    "decelerate", "transition", "roll",    "stop",
                                                                    "accelerate", "lead-out",   "retract", "traverse"};
  return kNames[static_cast<std::size_t>(phase)];
}

Job planJob(const pattern::Pattern& pattern, const recipe::Recipe& recipe, const recipe::Machine& machine,
            toolpath::Leads leads, const base::Monitor& monitor) {
  base::takesLong("planJob");
  Job job;
  job.recipe = recipe;
  job.machine = machine;
  monitor.begin(base::Stage::WheelPath);
  if (planWheelPath(job, pattern, leads, monitor.stop)) {
    monitor.begin(base::Stage::Speeds);
    planSpeeds(job, monitor.stop);
  }
  if (monitor.stop.stop_requested()) {
    job.track.clear();
    job.pieces.clear();
    job.problems = {base::Problem(base::Code::Cancelled)};
  }
  return job;
}

} // namespace arris::job
