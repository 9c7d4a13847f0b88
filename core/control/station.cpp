#include "core/control/station.h"

#include "core/control/channels.h"
#include "core/control/control_thread.h"

#include <utility>

namespace arris::control {

struct Station::Parts {
  Parts(const recipe::Machine& machine, Pace pace, Supervisor::Listener listener)
      : axes(machine, pace, machine.travel / 2), controller(machine, channels),
        operatorSide(machine, channels, std::move(listener),
                     pace == Pace::Real ? std::launch::async : std::launch::deferred) {
    if (pace == Pace::Real) {
      thread.emplace(controller, axes, machine.period);
    }
  }

  Channels channels;
  SimulatedAxes axes;
  Controller controller;
  Supervisor operatorSide;
  std::optional<ControlThread> thread; ///< last: it uses the others
};

Station::Station(const recipe::Machine& machine, Pace pace, Supervisor::Listener listener)
    : m_parts(std::make_unique<Parts>(machine, pace, std::move(listener))) {}

Station::~Station() = default;

void Station::pass(int periods) {
  for (int i = 0; i < periods && !m_parts->thread; ++i) {
    const Cycle& cycle = m_parts->controller.advance(m_parts->axes.read());
    m_parts->axes.write(cycle.setPoint, cycle.outputs);
  }
  m_parts->operatorSide.serve();
}

Supervisor& Station::operatorSide() {
  return m_parts->operatorSide;
}

const Supervisor& Station::operatorSide() const {
  return m_parts->operatorSide;
}

SimulatedAxes& Station::axes() {
  return m_parts->axes;
}

} // namespace arris::control
