#include "core/job/program_track.h"
#include "core/job/track_builder.h"
#include "core/program/manoeuvres.h"

#include <utility>

namespace arris::program {
namespace {

using motion::Move;
using motion::Segment;

Program positioning(std::vector<Segment> track, const motion::AxisLimits& limits) {
  Program program{Kind::Positioning, std::move(track), {}, {}, limits};
  program.places.assign(program.track.size(), {{}, 0});
  program.intervals = motion::speedLimits(program.track, limits);
  return program;
}

} // namespace

Program traceProgram(const job::Job& job, const Position& at) {
  const job::Heights heights = job::heightsOf(job.recipe, job.machine);
  job::TrackBuilder builder(job.machine, at);
  Move there = Move::Approach;
  bool isOnChain = false;
  for (Segment segment : job.track) {
    if (segment.contour == 0) {
      isOnChain = false;
      continue;
    }
    if (!isOnChain) {
      builder.vertical(there, heights.top);
      builder.across(there, geometry::startPoint(motion::curveOf(segment)));
      builder.vertical(Move::Approach, heights.clearance);
      there = Move::Traverse;
      isOnChain = true;
    }
    segment.z = heights.clearance;
    builder.add(segment);
  }
  builder.vertical(Move::Traverse, heights.top);
  return positioning(builder.take(), job.limits);
}

Program parkProgram(const recipe::Recipe& recipe, const recipe::Machine& machine, const Position& at) {
  job::TrackBuilder builder(machine, at);
  builder.vertical(Move::Retract, job::heightsOf(recipe, machine).top);
  builder.across(Move::Traverse, machine.park.head<2>());
  builder.vertical(Move::Traverse, machine.park.z());
  return positioning(builder.take(), motion::axisLimits(recipe, machine));
}

} // namespace arris::program
