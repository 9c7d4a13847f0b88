#pragma once

#include <algorithm>
#include <cmath>

namespace arris::control {

/// Set-points of one axis that is moved by itself (jog, homing): the speed changes by no more than the acceleration
/// allows from one period to the next, so that the second difference of the places keeps it too.
class AxisRamp {
public:
  AxisRamp() = default;

  AxisRamp(double acceleration, double period) : m_acceleration(acceleration), m_period(period) {}

  void begin(double position) {
    m_position = position;
    m_velocity = 0;
  }

  /// One period towards a velocity, mm/s, without passing the limits (mm); outside them only back.
  void towards(double velocity, double least, double most) {
    const double change = m_acceleration * m_period;
    double v = std::clamp(velocity, m_velocity - change, m_velocity + change);
    v = std::min(v, std::max(stoppable(most - m_position), m_velocity - change));
    v = std::max(v, std::min(-stoppable(m_position - least), m_velocity + change));
    move(v);
  }

  /// One period towards a place at no more than `speed`, mm/s; exactly there in the end.
  void to(double position, double speed) {
    const double way = position - m_position;
    constexpr double kThere = 1e-9;
    if (std::abs(way) <= kThere && std::abs(m_velocity) <= m_acceleration * m_period) {
      m_position = position;
      m_velocity = 0;
      return;
    }
    const double change = m_acceleration * m_period;
    const double v = std::copysign(std::min(speed, stoppable(std::abs(way))), way);
    move(std::clamp(v, m_velocity - change, m_velocity + change));
  }

  [[nodiscard]] double position() const {
    return m_position;
  }

  [[nodiscard]] double velocity() const {
    return m_velocity;
  }

private:
  /// The greatest speed for the coming period from which the axis still comes to rest within `way`: v·T + v²/(2a) =
  /// way.
  [[nodiscard]] double stoppable(double way) const {
    if (way <= 0) {
      return 0;
    }
    const double aT = m_acceleration * m_period;
    return 2 * m_acceleration * way / (aT + std::sqrt(aT * aT + 2 * m_acceleration * way));
  }

  void move(double velocity) {
    m_position += velocity * m_period;
    m_velocity = velocity;
  }

  double m_acceleration = 0; ///< mm/s²
  double m_period = 0;       ///< s
  double m_position = 0;     ///< mm
  double m_velocity = 0;     ///< mm/s
};

} // namespace arris::control
