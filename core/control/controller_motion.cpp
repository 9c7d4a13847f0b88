#include "core/base/tolerances.h"
#include "core/control/controller.h"

#include <algorithm>
#include <cmath>

// What the axes do in each state.

namespace arris::control {

using motion::Move;
using motion::Segment;

namespace {

/// A program begins where the wheel stands, to within this, mm.
constexpr double kSamePlace = 1e-6;

/// With less room than this beside the path the wheel is raised instead, mm.
constexpr double kLeastRoom = 0.5;

/// Backing off, mm/s.
constexpr double kBackOffSpeed = 20;

/// A jog that is not confirmed for so long ends, s.
constexpr double kJogConfirm = 0.2;

} // namespace

void Controller::move() {
  m_report.isInMotion = false;
  if (!drivesReady()) {
    followAxes();
    if (m_state == State::Stopping) { // without drives there is nothing to brake
      handle(Event::AtRest);
    }
    return;
  }
  switch (m_state) {
  case State::Starting:
    moveStarting();
    break;
  case State::Running:
    movePath(m_override);
    break;
  case State::Holding:
    movePath(0);
    break;
  case State::Held:
    moveHeld();
    break;
  case State::Stepping:
    beginPath();
    movePath(m_holdStep ? 0 : 1);
    break;
  case State::Positioning:
    beginPath();
    movePath(std::min(1.0, m_override));
    break;
  case State::Stopping:
    moveStopping();
    break;
  case State::Homing:
    moveHoming();
    break;
  case State::Jogging:
    moveJogging();
    break;
  case State::Off:
  case State::NotHomed:
  case State::Idle:
  case State::Faulted:
  case State::EmergencyStop:
    standStill();
    break;
  }
}

void Controller::set(const motion::SetPoint& point) {
  m_report.commanded = point.position;
  m_report.velocity = point.velocity;
  m_report.axisAcceleration = point.axisAcceleration;
}

void Controller::standStill() {
  m_report.velocity.setZero();
  m_report.axisAcceleration.setZero();
}

// Where the drives do not hold them the axes are where they are.
void Controller::followAxes() {
  m_report.commanded = tableOf(m_feedback.position);
  standStill();
}

// As soon as enough of the program is there.
void Controller::beginPath() {
  const motion::TrackView& view = m_window.view();
  if (m_path || view.end == 0 || !(m_window.isComplete() || m_window.reachesFar(0))) {
    return;
  }
  const Eigen::Vector3d start = motion::evaluate(view.segment(0), 0).point;
  const double gap = (start - m_report.commanded).cwiseAbs().maxCoeff();
  if (!(gap <= kSamePlace)) {
    raise(Fault::SetPointInconsistent, -1, gap);
    return;
  }
  m_path.emplace(view, m_program.limits);
  m_pathTick = 0;
  m_pathSegment = 0;
  m_report.segment = 0;
  m_report.lambda = 0;
  m_travelled = m_report.path;
}

void Controller::moveStarting() {
  standStill();
  beginPath();
  const Inputs& inputs = m_feedback.inputs;
  const bool spindle = m_spindle == 0 || inputs.spindleAtSpeed;
  const bool coolant = !m_coolant || inputs.coolantFlows;
  if (m_state != State::Starting) { // the program did not begin where the wheel is
    return;
  }
  if (m_path && spindle && coolant && inputs.vacuumHolds) {
    if (m_program.beginsRun && m_pathTick == 0) {
      m_runs = true;
      m_report.runTick = 0;
      m_report.path = 0;
      m_travelled = 0;
    }
    m_aside = Aside::OnPath;
    m_report.beside = 0;
    handle(Event::Ready);
    movePath(m_override);
  } else if (static_cast<double>(m_tick - m_startTick) * m_period > m_machine.spindleWait) {
    raise(!inputs.vacuumHolds ? Fault::VacuumLost
          : !spindle          ? Fault::SpindleNotReady
          : !coolant          ? Fault::CoolantNotReady
                              : Fault::BufferDry);
  }
}

void Controller::movePath(double factor) {
  if (!m_path) {
    standStill();
    if (m_state == State::Holding || m_state == State::Stopping) {
      handle(Event::AtRest);
    }
    return;
  }
  m_path->setOverride(factor);
  if (factor != 0 && wouldRunDry()) {
    raise(Fault::BufferDry);
    m_path->setOverride(0);
  }
  const motion::SetPoint at = m_path->advanceTo(static_cast<double>(m_pathTick) * m_period);
  ++m_pathTick;
  set(at);
  m_report.isInMotion = true;
  tellSegment(at);
  m_report.speed = at.speed;
  m_report.acceleration = at.acceleration;
  if (const program::JobPlace place = m_window.placeOf(at.segment, at.lambda); place.segment >= 0) {
    m_report.place = place;
  }
  const Eigen::Vector3d inMachine = m_report.commanded + m_origin;
  for (int axis = 0; axis < kAxes; ++axis) {
    if (inMachine[axis] < -kSamePlace || inMachine[axis] > m_machine.travel[axis] + kSamePlace) {
      raise(Fault::TravelLimit, axis);
    }
  }
  endOfProgram();
}

void Controller::tellSegment(const motion::SetPoint& at) {
  const motion::TrackView& view = m_window.view();
  for (; m_pathSegment < at.segment; ++m_pathSegment) {
    const Segment& left = view.segment(m_pathSegment);
    m_travelled += motion::arcLength(left, motion::parameterLength(left));
  }
  const Segment& on = view.segment(at.segment);
  if (at.segment != m_report.segment || m_pathTick == 1) {
    m_report.segmentEnd = motion::evaluate(on, motion::parameterLength(on)).point;
    m_report.feed = on.feed;
  }
  m_report.segment = at.segment;
  m_report.lambda = at.lambda;
  m_report.move = on.move;
  m_report.contour = on.contour;
  m_report.number = on.number;
  m_report.corner = on.corner;
  m_report.stopCorner = on.stopCorner;
  m_report.path = m_travelled + motion::arcLength(on, at.lambda);
}

// At rest in a hold, or at the end.
void Controller::endOfProgram() {
  if (m_path->atEnd() && m_window.isComplete()) {
    if (m_state == State::Stopping) {
      return;
    }
    handle(Event::ProgramEnd);
  } else if (m_path->standsStill() && (m_state == State::Holding || m_state == State::Stepping)) {
    handle(Event::AtRest);
  }
}

// Whether a hold after the coming period would not come to rest before the end of what is buffered. What is far from
// there needs no looking.
bool Controller::wouldRunDry() const {
  if (m_window.isComplete() || m_window.reachesFar(m_path->intervalIndex())) {
    return false;
  }
  motion::Interpolator probe = *m_path;
  static_cast<void>(probe.advanceTo(static_cast<double>(m_pathTick) * m_period));
  if (probe.atEnd()) {
    return true;
  }
  probe.setOverride(0);
  while (probe.nextPiece()) {
  }
  return probe.atEnd();
}

const Segment& Controller::segmentUnder() const {
  return m_window.view().segment(m_report.segment);
}

bool Controller::isOnGlass() const {
  if (!m_path || !(m_report.commanded.z() < m_program.clearanceHeight - kSamePlace)) {
    return false;
  }
  const Move move = segmentUnder().move;
  return move == Move::LeadIn || motion::isAlongContour(move) || move == Move::LeadOut;
}

// A wheel that stands turning on the glass rubs a dent.
void Controller::moveHeld() {
  if (m_short) {
    if (moveShort(1)) {
      m_short.reset();
      m_aside = m_report.beside > 0 ? Aside::BackedOff : Aside::Raised;
    }
    return;
  }
  standStill();
  if (m_aside != Aside::OnPath || m_spindle == 0 || m_machine.backOff == 0 || !isOnGlass()) {
    return;
  }
  ++m_restTicks;
  if (static_cast<double>(m_restTicks) * m_period >= m_machine.backOffAfter) {
    backOff();
  }
}

void Controller::backOff() {
  const Segment& on = segmentUnder();
  m_aside = Aside::BackingOff;
  m_report.beside = std::min(m_machine.backOff, m_window.room(m_report.segment));
  const geometry::Vector tangent = motion::evaluate(on, m_report.lambda).first.head<2>();
  const geometry::Vector away = m_program.wheelSide * geometry::leftOf(tangent.normalized());
  const geometry::Point from = m_report.commanded.head<2>();
  const geometry::Point inMachine = from + m_report.beside * away + m_origin.head<2>();
  const bool leavesTravel = inMachine.minCoeff() < 0 || (inMachine - m_machine.travel.head<2>()).maxCoeff() > 0;
  if (m_report.beside < kLeastRoom || leavesTravel) {
    m_report.beside = 0;
    raiseWheel();
    return;
  }
  Segment way;
  way.shape = geometry::Line{from, from + m_report.beside * away};
  way.z = m_report.commanded.z();
  way.feed = kBackOffSpeed;
  beginShort(way);
}

void Controller::raiseWheel() {
  const Eigen::Vector3d& at = m_report.commanded;
  Segment up;
  up.shape = motion::Vertical{at.head<2>(), at.z(), m_program.clearanceHeight};
  up.move = Move::Retract;
  up.feed = m_machine.maxSpeed.z() / 60;
  beginShort(up);
}

void Controller::beginShort(const Segment& segment) {
  m_shortSegment = segment;
  m_shortSegment.stopAtEnd = true;
  m_shortInterval = motion::restToRest(segment, m_program.limits);
  m_short.emplace(std::span(&m_shortSegment, 1), std::span(&m_shortInterval, 1), m_program.limits);
  m_shortTick = 0;
}

// True once it is at rest.
bool Controller::moveShort(double factor) {
  m_short->setOverride(factor);
  ++m_shortTick;
  const Eigen::Vector3d from = m_report.commanded;
  set(m_short->advanceTo(static_cast<double>(m_shortTick) * m_period));
  m_report.path += (m_report.commanded - from).norm();
  return m_short->atEnd() || m_short->standsStill();
}

void Controller::moveStopping() {
  if (m_short) {
    const bool raises = std::holds_alternative<motion::Vertical>(m_shortSegment.shape) && m_raise;
    if (!moveShort(raises ? 1 : 0)) {
      return;
    }
    m_short.reset();
  } else if (m_path && !m_path->standsStill() && !m_path->atEnd() && m_pathTick > 0) {
    movePath(0);
    return;
  } else if (m_rampsMove) {
    moveJogging();
    return;
  } else {
    standStill();
  }
  const bool isLow = m_homed && m_program.number != 0 && m_program.kind != program::Kind::Positioning &&
                     m_report.commanded.z() < m_program.clearanceHeight - kSamePlace;
  if (m_raise && isLow) {
    raiseWheel();
    return;
  }
  if (m_cutDrives && m_feedback.tick < m_movedTick) { // the axes are the lead behind: they are still being braked
    return;
  }
  handle(Event::AtRest);
}

void Controller::moveHoming() {
  const Homing::Outcome outcome = m_homing.advance(m_feedback, m_ramps);
  Eigen::Vector3d encoder = m_cycle.setPoint;
  for (int axis = 0; axis < kAxes; ++axis) {
    encoder[axis] = m_ramps[static_cast<std::size_t>(axis)].position();
    m_report.velocity[axis] = m_ramps[static_cast<std::size_t>(axis)].velocity();
  }
  if (outcome == Homing::Outcome::Done) {
    m_offset = m_homing.offset();
    m_homed = true;
    m_rampsMove = false;
  }
  m_report.commanded = tableOf(encoder);
  if (outcome == Homing::Outcome::Done) {
    handle(Event::Homed);
  } else if (outcome == Homing::Outcome::NotFound) {
    raise(Fault::HomingFailed, m_homing.axis());
  }
}

// Also brakes what homing had set in motion.
void Controller::moveJogging() {
  const bool isStopping = m_state != State::Jogging;
  if (!mayJog()) { // as if it were no longer said
    m_jogVelocity.setZero();
    m_jogsToTarget = false;
  }
  const bool isLeft = static_cast<double>(m_tick - m_jogTick) * m_period > kJogConfirm;
  bool atRest = true;
  const double fastest = (m_homed ? m_machine.jogSpeed : std::min(m_machine.jogSpeed, m_machine.homeSearch)) / 60;
  Eigen::Vector3d encoder;
  for (int axis = 0; axis < kAxes; ++axis) {
    AxisRamp& ramp = m_ramps[static_cast<std::size_t>(axis)];
    const double before = ramp.velocity();
    const double least = m_homed ? -m_offset[axis] : -std::numeric_limits<double>::infinity();
    const double most = m_homed ? m_machine.travel[axis] - m_offset[axis] : std::numeric_limits<double>::infinity();
    const auto i = static_cast<std::size_t>(axis);
    const double up = m_feedback.inputs.limitHigh[i] ? 0 : fastest; // off a limit switch only
    const double down = m_feedback.inputs.limitLow[i] ? 0 : fastest;
    if (m_jogsToTarget && !isStopping) {
      const double way = m_jogTarget[axis] - ramp.position();
      if ((way > 0 ? up : down) > 0) {
        ramp.to(m_jogTarget[axis], fastest);
      } else { // it stays where it comes to rest
        ramp.towards(0, least, most);
        m_jogTarget[axis] = ramp.velocity() == 0 ? ramp.position() : m_jogTarget[axis];
      }
      atRest = atRest && ramp.position() == m_jogTarget[axis];
    } else {
      ramp.towards(isStopping || isLeft ? 0 : std::clamp(m_jogVelocity[axis], -down, up), least, most);
      atRest = atRest && (isStopping || isLeft || m_jogVelocity.isZero());
    }
    atRest = atRest && ramp.velocity() == 0;
    encoder[axis] = ramp.position();
    m_report.velocity[axis] = ramp.velocity();
    m_report.axisAcceleration[axis] = (ramp.velocity() - before) / m_period;
  }
  m_report.commanded = tableOf(encoder);
  if (atRest) {
    m_rampsMove = false;
    if (!isStopping) {
      handle(Event::AtRest);
    }
  }
}

} // namespace arris::control
