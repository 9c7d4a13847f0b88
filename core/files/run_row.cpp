#include "core/files/run_row.h"

#include <algorithm>
#include <cmath>

namespace arris::files {

namespace {

/// Measured velocities are differences over twice this, s (contract).
constexpr double kReach = 0.01;

} // namespace

MeasuredVelocities::MeasuredVelocities(double period)
    : m_reach(static_cast<std::size_t>(std::max(1L, std::lround(kReach / period)))) {}

std::optional<RunRow> MeasuredVelocities::add(const RunRow& row) {
  m_rows.push_back(row);
  return m_rows.size() - m_next > m_reach ? std::optional(take()) : std::nullopt;
}

std::optional<RunRow> MeasuredVelocities::finish() {
  return m_next < m_rows.size() ? std::optional(take()) : std::nullopt;
}

RunRow MeasuredVelocities::take() {
  RunRow result = m_rows[m_next];
  const ProfileRow& before = m_rows.front().row;
  const ProfileRow& after = m_rows.back().row;
  if (after.time > before.time) { // not where the run has one row only
    result.measuredVelocity = (after.position - before.position) / (after.time - before.time);
  }
  if (m_next == m_reach) {
    m_rows.pop_front();
  } else {
    ++m_next;
  }
  return result;
}

} // namespace arris::files
