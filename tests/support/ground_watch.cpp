#include "tests/support/ground_watch.h"

#include <fmt/format.h>

namespace arris::test {

using control::Report;
using motion::Move;
using program::JobPlace;

namespace {

/// More periods than the axes are behind.
constexpr std::size_t kRemembered = 4096;

/// Axes this near are where they were ordered to be, mm.
constexpr double kThere = 1e-6;

/// A place beside a transition may be told so wrong, mm.
constexpr double kGroundRounding = 1e-3;

bool isOfContour(Move move) {
  return move == Move::Contour || move == Move::Transition || move == Move::Roll;
}

} // namespace

GroundWatch::GroundWatch(const job::Job& job) : m_job(job), m_ordered(kRemembered) {}

void GroundWatch::add(const Report& report) {
  const bool isInMotion = report.isInMotion && report.place.segment >= 0;
  m_ordered[static_cast<std::size_t>(report.tick) % kRemembered] = {
      report.program, isInMotion && report.kind == program::Kind::Job, report.place, report.speed, report.commanded};
  if (isInMotion && report.kind == program::Kind::Step) {
    moveOn(report.place);
  }
  if (report.measuredTick > m_measuredTick && report.tick - report.measuredTick < std::int64_t{kRemembered}) {
    m_measuredTick = report.measuredTick;
    const Ordered& reached = m_ordered[static_cast<std::size_t>(m_measuredTick) % kRemembered];
    if (reached.isOnJob && (report.measured - reached.commanded).norm() < kThere) {
      pass(reached);
    }
  }
}

void GroundWatch::pass(const Ordered& reached) {
  if (reached.program != m_program) { // in the first period the wheel is a little behind where it joined the way
    const double passedOver = workBetween(m_reached, reached.place) - reached.speed * m_job.machine.period;
    if (passedOver > kGroundRounding && m_missing.empty()) {
      m_missing = fmt::format("{} mm were not ground behind λ {} of segment {}", passedOver, m_reached.lambda,
                              m_reached.segment);
    }
  }
  m_program = reached.program;
  moveOn(reached.place);
}

void GroundWatch::moveOn(const JobPlace& place) {
  const bool isFarther =
      place.segment > m_reached.segment || (place.segment == m_reached.segment && place.lambda > m_reached.lambda);
  m_reached = isFarther ? place : m_reached;
}

// Negative or nothing where `to` does not lie behind.
double GroundWatch::workBetween(const JobPlace& from, const JobPlace& to) const {
  double work = 0;
  for (int i = from.segment; i <= to.segment; ++i) {
    const motion::Segment& segment = m_job.track[static_cast<std::size_t>(i)];
    if (isOfContour(segment.move)) {
      const double end = i == to.segment ? to.lambda : motion::parameterLength(segment);
      work += motion::arcLength(segment, end) - motion::arcLength(segment, i == from.segment ? from.lambda : 0);
    }
  }
  return work;
}

std::string GroundWatch::missing(bool isOver) const {
  const int last = static_cast<int>(m_job.track.size()) - 1;
  const JobPlace end{last, motion::parameterLength(m_job.track.back())};
  const double left = isOver ? workBetween(m_reached, end) : 0;
  return m_missing.empty() && left > kGroundRounding ? fmt::format("the last {} mm were not ground", left) : m_missing;
}

} // namespace arris::test
