#include "core/control/simulated_axis.h"

#include <algorithm>
#include <cmath>

namespace arris::control {
namespace {

/// At this step the integrated loop has two positive real poles, as the continuous one; from some 2.3 ms it would not.
constexpr double kLongestSubStep = 1e-3; // s

/// The speed at which a distance is covered: proportional to it while near, farther off such that braking is even.
double approachSpeed(double distance, double braking) {
  constexpr double gain = kServoFrequency / 2;
  const double far = braking / (gain * gain);
  const double size = std::abs(distance);
  return size <= far ? gain * distance : std::copysign(std::sqrt(2 * braking * (size - far / 2)), distance);
}

} // namespace

SimulatedAxis::SimulatedAxis(const recipe::Machine& machine, int axis, double standsAt)
    : m_travel(machine.travel[axis]), m_homeAt(machine.homeAt[axis]),
      m_maxSpeed(kSpeedReserve * machine.maxSpeed[axis] / 60), m_maxAccel(kAccelReserve * machine.maxAccel[axis]),
      m_braking(machine.maxAccel[axis]), m_rate(1 / machine.period),
      m_subSteps(static_cast<int>(std::ceil(machine.period / kLongestSubStep - 1e-9))),
      m_subStep(machine.period / m_subSteps), m_place(standsAt), m_last(standsAt), m_beforeLast(standsAt) {}

void SimulatedAxis::step(double setPoint, AxisMode mode) {
  // In between, the set-points go along the parabola through the last three.
  const double speed = (setPoint - m_beforeLast) * m_rate / 2;
  const double acceleration = (setPoint - 2 * m_last + m_beforeLast) * m_rate * m_rate;
  for (int i = 0; i < m_subSteps; ++i) {
    const double time = i * m_subStep;
    if (mode == AxisMode::Follows) {
      accelerate(servoAcceleration(m_last + (speed + acceleration * time / 2) * time, speed + acceleration * time));
    } else if (mode == AxisMode::Brakes) {
      brake();
    } else {
      m_speed = 0;
    }
  }
  m_beforeLast = m_last;
  m_last = setPoint;
}

/// Near the set-point: ω²·(following error) + 2ω·(difference in speed).
double SimulatedAxis::servoAcceleration(double place, double speed) const {
  const double wanted = std::clamp(speed + approachSpeed(place - m_place, m_braking), -m_maxSpeed, m_maxSpeed);
  return std::clamp(2 * kServoFrequency * (wanted - m_speed), -m_maxAccel, m_maxAccel);
}

void SimulatedAxis::accelerate(double acceleration) {
  const double before = m_speed;
  m_speed += acceleration * m_subStep;
  m_place += (before + m_speed) / 2 * m_subStep;
  const double inside = std::clamp(m_place, -kHardEndOutside, m_travel + kHardEndOutside);
  if (inside != m_place) {
    m_place = inside;
    m_speed = 0;
  }
}

void SimulatedAxis::brake() {
  accelerate(std::clamp(-m_speed / m_subStep, -m_braking, m_braking));
}

} // namespace arris::control
