#pragma once

#include "core/control/controller.h"
#include "core/control/supervisor.h"
#include "tests/support/ideal_axes.h"

#include <functional>
#include <memory>

namespace arris::test {

/// A whole machine in simulated time: operator's side, channels, controller and axes, one period after the other.
class Bench {
public:
  explicit Bench(const recipe::Machine& machineOfBench, std::launch planning = std::launch::deferred);
  Bench(recipe::Machine machineOfBench, std::unique_ptr<control::AxisDriver> driver,
        std::launch planning = std::launch::deferred);

  /// Switched on, homed, the job loaded, the wheel parked.
  void getReady(const job::Job& job);

  /// One period, the operator's side every `servedEvery` periods.
  void period();

  /// Periods until `isSo`; false where that does not come about within `seconds`.
  bool until(const std::function<bool()>& isSo, double seconds);

  /// Until the controller is in the state.
  bool until(control::State state, double seconds) {
    return until([this, state] { return report().state == state; }, seconds);
  }

  void runFor(double seconds);

  [[nodiscard]] const control::Report& report() const {
    return controller.report();
  }

  recipe::Machine machine;
  control::Channels channels;
  control::Controller controller;
  control::Supervisor supervisor;
  IdealAxes* ideal = nullptr; ///< where they are these
  std::unique_ptr<control::AxisDriver> axes;
  std::function<void(const control::Report&, const control::Cycle&)> onPeriod; ///< hears of every period
  std::vector<control::FaultReport> faults;
  int servedEvery = 10;
  bool operatorLives = true;

private:
  std::int64_t m_count = 0;
};

} // namespace arris::test
