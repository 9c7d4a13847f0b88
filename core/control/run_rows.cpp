#include "core/control/run_rows.h"

#include <cmath>
#include <utility>

namespace arris::control {

namespace {

using job::Phase;
using motion::Move;

/// A change of speed slower than this is rounding, mm/s².
constexpr double kSteady = 1e-6;

std::string_view phaseOfMove(const Report& report) {
  switch (report.move) {
  case Move::Approach:
    return job::name(Phase::Approach);
  case Move::Plunge:
    return job::name(Phase::Plunge);
  case Move::LeadIn:
    return job::name(Phase::LeadIn);
  case Move::Transition:
    return job::name(Phase::Transition);
  case Move::Roll:
    return job::name(Phase::Roll);
  case Move::LeadOut:
    return job::name(Phase::LeadOut);
  case Move::Retract:
    return job::name(Phase::Retract);
  case Move::Traverse:
    return job::name(Phase::Traverse);
  case Move::Contour:
    break;
  }
  if (std::abs(report.acceleration) < kSteady) {
    return job::name(Phase::Cruise);
  }
  return job::name(report.acceleration > 0 ? Phase::Accelerate : Phase::Decelerate);
}

std::string_view phaseOfReport(const Report& report) {
  switch (report.state) {
  case State::Starting:
    return "dwell";
  case State::Holding:
  case State::Held:
  case State::Stopping:
    return "hold";
  case State::Stepping:
    return "step";
  default:
    return phaseOfMove(report);
  }
}

} // namespace

RunRows::RunRows(std::shared_ptr<const job::Job> job, std::function<void(const files::RunRow&)> sink)
    : m_job(std::move(job)), m_sink(std::move(sink)), m_velocities(m_job->machine.period) {}

bool RunRows::add(const Report& report) {
  const bool belongs = report.runTick >= 0;
  if (belongs) {
    Row row = rowOf(report);
    attribute(row);
    m_waiting.push_back(row);
    m_last = std::move(row);
    m_hasLast = true;
  }
  measure(report);
  tell();
  return belongs;
}

RunRows::Row RunRows::rowOf(const Report& report) {
  Row row;
  row.tick = report.tick;
  row.segment = report.isInMotion ? report.segment : -1;
  row.stopCorner = report.isInMotion ? report.stopCorner : 0;
  files::ProfileRow& profile = row.row.row;
  profile.time = static_cast<double>(report.runTick) * m_job->machine.period;
  profile.position = report.commanded; // until it is measured
  profile.velocity = report.velocity;
  profile.acceleration = report.axisAcceleration;
  profile.speed = report.velocity.norm();
  profile.path = report.path;
  profile.phase = phaseOfReport(report);
  profile.contour = report.contour;
  profile.segment = report.number;
  row.row.commanded = report.commanded;
  row.isAttributed = true;
  const bool atCorner = profile.phase == job::name(Phase::Transition) || profile.phase == job::name(Phase::Roll);
  if (atCorner) {
    setCorner(row.row, report.corner);
  }
  return row;
}

// A change of speed belongs to the corner that it runs into or comes out of, without a break; see job/phases.cpp.
void RunRows::attribute(Row& next) {
  files::RunRow& row = next.row;
  const bool leavesStop =
      m_hasLast && m_last.stopCorner != 0 && m_last.segment >= 0 && next.segment == m_last.segment + 1;
  const bool accelerates = row.row.phase == job::name(Phase::Accelerate);
  const bool decelerates = row.row.phase == job::name(Phase::Decelerate);
  if (leavesStop) {
    m_leaving = m_last.stopCorner;
  }
  const int runsInto = leavesStop ? m_last.stopCorner : row.row.corner;
  if (!decelerates || leavesStop) { // it is known now what the deceleration before was for
    for (auto waiting = m_waiting.rbegin(); waiting != m_waiting.rend() && !waiting->isAttributed; ++waiting) {
      if (runsInto != 0) {
        setCorner(waiting->row, runsInto);
      }
      waiting->isAttributed = true;
    }
  }
  if (accelerates && m_leaving != 0) {
    setCorner(row, m_leaving);
  } else if (row.row.corner != 0) {
    m_leaving = row.row.corner;
  } else if (!accelerates && !leavesStop) {
    m_leaving = 0;
  }
  next.isAttributed = !decelerates;
}

void RunRows::setCorner(files::RunRow& row, int corner) const {
  row.row.corner = corner;
  if (corner != 0) {
    const geometry::Point& s = m_job->toolpath.corners[static_cast<std::size_t>(corner - 1)].s;
    row.row.distance = (row.commanded.head<2>() - s).norm();
  }
}

void RunRows::measure(const Report& report) {
  for (Row& row : m_waiting) {
    if (row.tick > report.measuredTick) {
      break;
    }
    if (!row.isMeasured) {
      row.row.row.position = report.measured;
      row.isMeasured = true;
    }
  }
}

void RunRows::tell() {
  while (!m_waiting.empty() && m_waiting.front().isMeasured && m_waiting.front().isAttributed) {
    tell(m_waiting.front().row);
    m_waiting.pop_front();
  }
}

void RunRows::tell(const files::RunRow& row) {
  if (const auto ready = m_velocities.add(row)) {
    m_sink(*ready);
  }
}

void RunRows::finish() {
  if (std::exchange(m_finished, true)) {
    return;
  }
  for (const Row& row : m_waiting) {
    tell(row.row);
  }
  m_waiting.clear();
  while (const auto row = m_velocities.finish()) {
    m_sink(*row);
  }
}

} // namespace arris::control
