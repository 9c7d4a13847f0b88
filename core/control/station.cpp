#include "core/control/station.h"

#include "core/control/channels.h"
#include "core/control/control_thread.h"

#include <utility>

namespace arris::control {

struct Station::Parts {
  Parts(const recipe::Machine& machine, std::unique_ptr<AxisDriver> driver, Pace pace, Supervisor::Listener listener,
        std::function<void(const Report&)> hears)
      : axes(std::move(driver)), controller(machine, channels),
        operatorSide(machine, channels, std::move(listener),
                     pace == Pace::Real ? std::launch::async : std::launch::deferred),
        eachPeriod(std::move(hears)) {
    if (pace == Pace::Real) {
      thread.emplace(controller, *axes, machine.period);
    }
  }

  Channels channels;
  std::unique_ptr<AxisDriver> axes;
  Controller controller;
  Supervisor operatorSide;
  std::function<void(const Report&)> eachPeriod;
  std::optional<ControlThread> thread; ///< last: it uses the others
};

Station::Station(const recipe::Machine& machine, std::unique_ptr<AxisDriver> axes, Pace pace,
                 Supervisor::Listener listener, std::function<void(const Report&)> eachPeriod)
    : m_parts(std::make_unique<Parts>(machine, std::move(axes), pace, std::move(listener), std::move(eachPeriod))) {}

Station::~Station() = default;

void Station::pass(int periods) {
  for (int i = 0; i < periods && !m_parts->thread; ++i) {
    const Cycle& cycle = m_parts->controller.advance(m_parts->axes->read());
    m_parts->axes->write(cycle.setPoint, cycle.outputs);
    if (m_parts->eachPeriod) {
      m_parts->eachPeriod(m_parts->controller.report());
    }
  }
  m_parts->operatorSide.serve();
}

Supervisor& Station::operatorSide() {
  return m_parts->operatorSide;
}

const Supervisor& Station::operatorSide() const {
  return m_parts->operatorSide;
}

const ControlThread* Station::thread() const {
  return m_parts->thread ? &*m_parts->thread : nullptr;
}

std::optional<Timing> Station::timing() const {
  return m_parts->thread ? std::optional(m_parts->thread->timing()) : std::nullopt;
}

} // namespace arris::control
