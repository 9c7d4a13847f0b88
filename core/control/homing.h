#pragma once

#include "core/control/axis_driver.h"
#include "core/control/axis_ramp.h"
#include "core/recipe/recipe.h"

#include <array>

namespace arris::control {

/// Finds the places of the axes: Z first, upwards out of the way, then X and Y. Each runs onto its reference switch,
/// slowly off it again, and takes its place where the switch goes off.
class Homing {
public:
  explicit Homing(recipe::Machine machine);

  /// From rest.
  void begin();

  enum class Outcome { Under, Done, NotFound };

  /// One period: moves the ramps (encoder coordinates). `feedback` is from the instant at which the axes stand where it
  /// says.
  Outcome advance(const Feedback& feedback, std::array<AxisRamp, kAxes>& ramps);

  /// Machine coordinate minus encoder coordinate of the axes found so far, mm.
  [[nodiscard]] const Eigen::Vector3d& offset() const {
    return m_offset;
  }

  /// The axis that is moving, or was not found.
  [[nodiscard]] int axis() const {
    return kOrder[m_index];
  }

private:
  enum class Phase { Search, Stop, Leave, Settle };

  static constexpr std::array<int, kAxes> kOrder{2, 0, 1};

  void enter(Phase phase) {
    m_phase = phase;
    m_way = 0;
  }

  recipe::Machine m_machine;
  Eigen::Vector3d m_offset{0, 0, 0};
  std::size_t m_index = 0;
  Phase m_phase = Phase::Search;
  double m_way = 0; ///< mm, moved in this phase
};

} // namespace arris::control
