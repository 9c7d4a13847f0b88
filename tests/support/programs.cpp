#include "tests/support/programs.h"

#include "core/base/numbers.h"
#include "tests/support/random_glass.h"
#include "tests/support/random_panes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace arris::test {
namespace {

using Eigen::Vector3d;
using motion::Segment;

constexpr double kNoGap = 1e-9;            ///< mm
constexpr double kRoundingOfSecond = 1e-6; ///< mm/s², of a second difference in double precision

Vector3d directionAt(const Segment& segment, double lambda) {
  return motion::evaluate(segment, lambda).first.normalized();
}

} // namespace

std::vector<job::Job> jobsOfAllKinds(int ofEach) {
  std::vector<job::Job> jobs;
  std::uint64_t seed = 1;
  for (int i = 0; i < ofEach; ++i) {
    jobs.push_back(randomJob(seed));
  }
  for (std::uint64_t glass = 1; static_cast<int>(jobs.size()) < 2 * ofEach; ++glass) {
    job::Job job = planned(randomGlass(glass, {false, true}));
    if (job.canBeGround()) {
      jobs.push_back(std::move(job));
    }
  }
  return jobs;
}

testing::AssertionResult isOneMotion(const program::Program& program, const Vector3d& start) {
  if (program.track.empty() || program.places.size() != program.track.size()) {
    return testing::AssertionFailure() << program.track.size() << " segments, " << program.places.size() << " places";
  }
  Vector3d reached = start;
  for (std::size_t i = 0; i < program.track.size(); ++i) {
    const Segment& segment = program.track[i];
    const double gap = (motion::evaluate(segment, 0).point - reached).norm();
    if (!(gap <= kNoGap)) {
      return testing::AssertionFailure() << "a gap of " << gap << " mm before segment " << i;
    }
    reached = motion::evaluate(segment, motion::parameterLength(segment)).point;
    if (i > 0 && !program.track[i - 1].stopAtEnd) {
      const Segment& before = program.track[i - 1];
      const double bend = (directionAt(segment, 0) - directionAt(before, motion::parameterLength(before))).norm();
      if (!(bend <= kNoGap)) {
        return testing::AssertionFailure() << "a bend of " << bend << " before segment " << i;
      }
    }
  }
  return program.track.back().stopAtEnd ? testing::AssertionSuccess()
                                        : testing::AssertionFailure() << "it does not stop at its end";
}

testing::AssertionResult keepsTheLimits(const program::Program& program) {
  constexpr double kPeriod = 0.001;
  constexpr double kMost = 5000; // s
  motion::Interpolator interpolator(program.track, program.intervals, program.limits);
  const Vector3d start = motion::evaluate(program.track.front(), 0).point;
  std::array<Vector3d, 3> last{start, start, start};
  for (int tick = 1; !interpolator.atEnd(); ++tick) {
    const double time = tick * kPeriod;
    const motion::SetPoint point = interpolator.advanceTo(time);
    last = {last[1], last[2], point.position};
    const Vector3d second = (last[0] - 2 * last[1] + last[2]) / base::squared(kPeriod);
    const double over = (second.cwiseAbs() - program.limits.acceleration).maxCoeff();
    if (!interpolator.atEnd() && !(over <= kRoundingOfSecond)) {
      return testing::AssertionFailure() << over << " mm/s² too much at " << time << " s in segment " << point.segment;
    }
    if (!((point.velocity.cwiseAbs() - program.limits.speed).maxCoeff() <= kRoundingOfSecond)) {
      return testing::AssertionFailure() << "an axis is too fast at " << time << " s";
    }
    if (time > kMost) {
      return testing::AssertionFailure() << "it does not come to its end";
    }
  }
  const Segment& end = program.track.back();
  const double missing = (last[2] - motion::evaluate(end, motion::parameterLength(end)).point).norm();
  return missing <= kNoGap ? testing::AssertionSuccess()
                           : testing::AssertionFailure() << "it ends " << missing << " mm too early";
}

std::vector<double> placesAlong(const Segment& segment) {
  const double length = motion::parameterLength(segment);
  const int count = 4 + static_cast<int>(length);
  std::vector<double> places;
  for (int i = 0; i <= count; ++i) {
    places.push_back(length * i / count);
  }
  return places;
}

Vector3d wheelAt(const job::Job& job, const program::JobPlace& place, double beside) {
  const motion::Evaluation way = motion::evaluate(job.track.at(static_cast<std::size_t>(place.segment)), place.lambda);
  const double left = job.recipe.direction == recipe::Direction::Clockwise ? beside : -beside;
  const Vector3d direction = way.first.normalized();
  return way.point + left * Vector3d(-direction.y(), direction.x(), 0);
}

} // namespace arris::test
