#include "core/job/trajectory.h"

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
  return sampleOn(m_job, m_job.pieces[m_piece], m_travelled, time);
}

} // namespace arris::job
