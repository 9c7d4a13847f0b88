#include "core/job/job.h"

#include <cmath>

namespace arris::job {

namespace {

/// A period that ends this near to the end of the program is its end, as a share of the period.
constexpr double kLastPeriod = 1e-6;

} // namespace

Sampler::Sampler(const Job& job, double period)
    : m_job(job), m_period(period),
      m_periods(static_cast<std::size_t>(std::ceil(job.duration / period - kLastPeriod))) {}

std::size_t Sampler::count() const {
  return m_job.pieces.empty() ? 0 : m_periods + 1;
}

bool Sampler::done() const {
  return m_row >= count();
}

void Sampler::goTo(double time) {
  const auto& pieces = m_job.pieces;
  while (m_piece + 1 < pieces.size() && pieces[m_piece + 1].motion.time <= time) {
    const int segment = pieces[m_piece].motion.segment;
    ++m_piece;
    if (pieces[m_piece].motion.segment != segment) {
      const motion::Segment& left = m_job.track[static_cast<std::size_t>(segment)];
      m_travelled += motion::arcLength(left, motion::parameterLength(left));
    }
  }
}

Sample Sampler::next() {
  const double time = m_row < m_periods ? static_cast<double>(m_row) * m_period : m_job.duration;
  ++m_row;
  goTo(time);
  const PlannedPiece& piece = m_job.pieces[m_piece];
  const motion::Segment& segment = m_job.track[static_cast<std::size_t>(piece.motion.segment)];
  Sample sample;
  sample.setPoint = motion::setPointAt(piece.motion, segment, time);
  sample.speed = sample.setPoint.velocity.norm();
  sample.path = m_travelled + motion::arcLength(segment, sample.setPoint.lambda);
  sample.contour = segment.contour;
  sample.segment = segment.number;
  sample.corner = piece.corner;
  sample.phase = piece.phase;
  if (piece.corner != 0) {
    const toolpath::Corner& corner = m_job.toolpath.corners[static_cast<std::size_t>(piece.corner - 1)];
    sample.distance = (sample.setPoint.position.head<2>() - corner.s).norm();
  }
  return sample;
}

} // namespace arris::job
