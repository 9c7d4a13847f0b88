#include "core/program/program.h"

namespace arris::program {

Program jobProgram(const job::Job& job) {
  Program program{Kind::Job, job.track, job.intervals, {}, job.limits, job.cornerResults};
  program.places.reserve(job.track.size());
  for (int segment = 0; segment < static_cast<int>(job.track.size()); ++segment) {
    program.places.push_back({{segment, 0}, 1});
  }
  return program;
}

} // namespace arris::program
