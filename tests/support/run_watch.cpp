#include "tests/support/run_watch.h"

#include "core/base/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace arris::test {

using base::squared;
using control::Aside;
using control::Report;
using control::State;

namespace {

/// Rounding of a second difference over a period in double precision at places of 1 m, mm · (periods of 1 ms make
/// mm/s² of it).
constexpr double kPlaceRounding = 4e-12;

bool follows(State from, State to) {
  for (int event = 0; event < control::kEventCount; ++event) {
    if (control::isAllowed(from, static_cast<control::Event>(event), to)) {
      return true;
    }
  }
  return from == to;
}

// A command and what comes of it at once may fall into one period.
bool isPossible(State from, State to) {
  for (int between = 0; between < control::kStateCount; ++between) {
    if (follows(from, static_cast<State>(between)) && follows(static_cast<State>(between), to)) {
      return true;
    }
  }
  return false;
}

} // namespace

RunWatch::RunWatch(const job::Job& job, const recipe::Machine& machine)
    : m_job(job), m_period(machine.period), m_byHand(0.2 * machine.maxAccel) {
  for (std::size_t i = 0; i < job.intervals.size(); ++i) {
    if (static_cast<std::size_t>(job.intervals[i].segment) == m_firstInterval.size()) {
      m_firstInterval.push_back(i);
    }
  }
}

void RunWatch::say(const std::string& what, const Report& report) {
  if (m_broken.empty()) {
    m_broken = fmt::format("period {} ({}): {}", report.tick, control::name(report.state), what);
  }
}

void RunWatch::add(const Report& report, const control::Cycle& cycle) {
  checkLimits(report, cycle);
  checkPath(report);
  checkCap(report);
  checkStates(report);
  m_report = report;
  m_hasReport = true;
}

// The recipe's limits while a program is there, those of jog and homing otherwise.
void RunWatch::checkLimits(const Report& report, const control::Cycle& cycle) {
  if (!report.drivesReady) {
    m_periods = 0;
  }
  m_sinceProgram = report.program != 0 ? 0 : m_sinceProgram + 1;
  if (m_periods >= 2) {
    const bool hasProgram = m_sinceProgram < 3; // a second difference looks back on three periods
    for (int axis = 0; axis < 3; ++axis) {
      const double second = (cycle.setPoint[axis] - 2 * m_last[axis] + m_before[axis]) / squared(m_period);
      const double limit = hasProgram ? m_job.limits.acceleration[axis] : m_byHand[axis];
      const double excess = std::abs(second) - limit;
      worstExcess = std::max(worstExcess, excess);
      if (!(excess <= 1e-5 * limit + kPlaceRounding / squared(m_period))) {
        say(fmt::format("second difference of axis {} is {} mm/s² above its limit {}", axis, excess, limit), report);
      }
    }
  }
  ++m_periods;
  m_before = m_last;
  m_last = cycle.setPoint;
}

void RunWatch::checkPath(const Report& report) {
  const bool onJob = report.isInMotion && report.kind == program::Kind::Job && report.place.segment >= 0 &&
                     m_hasReport && !(report.place == m_report.place);
  if (!onJob) {
    return;
  }
  const motion::Segment& on = m_job.track[static_cast<std::size_t>(report.place.segment)];
  const double off = (motion::evaluate(on, report.place.lambda).point - report.commanded).norm();
  if (!(off < 1e-8)) {
    say(fmt::format("{} mm off the path", off), report);
  }
}

// c of the method: o·min(K, feed), above an override of 1 min(K, o·feed).
double RunWatch::capOf(const Report& report) const {
  std::size_t i = m_firstInterval[static_cast<std::size_t>(report.segment)];
  while (m_job.intervals[i].to < report.lambda && i + 1 < m_job.intervals.size() &&
         m_job.intervals[i + 1].segment == report.segment) {
    ++i;
  }
  const motion::Interval& on = m_job.intervals[i];
  const double length = on.to - on.from;
  const double share = length > 0 ? (report.lambda - on.from) / length : 0;
  const double k2 =
      std::min(on.cap2 + (on.capEnd2 - on.cap2) * share, on.end2 + 2 * on.brake * (on.to - report.lambda));
  const double k = std::sqrt(std::max(0.0, k2));
  const double feed = m_job.track[static_cast<std::size_t>(report.segment)].feed;
  const double o = report.overrideFactor;
  return o <= 1 ? o * std::min(k, feed) : std::min(k, o * feed);
}

void RunWatch::checkCap(const Report& report) {
  const bool isFirst = report.program == m_report.program && report.place.segment == report.segment &&
                       report.place.lambda == report.lambda && report.kind == program::Kind::Job;
  if (report.state != State::Running || !report.isInMotion || !isFirst || !m_hasReport) {
    return;
  }
  if (report.speed > capOf(report) * (1 + 1e-6) + 1e-6 && report.acceleration > 1e-6) {
    say(fmt::format("speeds up by {} mm/s² at {} mm/s, above the cap {}", report.acceleration, report.speed,
                    capOf(report)),
        report);
  }
}

void RunWatch::checkStates(const Report& report) {
  if (m_hasReport && !isPossible(m_report.state, report.state)) {
    say(fmt::format("{} does not follow {}", control::name(report.state), control::name(m_report.state)), report);
  }
  const bool rests = report.state == State::Idle || report.state == State::Faulted || report.state == State::NotHomed ||
                     (report.state == State::Held && report.aside != Aside::BackingOff);
  const bool rested = m_hasReport && m_report.state == report.state && m_report.aside == report.aside;
  if (rests && rested && report.drivesReady && m_report.drivesReady && report.origin == m_report.origin &&
      report.commanded != m_report.commanded) {
    say("moves although it is at rest", report);
  }
}

} // namespace arris::test
