#include "core/control/homing.h"

#include <cmath>
#include <limits>
#include <utility>

namespace arris::control {

namespace {

/// A switch that has not come after this share of the travel does not come.
constexpr double kMostTravel = 1.2;

/// On its way off the switch an axis may have to make up for what it needed to stop on it, and this much more, mm.
constexpr double kMostLeave = 20;

constexpr double kEverywhere = std::numeric_limits<double>::infinity();

} // namespace

Homing::Homing(recipe::Machine machine) : m_machine(std::move(machine)) {}

void Homing::begin() {
  m_index = 0;
  enter(Phase::Search);
}

Homing::Outcome Homing::advance(const Feedback& feedback, std::array<AxisRamp, kAxes>& ramps) {
  const int axis = kOrder[m_index];
  const auto i = static_cast<std::size_t>(axis);
  AxisRamp& ramp = ramps[i];
  const double towards = m_machine.homeAt[axis] > m_machine.travel[axis] / 2 ? 1 : -1;
  const bool isOn = feedback.inputs.reference[i];
  const double before = ramp.position();
  switch (m_phase) {
  case Phase::Search:
    if (isOn) {
      enter(Phase::Stop);
    } else if (m_way > kMostTravel * m_machine.travel[axis]) {
      return Outcome::NotFound;
    }
    break;
  case Phase::Stop:
    if (ramp.velocity() == 0) {
      enter(Phase::Leave);
    }
    break;
  case Phase::Leave:
    if (!isOn) {
      m_offset[axis] = m_machine.homeAt[axis] - feedback.position[axis];
      enter(Phase::Settle);
    } else if (m_way > kMostLeave + kMostTravel * m_machine.travel[axis]) {
      return Outcome::NotFound;
    }
    break;
  case Phase::Settle:
    if (ramp.velocity() == 0) {
      if (m_index + 1 == kOrder.size()) {
        return Outcome::Done;
      }
      ++m_index;
      enter(Phase::Search);
      return Outcome::Under;
    }
    break;
  }
  const double speed = m_phase == Phase::Search  ? towards * m_machine.homeSearch / 60
                       : m_phase == Phase::Leave ? -towards * m_machine.homeLatch / 60
                                                 : 0;
  ramp.towards(speed, -kEverywhere, kEverywhere);
  m_way += std::abs(ramp.position() - before);
  return Outcome::Under;
}

} // namespace arris::control
