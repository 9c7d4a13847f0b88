#include "core/control/simulated_axes.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <utility>

namespace arris::control {
namespace {

constexpr double kDriveReadyAfter = 0.05;                       // s
constexpr double kCoolantOnAfter = 0.5, kCoolantOffAfter = 0.2; // s
constexpr double kFeedbackLateBy = 0.1, kFeedbackLateFor = 0.5; // s
constexpr double kQueueReaches = 1;                             // s

/// Of a period, by which the clock may be rounded.
constexpr double kClockRounding = 1e-6;

constexpr auto kRelaxed = std::memory_order_relaxed;

/// One at least.
int wholePeriods(double time, double period) {
  return std::max(1, static_cast<int>(std::lround(time / period)));
}

constexpr std::uint32_t faultBit(SimulatedFault fault, int axis = 0) {
  return 1U << (static_cast<unsigned>(fault) * kAxes + static_cast<unsigned>(axis));
}

constexpr std::uint32_t buttonBit(Button button) {
  return 1U << static_cast<unsigned>(button);
}

bool isOfAxis(SimulatedFault fault) {
  return fault <= SimulatedFault::StuckAxis;
}

std::size_t nextInRing(std::size_t index, std::size_t size) {
  return index + 1 == size ? 0 : index + 1;
}

double encoderReading(double place) {
  return std::round(place * kEncoderSteps) / kEncoderSteps;
}

} // namespace

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

SimulatedAxes::SimulatedAxes(const recipe::Machine& machine, Pace pace, const Eigen::Vector3d& standsAt,
                             const Eigen::Vector3d& encodersStartAt, std::function<double()> seconds)
    : m_period(machine.period), m_lead(wholePeriods(machine.setPointLead, machine.period)), m_pace(pace),
      m_seconds(std::move(seconds)), m_axes{SimulatedAxis(machine, 0, standsAt.x()),
                                            SimulatedAxis(machine, 1, standsAt.y()),
                                            SimulatedAxis(machine, 2, standsAt.z())},
      m_driveReady{DelayedSignal(kDriveReadyAfter, 0), DelayedSignal(kDriveReadyAfter, 0),
                   DelayedSignal(kDriveReadyAfter, 0)},
      m_spindle(machine.period), m_coolant(kCoolantOnAfter, kCoolantOffAfter),
      m_encoderZero(standsAt - encodersStartAt), m_measured(encodersStartAt.unaryExpr(&encoderReading)),

