#include "tests/support/run_rows.h"

#include "tests/support/dice.h"

namespace arris::test {

std::vector<files::RunRow> runOf(const job::Job& job) {
  constexpr double kLag = 0.002;
  constexpr double kUncertainty = 2e-4;
  Dice dice(20);
  files::MeasuredVelocities velocities(job.machine.period);
  std::vector<files::RunRow> rows;
  const auto keep = [&](std::optional<files::RunRow> row) {
    if (row) {
      rows.push_back(*row);
    }
    return row.has_value();
  };
  for (job::Sampler sampler(job); !sampler.done();) {
    const job::Sample sample = sampler.next();
    const motion::SetPoint& at = sample.setPoint;
    files::RunRow run;
    run.row = {at.time,        at.position,    at.velocity,    at.axisAcceleration,     sample.speed,
               sample.path,    sample.contour, sample.segment, job::name(sample.phase), sample.corner,
               sample.distance};
    run.commanded = at.position;
    for (int axis = 0; axis < 3; ++axis) {
      run.row.position[axis] -= kLag * at.velocity[axis] + dice.between(-kUncertainty, kUncertainty);
    }
    keep(velocities.add(run));
  }
  while (keep(velocities.finish())) {
  }
  return rows;
}

} // namespace arris::test
