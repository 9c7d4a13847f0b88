#pragma once

#include "core/control/linuxcnc/hal_component.h"
#include "core/recipe/recipe.h"

#include <memory>
#include <string>

namespace arris::control {

/// Axes behind a HAL session of LinuxCNC: set-points go to its `streamer`, feedback comes from its `sampler`, signals
/// through the pins of the component `arris`. Each set-point carries a number that comes back with the places measured,
/// so that feedback belongs to its set-point whatever the delay. When it is destroyed, as when its process dies, the
/// heartbeat stands still and the session brakes the axes and takes their power away.
class LinuxcncAxes final : public AxisDriver {
public:
  explicit LinuxcncAxes(std::unique_ptr<HalComponent> hal);

  /// Waits until set-points that a dead Arris left are used up and the first feedback has come, a second at most, and
  /// compares the session's period (s) with the machine's. Says in English what is wrong, or nothing.
  [[nodiscard]] std::string begin(double period);

  [[nodiscard]] Feedback read() override;
  bool write(const Eigen::Vector3d& setPoint, const Outputs& outputs) override;
  [[nodiscard]] int queued() override;

private:
  void drain();
  void readInputs();
  void apply(const Outputs& outputs);

  std::unique_ptr<HalComponent> m_hal;
  Feedback m_feedback;
  std::int64_t m_samples = 0;     ///< taken from the sampler
  double m_number = 0;            ///< of the last sample
  double m_firstNumber = 0;       ///< of the first set-point written
  double m_time = 0, m_spell = 0; ///< s, of the last sample and since the one before
  std::int64_t m_written = 0;
  std::int32_t m_underrunsBefore = 0;
  bool m_lastHeartbeat = false;
  std::int64_t m_beatSample = 0; ///< samples taken when the heartbeat last changed
};

} // namespace arris::control
