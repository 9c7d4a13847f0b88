#pragma once

#include "core/control/controller.h"
#include "core/job/job.h"

#include <string>

namespace arris::test {

/// Looks at every period of a machine and keeps the first promise that is broken: the limits of the axes, the path, the
/// cap of the speed, the table of states, rest where it is promised.
class RunWatch {
public:
  RunWatch(const job::Job& job, const recipe::Machine& machine);

  void add(const control::Report& report, const control::Cycle& cycle);

  /// Nothing where all promises were kept.
  [[nodiscard]] const std::string& broken() const {
    return m_broken;
  }

  /// The controller is now asked to break off without braking: the next set-points need not keep the limits.
  void expectBreak() {
    m_periods = 0;
  }

  double worstExcess = 0; ///< of a second difference above the limit, mm/s²

private:
  void checkLimits(const control::Report& report, const control::Cycle& cycle);
  void checkPath(const control::Report& report);
  void checkCap(const control::Report& report);
  void checkStates(const control::Report& report);
  void say(const std::string& what, const control::Report& report);
  [[nodiscard]] double capOf(const control::Report& report) const;

  const job::Job& m_job;
  double m_period;
  Eigen::Vector3d m_byHand;                 ///< accelerations of jog and homing
  std::vector<std::size_t> m_firstInterval; ///< by segment
  Eigen::Vector3d m_before{0, 0, 0};
  Eigen::Vector3d m_last{0, 0, 0};
  int m_periods = 0;
  int m_sinceProgram = 3;
  control::Report m_report;
  bool m_hasReport = false;
  std::string m_broken;
};

} // namespace arris::test
