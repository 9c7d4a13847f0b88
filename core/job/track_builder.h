#pragma once

#include "core/job/job.h"

#include <utility>
#include <vector>

namespace arris::job {

/// Strings the moves of a program together from a place where the wheel is at rest. Rapids and plunges run in straight
/// lines, up and down or level, each from rest to rest; what has no length is left out.
class TrackBuilder {
public:
  /// The machine is referred to; `from` in mm on the table.
  TrackBuilder(const recipe::Machine& machine, Eigen::Vector3d from) : m_machine(machine), m_at(std::move(from)) {}

  /// Straight up or down to the height `to`, mm; a plunge at the plunge feed, all else as fast as the axis runs.
  void vertical(motion::Move move, double to);

  /// At the present height, as fast as the axes run.
  void across(motion::Move move, const geometry::Point& to);

  /// As it is; it starts where the wheel is.
  void add(const motion::Segment& segment);

  /// Where the wheel is by now, mm on the table.
  [[nodiscard]] const Eigen::Vector3d& at() const {
    return m_at;
  }

  std::vector<motion::Segment> take() {
    return std::move(m_track);
  }

private:
  const recipe::Machine& m_machine;
  Eigen::Vector3d m_at;
  std::vector<motion::Segment> m_track;
};

} // namespace arris::job
