#pragma once

#include "core/control/report.h"
#include "core/job/job.h"

#include <string>
#include <vector>

namespace arris::test {

/// Looks at every period of the runs of one pane, how often they may be broken off and resumed, and keeps the first
/// part of the contours that the axes have passed over: they were there neither on the path nor, beside it, by a step
/// that the operator wanted.
class GroundWatch {
public:
  /// Refers to the job.
  explicit GroundWatch(const job::Job& job);

  void add(const control::Report& report);

  /// Nothing where everything up to here, or once the job `isOver` everything, was ground.
  [[nodiscard]] std::string missing(bool isOver) const;

private:
  /// What was ordered in a period.
  struct Ordered {
    std::uint32_t program = 0;
    bool isOnJob = false;
    program::JobPlace place;
    double speed = 0;
    Eigen::Vector3d commanded{0, 0, 0};
  };

  void pass(const Ordered& reached);
  void moveOn(const program::JobPlace& place);
  [[nodiscard]] double workBetween(const program::JobPlace& from, const program::JobPlace& to) const;

  const job::Job& m_job;
  std::vector<Ordered> m_ordered; ///< by tick, a ring
  std::uint32_t m_program = 0;    ///< with which the axes were last on the job's way
  std::int64_t m_measuredTick = -1;
  program::JobPlace m_reached{0, 0};
  std::string m_missing;
};

} // namespace arris::test
