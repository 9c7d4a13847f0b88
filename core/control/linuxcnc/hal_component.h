#pragma once

#include "core/control/axis_driver.h"

#include <csignal> // which hal.h needs and does not include
#include <cstdint>

extern "C" {
#include <hal.h>
}

#include <tl/expected.hpp>

#include <memory>
#include <string>
#include <vector>

namespace arris::control {

/// The values of Arris's pins, in HAL's memory.
struct HalPins {
  using Axes = std::array<hal_data_u*, kAxes>;
  hal_data_u* emergencyStop = nullptr;
  Axes limitLow{}, limitHigh{}, reference{}, driveReady{}, driveFault{}, encoderLost{};
  hal_data_u *spindleAtSpeed = nullptr, *coolantFlow = nullptr, *vacuum = nullptr;
  hal_data_u *cycleStart = nullptr, *hold = nullptr, *stop = nullptr, *jogEnable = nullptr;
  hal_data_u* overridePercent = nullptr;
  Axes driveEnable{};
  hal_data_u *spindleSpeed = nullptr, *coolant = nullptr, *heartbeat = nullptr;
};

/// A pin of Arris by its name in HAL. The signal that it is linked to has the same name with dashes for the dots.
struct HalPin {
  std::string name;
  hal_type_t type;
  hal_pin_dir_t direction;
  hal_data_u** value; ///< where its value's place is kept
};

/// Every pin.
[[nodiscard]] std::vector<HalPin> allPins(HalPins& pins);

/// The component `arris` in the HAL session of this machine, with its pins linked to the session's signals and both
/// streams attached. A component that a dead Arris has left is taken over. One at a time.
class HalComponent {
public:
  /// Says in English why not.
  [[nodiscard]] static tl::expected<std::unique_ptr<HalComponent>, std::string> open();

  HalComponent() = default;
  HalComponent(const HalComponent&) = delete;
  HalComponent& operator=(const HalComponent&) = delete;
  HalComponent(HalComponent&&) = delete;
  HalComponent& operator=(HalComponent&&) = delete;
  ~HalComponent();

  HalPins pins;
  hal_stream_t streamer{}, sampler{};
  const hal_data_u* underruns = nullptr; ///< of the streamer, since the session began

private:
  using Reason = std::string; ///< empty: all is well

  [[nodiscard]] Reason lock();
  [[nodiscard]] Reason attachStreams();
  [[nodiscard]] Reason makePins();
  [[nodiscard]] Reason findPins();

  int m_lock = -1; ///< a socket
  int m_component = -1;
  bool m_streamerAttached = false, m_samplerAttached = false;
};

} // namespace arris::control
