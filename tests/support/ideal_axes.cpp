#include "tests/support/ideal_axes.h"

#include <utility>

namespace arris::test {

IdealAxes::IdealAxes(recipe::Machine machine, Eigen::Vector3d standsAt, int lead)
    : m_machine(std::move(machine)), m_standsAt(std::move(standsAt)), m_lead(lead) {
  inputs.vacuumHolds = true;
}

control::Feedback IdealAxes::read() {
  m_told = answers ? m_feedback : m_told;
  control::Feedback feedback = m_told;
  feedback.inputs = inputs;
  feedback.underruns = underruns;
  if (drivesWork) {
    feedback.inputs.driveReady = m_outputs.driveEnable;
  }
  feedback.inputs.spindleAtSpeed = spindleWorks && m_outputs.spindleSpeed > 0;
  feedback.inputs.coolantFlows = coolantWorks && m_outputs.coolant;
  const Eigen::Vector3d place = m_standsAt + m_feedback.position;
  for (std::size_t i = 0; i < control::kAxes; ++i) {
    const auto axis = static_cast<int>(i);
    const double at = m_machine.homeAt[axis];
    feedback.inputs.reference[i] =
        switchesWork && (at > m_machine.travel[axis] / 2 ? place[axis] >= at : place[axis] <= at);
  }
  return feedback;
}

bool IdealAxes::write(const Eigen::Vector3d& setPoint, const control::Outputs& outputs) {
  m_outputs = outputs;
  m_queue.push_back(setPoint);
  if (static_cast<int>(m_queue.size()) > m_lead) {
    for (std::size_t i = 0; i < control::kAxes; ++i) {
      if (m_outputs.driveEnable[i] && drivesWork && !inputs.driveFault[i]) { // without drives they stay where they are
        m_feedback.position[static_cast<int>(i)] = m_queue.front()[static_cast<int>(i)];
      }
    }
    m_queue.pop_front();
    ++m_feedback.tick;
  }
  return true;
}

int IdealAxes::queued() {
  return static_cast<int>(m_queue.size());
}

} // namespace arris::test
