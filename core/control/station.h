#pragma once

#include "core/control/simulated_axes.h"
#include "core/control/supervisor.h"
#include "core/control/timing.h"

#include <memory>
#include <optional>

namespace arris::control {

class ControlThread;

/// A machine put together: axes, controller, channels and operator's side. In real time the controller has a thread of
/// its own; in simulated time it goes on when it is told to. For one thread, as the operator's side.
class Station {
public:
  /// `eachPeriod` hears of every period of simulated time before the next one.
  Station(const recipe::Machine& machine, std::unique_ptr<AxisDriver> axes, Pace pace, Supervisor::Listener listener,
          std::function<void(const Report&)> eachPeriod = {});

  /// Ends at once; whoever ends it has brought the axes to rest before.
  ~Station();
  Station(const Station&) = delete;
  Station& operator=(const Station&) = delete;

  /// Serves the operator's side; in simulated time after so many periods.
  void pass(int periods);

  [[nodiscard]] Supervisor& operatorSide();
  [[nodiscard]] const Supervisor& operatorSide() const;

  /// Null in simulated time.
  [[nodiscard]] const ControlThread* thread() const;

  /// Of that thread; none in simulated time.
  [[nodiscard]] std::optional<Timing> timing() const;

private:
  struct Parts;
  std::unique_ptr<Parts> m_parts;
};

} // namespace arris::control