      m_queue(static_cast<std::size_t>(m_lead + wholePeriods(kQueueReaches, machine.period))), m_lastRead(report()) {
  m_past.assign(static_cast<std::size_t>(wholePeriods(kFeedbackLateBy, machine.period)) + 1, m_lastRead);
}

Feedback SimulatedAxes::read() {
  takeWhatIsDue();
  if (!has(SimulatedFault::LostFeedback)) {
    m_lastRead = has(SimulatedFault::LateFeedback) ? m_past[m_oldest] : report();
  }
  return m_lastRead;
}

bool SimulatedAxes::write(const Eigen::Vector3d& setPoint, const Outputs& outputs) {
  assert(setPoint.allFinite());
  takeWhatIsDue();
  if (m_queued == static_cast<int>(m_queue.size())) {
    return false;
  }
  if (!m_started && m_pace == Pace::Real) {
    m_startTime = m_seconds();
  }
  m_started = true;
  m_outputs = outputs;
  m_queue[m_free] = setPoint;
  m_free = nextInRing(m_free, m_queue.size());
  ++m_queued;
  if (m_pace == Pace::Simulated && m_queued > m_lead) {
    takeNext();
  }
  return true;
}

int SimulatedAxes::queued() {
  takeWhatIsDue();
  return m_queued;
}

void SimulatedAxes::takeWhatIsDue() {
  if (m_pace == Pace::Simulated || !m_started) {
    return;
  }
  const double periods = std::floor((m_seconds() - m_startTime) / m_period + kClockRounding);
  const std::int64_t due = static_cast<std::int64_t>(periods) - m_lead + 1;
  while (m_taken + m_underruns < due) {
    takeNext();
  }
}

void SimulatedAxes::takeNext() {
  if (m_queued > 0) {
    m_setPoint = m_queue[m_first];
    m_first = nextInRing(m_first, m_queue.size());
    --m_queued;
    ++m_taken;
  } else {
    ++m_underruns;
  }
  passPeriod();
}

void SimulatedAxes::passPeriod() {
  const bool runs = !has(SimulatedFault::EmergencyStop);
  for (int axis = 0; axis < kAxes; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    m_driveReady[i].step(m_outputs.driveEnable[i] && runs && !has(SimulatedFault::DriveFault, axis), m_period);
    const AxisMode mode = has(SimulatedFault::StuckAxis, axis) ? AxisMode::Stuck
                          : m_driveReady[i].is()               ? AxisMode::Follows
                                                               : AxisMode::Brakes;
    m_axes[i].step(m_setPoint[axis] + m_encoderZero[axis], mode);
    if (!has(SimulatedFault::EncoderLoss, axis)) {
      m_measured[axis] = encoderReading(m_axes[i].place() - m_encoderZero[axis]);
    }
  }
  m_spindle.step(runs && !has(SimulatedFault::SpindleLoss) ? m_outputs.spindleSpeed : 0);
  m_coolant.step(runs && !has(SimulatedFault::CoolantLoss) && m_outputs.coolant, m_period);
  keepReport();
}

void SimulatedAxes::keepReport() {
  m_past[m_oldest] = report();
  m_oldest = nextInRing(m_oldest, m_past.size());
  m_latePeriods = has(SimulatedFault::LateFeedback) ? m_latePeriods + 1 : 0;
  if (m_latePeriods > wholePeriods(kFeedbackLateFor, m_period)) {
    m_faults.fetch_and(~faultBit(SimulatedFault::LateFeedback), kRelaxed);
  }
}

Feedback SimulatedAxes::report() const {
  Feedback feedback{.tick = m_taken - 1, .position = m_measured, .inputs = {}, .underruns = m_underruns};
  Inputs& inputs = feedback.inputs;
  for (int axis = 0; axis < kAxes; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    inputs.limitLow[i] = m_axes[i].onLimitLow();
    inputs.limitHigh[i] = m_axes[i].onLimitHigh();
    inputs.reference[i] = m_axes[i].onReference();
    inputs.driveReady[i] = m_driveReady[i].is();
    inputs.driveFault[i] = has(SimulatedFault::DriveFault, axis);
    inputs.encoderLost[i] = has(SimulatedFault::EncoderLoss, axis);
  }
  inputs.emergencyStop = has(SimulatedFault::EmergencyStop);
  inputs.spindleAtSpeed = m_spindle.atSpeed();
  inputs.coolantFlows = m_coolant.is();
  inputs.vacuumHolds = !has(SimulatedFault::VacuumLoss);
  inputs.cycleStart = isDown(Button::CycleStart);
  inputs.hold = isDown(Button::Hold);
  inputs.stop = isDown(Button::Stop);
  inputs.jogEnable = isDown(Button::JogEnable);
  inputs.overridePercent = m_overridePercent.load(kRelaxed);
  return feedback;
}

void SimulatedAxes::inject(SimulatedFault fault, int axis) {
  assert(axis >= 0 && axis < kAxes);
  m_faults.fetch_or(faultBit(fault, isOfAxis(fault) ? axis : 0), kRelaxed);
}

void SimulatedAxes::clearFaults() {
  m_faults.store(0, kRelaxed);
}

void SimulatedAxes::press(Button button, bool down) {
  if (down) {
    m_buttons.fetch_or(buttonBit(button), kRelaxed);
  } else {
    m_buttons.fetch_and(~buttonBit(button), kRelaxed);
  }
}

void SimulatedAxes::turnOverride(int percent) {
  m_overridePercent.store(percent, kRelaxed);
}

bool SimulatedAxes::has(SimulatedFault fault, int axis) const {
  return (m_faults.load(kRelaxed) & faultBit(fault, axis)) != 0;
}

bool SimulatedAxes::isDown(Button button) const {
  return (m_buttons.load(kRelaxed) & buttonBit(button)) != 0;
}

Eigen::Vector3d SimulatedAxes::place() const {
  return {m_axes[0].place(), m_axes[1].place(), m_axes[2].place()};
}

} // namespace arris::control
