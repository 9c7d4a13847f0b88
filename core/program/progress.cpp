#include "core/program/progress.h"

#include <algorithm>
#include <cmath>

namespace arris::program {

WorkingWay::WorkingWay(const job::Job& job) : m_track(job.track), m_before{0} {
  m_before.reserve(m_track.size() + 1);
  for (const motion::Segment& segment : m_track) {
    const bool works = motion::isAlongContour(segment.move);
    m_before.push_back(m_before.back() + (works ? motion::arcLength(segment, motion::parameterLength(segment)) : 0));
  }
}

double WorkingWay::before(const JobPlace& place) const {
  if (place.segment < 0) {
    return 0;
  }
  const auto index = static_cast<std::size_t>(place.segment);
  if (index >= m_track.size()) {
    return length();
  }
  const motion::Segment& on = m_track[index];
  const double lambda = std::clamp(place.lambda, 0.0, motion::parameterLength(on));
  return m_before[index] + (motion::isAlongContour(on.move) ? motion::arcLength(on, lambda) : 0);
}

Timetable::Timetable(const job::Job& job, double overrideFactor) : m_override(overrideFactor) {
  if (job.track.empty()) {
    return;
  }
  motion::Interpolator interpolator(job.track, job.intervals, job.limits);
  interpolator.setOverride(overrideFactor);
  do {
    if (interpolator.piece().duration > 0) {
      m_pieces.push_back(interpolator.piece());
    }
  } while (interpolator.nextPiece());
  m_duration = m_pieces.empty() ? 0 : m_pieces.back().time + m_pieces.back().duration;
}

double Timetable::left(const JobPlace& place) const {
  const auto isBefore = [](const JobPlace& at, const motion::Piece& piece) {
    return at.segment < piece.segment || (at.segment == piece.segment && at.lambda < piece.lambda);
  };
  const auto next = std::upper_bound(m_pieces.begin(), m_pieces.end(), place, isBefore);
  if (next == m_pieces.begin()) {
    return m_duration;
  }
  const motion::Piece& on = *std::prev(next);
  const bool isLeft = place.segment > on.segment; // a segment in which no time passes
  const double way = isLeft ? on.endLambda - on.lambda : std::min(place.lambda, on.endLambda) - on.lambda;
  const double speed = on.speed + std::sqrt(std::max(0.0, on.speed * on.speed + 2 * on.acceleration * way));
  const double since = isLeft ? on.duration : speed > 0 ? std::min(2 * way / speed, on.duration) : 0;
  return m_duration - on.time - since;
}

} // namespace arris::program
