#pragma once

#include "core/control/simulated_axes.h"
#include "core/control/supervisor.h"

#include <memory>

namespace arris::control {

/// A simulated machine put together: axes, controller, channels and operator's side. In real time the controller has a
/// thread of its own; in simulated time it goes on when it is told to. For one thread, as the operator's side.
class Station {
public:
  /// Off, the axes in the middle of their travel.
  Station(const recipe::Machine& machine, Pace pace, Supervisor::Listener listener);

  /// Ends at once; whoever ends it has brought the axes to rest before.
  ~Station();
  Station(const Station&) = delete;
  Station& operator=(const Station&) = delete;

  /// Serves the operator's side; in simulated time after so many periods.
  void pass(int periods);

  [[nodiscard]] Supervisor& operatorSide();
  [[nodiscard]] const Supervisor& operatorSide() const;
  [[nodiscard]] SimulatedAxes& axes();

private:
  struct Parts;
  std::unique_ptr<Parts> m_parts;
};

} // namespace arris::control
