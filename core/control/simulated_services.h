#pragma once

#include <cmath>

namespace arris::control {

/// A signal that follows its cause late. At first off.
class DelayedSignal {
public:
  /// Late by `on` s when it comes and by `off` s when it goes.
  constexpr DelayedSignal(double on, double off) : m_on(on), m_off(off) {}

  /// One period of so many seconds.
  void step(bool cause, double period) {
    m_since = cause == m_is ? 0 : m_since + period;
    if (cause != m_is && m_since > (cause ? m_on : m_off) - kRounding) {
      m_is = cause;
      m_since = 0;
    }
  }

  [[nodiscard]] bool is() const {
    return m_is;
  }

private:
  static constexpr double kRounding = 1e-9; ///< s, far less than a period, of a sum of periods

  double m_on, m_off;
  double m_since = 0;
  bool m_is = false;
};

/// The simulated grinding spindle: of the first order, at speed 1.5 s after it was switched on, coasting 4 s.
class SimulatedSpindle {
public:
  explicit SimulatedSpindle(double period)
      : m_runUp(1 - std::pow(kTolerance, period / kRunUp)), m_coast(1 - std::pow(kTolerance, period / kCoast)) {}

  /// One period. `command` in r/min, 0 is off.
  void step(double command) {
    m_command = command;
    m_speed += (command - m_speed) * (command > 0 ? m_runUp : m_coast);
  }

  /// r/min
  [[nodiscard]] double speed() const {
    return m_speed;
  }

  /// Switched on and within 2 % of what is commanded.
  [[nodiscard]] bool atSpeed() const {
    return m_command > 0 && std::abs(m_speed - m_command) <= kTolerance * m_command;
  }

private:
  static constexpr double kTolerance = 0.02;
  static constexpr double kRunUp = 1.5; ///< s from rest until within the tolerance
  static constexpr double kCoast = 4;   ///< s until no more than the tolerance is left of the speed

  double m_runUp, m_coast; ///< shares of the difference covered in a period
  double m_command = 0, m_speed = 0;
};

} // namespace arris::control
