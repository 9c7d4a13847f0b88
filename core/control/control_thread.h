#pragma once

#include "core/control/axis_driver.h"
#include "core/control/controller.h"
#include "core/control/timing.h"

#include <atomic>
#include <string>
#include <thread>

namespace arris::control {

/// Calls the controller on time: wakes up every period by an absolute clock and keeps the axes supplied with set-points
/// for the lead. Real-time scheduling and locked memory where the system allows them. However it ends, the drives are
/// switched off.
class ControlThread {
public:
  /// Refers to controller and driver; both belong to this thread from now on.
  ControlThread(Controller& controller, AxisDriver& driver, double period);
  ControlThread(const ControlThread&) = delete;
  ControlThread& operator=(const ControlThread&) = delete;

  /// Ends the loop at once; whoever ends it has brought the axes to rest before.
  ~ControlThread();

  [[nodiscard]] Timing timing() const;

  /// What the system did not allow, for the log; empty where all is as it should be. Known once the thread runs.
  [[nodiscard]] std::string shortcomings() const;

private:
  void run();
  void supply();

  Controller& m_controller;
  AxisDriver& m_driver;
  double m_period;
  std::atomic<bool> m_ends = false;
  std::atomic<std::int64_t> m_lateWakeUps = 0;
  std::atomic<int> m_worstLead;
  std::atomic<double> m_worstLateness = 0;
  std::atomic<int> m_notAllowed = 0; ///< bits: 1 scheduling, 2 locked memory; 4 known
  std::thread m_thread;              ///< last: it uses the others
};

} // namespace arris::control
