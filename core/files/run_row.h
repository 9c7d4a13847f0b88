#pragma once

#include "core/files/profile_csv.h"

#include <deque>
#include <optional>

namespace arris::files {

/// One row of a run, per servo period. mm, mm/s; `row.position` is measured, velocity and acceleration are commanded.
struct RunRow {
  ProfileRow row;
  Eigen::Vector3d commanded{0, 0, 0};
  Eigen::Vector3d measuredVelocity{0, 0, 0};
};

/// Measured velocities of the rows of a run: central differences of the measured positions over 20 ms, at both ends of
/// the run over what there is of them. Rows pass through and come out 10 ms later. For the thread that keeps the files;
/// it allocates.
class MeasuredVelocities {
public:
  /// `period` (s) of the rows; where it is longer than 10 ms, the neighbouring rows are taken.
  explicit MeasuredVelocities(double period);

  /// Takes the next row; the row whose velocity it decides, once there is one. Time increases from row to row.
  [[nodiscard]] std::optional<RunRow> add(const RunRow& row);

  /// After the last row: the rows that are still waiting, one a call.
  [[nodiscard]] std::optional<RunRow> finish();

private:
  RunRow take();

  std::size_t m_reach;       ///< rows that a difference reaches to either side
  std::deque<RunRow> m_rows; ///< from the first that the next difference needs
  std::size_t m_next = 0;    ///< of these, the one that comes out next
};

} // namespace arris::files
