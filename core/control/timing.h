#pragma once

#include <cstdint>

namespace arris::control {

/// What the controller's thread has seen of the system's timing.
struct Timing {
  std::int64_t lateWakeUps = 0; ///< by more than a period
  int worstLead = 0;            ///< the fewest set-points that the axes had left at a wake-up
  double worstLateness = 0;     ///< s
  bool operator==(const Timing&) const = default;
};

} // namespace arris::control
