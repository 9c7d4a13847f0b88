#include "core/control/controller.h"

#include <algorithm>
#include <cmath>

// What may go wrong, and what then happens.

namespace arris::control {

namespace {

/// Feedback later than the lead by this is late, and without any news for so long it is lost, s.
constexpr double kFeedbackLate = 0.05;
constexpr double kFeedbackLost = 0.2;

/// Drives are ready this long after they were enabled, s.
constexpr double kDriveWait = 1;

/// The operator's side says at least so often that it lives, s.
constexpr double kOperatorWait = 0.5;

/// A set-point whose second difference exceeds the limit by more than this is a fault, as a share and in mm/s²: far
/// more than rounding, far less than a jump.
constexpr double kGuardShare = 1e-3;
constexpr double kGuardRounding = 0.05;

} // namespace

bool Controller::drivesReady() const {
  return m_drivesOn && m_wereReady;
}

void Controller::raise(Fault fault, int axis, double value) {
  if (m_faults.has(fault)) {
    return;
  }
  m_faults.add(fault);
  static_cast<void>(m_channels.faults.push({m_tick, fault, axis, value}));
  const FaultInfo& row = info(fault);
  m_homed = m_homed && !row.losesPlace;
  if (row.category != StopCategory::Two || fault == Fault::FeedbackLate) {
    keepReachedPlace();
  }
  if (fault == Fault::EmergencyStop) {
    handle(Event::EmergencyStop);
  } else if (row.category == StopCategory::Zero) {
    m_cutDrives = true;
    handle(Event::DrivesOff);
  } else {
    m_cutDrives = m_cutDrives || row.category == StopCategory::One;
    m_raise = (m_raise || row.raises) && !m_cutDrives;
    handle(Event::Fault);
  }
}

// Axes whose drives go off, or may not be able to hold them, do not follow what is still under way to them: what they
// have not reached, or not told that they have, is to be ground when the job is resumed.
void Controller::keepReachedPlace() {
  const auto size = static_cast<std::int64_t>(m_places.size());
  const std::int64_t reached = std::max(m_feedback.tick, m_loadedTick);
  if (m_program.number != 0 && !m_reachedPlace && reached < m_tick && m_tick - reached < size) {
    m_reachedPlace = m_places[static_cast<std::size_t>(reached) & (m_places.size() - 1)];
  }
}

void Controller::watch() {
  if (m_feedback.tick != m_report.measuredTick) {
    m_freshTick = m_tick;
  }
  watchInputs();
  if (m_drivesOn) {
    watchFeedback();
    watchServices();
  }
  const bool isSilent = static_cast<double>(m_tick - m_operatorTick) * m_period > kOperatorWait;
  if (isSilent && isMoving(m_state)) {
    raise(Fault::OperatorLost);
  }
}

void Controller::watchInputs() {
  const Inputs& inputs = m_feedback.inputs;
  if (inputs.emergencyStop && m_state != State::EmergencyStop) {
    raise(Fault::EmergencyStop);
  }
  if (!m_drivesOn) {
    return;
  }
  bool allReady = true;
  for (std::size_t i = 0; i < kAxes; ++i) {
    const int axis = static_cast<int>(i);
    if (inputs.encoderLost[i]) {
      raise(Fault::EncoderLost, axis);
    }
    if (inputs.driveFault[i]) {
      raise(Fault::DriveFault, axis);
    }
    if (hitsLimit(i)) {
      raise(Fault::LimitSwitch, axis);
    }
    allReady = allReady && inputs.driveReady[i];
    const bool late = static_cast<double>(m_tick - m_enabledTick) * m_period > kDriveWait;
    if (!inputs.driveReady[i] && (m_wereReady || late)) {
      raise(Fault::DriveNotReady, axis);
    }
  }
  if (m_drivesOn && allReady && !m_wereReady) {
    m_wereReady = true;
    m_readyTick = m_tick;
    m_guarded = 0;
  }
}

// One that is on from power-up or since an earlier fault is hit where the axis is moved farther; jog does not do that.
bool Controller::hitsLimit(std::size_t axis) const {
  const Inputs& now = m_feedback.inputs;
  const double speed = m_state == State::Jogging ? 0 : m_report.velocity[static_cast<int>(axis)];
  const bool low = now.limitLow[axis] && (!m_lastInputs.limitLow[axis] || speed < 0);
  const bool high = now.limitHigh[axis] && (!m_lastInputs.limitHigh[axis] || speed > 0);
  return low || high;
}

void Controller::watchFeedback() {
  const std::int64_t executed = m_feedback.tick;
  const double silence = static_cast<double>(m_tick - m_freshTick) * m_period;
  if (silence > kFeedbackLost + m_lead * m_period) {
    raise(Fault::FeedbackLost);
    return;
  }
  if (m_feedback.underruns > m_underruns && isMoving(m_state)) {
    raise(Fault::SetPointLate, -1, static_cast<double>(m_feedback.underruns - m_underruns));
  }
  m_underruns = m_feedback.underruns;
  const double age = static_cast<double>(m_tick - executed - m_lead) * m_period;
  if (executed >= 0 && age > kFeedbackLate) {
    raise(Fault::FeedbackLate, -1, 1000 * age);
  }
  if (!m_wereReady || executed <= m_readyTick || m_tick - executed >= static_cast<std::int64_t>(m_history.size())) {
    return;
  }
  const Eigen::Vector3d setPoint = m_history[static_cast<std::size_t>(executed) & (m_history.size() - 1)];
  m_report.followingError = m_feedback.position - setPoint;
  for (int axis = 0; axis < kAxes; ++axis) {
    if (std::abs(m_report.followingError[axis]) > m_machine.followingError) {
      raise(Fault::FollowingError, axis, std::abs(m_report.followingError[axis]));
    }
  }
}

void Controller::watchServices() {
  const bool grinds = m_program.number != 0 && m_program.kind != program::Kind::Positioning;
  const bool isUnderWay =
      m_state == State::Running || m_state == State::Holding || m_state == State::Held || m_state == State::Stepping;
  if (!grinds || !isUnderWay) {
    return;
  }
  if (m_spindle > 0 && !m_feedback.inputs.spindleAtSpeed) {
    raise(Fault::SpindleLost);
  }
  if (m_coolant && !m_feedback.inputs.coolantFlows) {
    raise(Fault::CoolantLost);
  }
  if (!m_feedback.inputs.vacuumHolds) {
    raise(Fault::VacuumLost);
  }
}

// The last look at a set-point before the axes get it.
bool Controller::isConsistent(const Eigen::Vector3d& setPoint) {
  if (!drivesReady()) {
    m_guarded = 0;
  }
  const Eigen::Vector3d velocity = (setPoint - m_cycle.setPoint) / m_period;
  const Eigen::Vector3d acceleration = (velocity - m_velocity) / m_period;
  if (m_guarded >= 2) {
    for (int axis = 0; axis < kAxes; ++axis) {
      const double excess = std::abs(acceleration[axis]) - m_most[axis];
      if (!(excess <= kGuardShare * m_most[axis] + kGuardRounding)) { // NaN too
        raise(Fault::SetPointInconsistent, axis, excess);
        followAxes();
        return false;
      }
    }
  }
  m_velocity = velocity;
  ++m_guarded;
  return setPoint.allFinite();
}

} // namespace arris::control
