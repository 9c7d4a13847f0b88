#pragma once

#include "core/recipe/recipe.h"

#include <numbers>

namespace arris::control {

/// Natural frequency ω of the position loop of a simulated axis, rad/s (40 Hz); it is critically damped. At a constant
/// acceleration a the axis lies a/ω² behind its set-point.
inline constexpr double kServoFrequency = 2 * std::numbers::pi * 40;

inline constexpr double kSpeedReserve = 1.1;      ///< a simulated axis saturates at so many times the machine's speed
inline constexpr double kAccelReserve = 1.2;      ///< and at so many times its acceleration
inline constexpr double kLimitSwitchOutside = 10; ///< mm from the end of the travel to the limit switch
inline constexpr double kHardEndOutside = 20;     ///< mm from the end of the travel to where the axis stops dead

enum class AxisMode {
  Follows, ///< its set-points
  Brakes,  ///< by friction, at the machine's acceleration, and then stays
  Stuck    ///< does not move
};

/// The simulated mechanics and servo of one axis, in table coordinates (mm, mm/s). Speed feed-forward from the last
/// three set-points and a position loop; speed and acceleration saturate. From afar it comes at full speed and brakes
/// in time, so it does not overshoot.
class SimulatedAxis {
public:
  /// At rest at `standsAt`.
  SimulatedAxis(const recipe::Machine& machine, int axis, double standsAt);

  /// One servo period, at whose end the axis is to be at the set-point.
  void step(double setPoint, AxisMode mode);

  [[nodiscard]] double place() const {
    return m_place;
  }

  [[nodiscard]] double speed() const {
    return m_speed;
  }

  [[nodiscard]] bool onLimitLow() const {
    return m_place <= -kLimitSwitchOutside;
  }

  [[nodiscard]] bool onLimitHigh() const {
    return m_place >= m_travel + kLimitSwitchOutside;
  }

  /// On from where the switch comes on to the nearer end of the travel.
  [[nodiscard]] bool onReference() const {
    return m_homeAt <= m_travel / 2 ? m_place <= m_homeAt : m_place >= m_homeAt;
  }

private:
  [[nodiscard]] double servoAcceleration(double place, double speed) const;
  void accelerate(double acceleration);
  void brake();

  double m_travel, m_homeAt;
  double m_maxSpeed; ///< saturation, mm/s
  double m_maxAccel; ///< saturation, mm/s²
  double m_braking;  ///< mm/s², of friction and of the approach from afar
  double m_rate;     ///< periods per second
  int m_subSteps;    ///< of a period
  double m_subStep;  ///< s
  double m_place, m_speed = 0;
  double m_last, m_beforeLast; ///< set-points
};

} // namespace arris::control
