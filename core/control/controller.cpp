#include "core/control/controller.h"

#include <algorithm>
#include <cmath>

namespace arris::control {

namespace {

/// Periods whose set-points and places are remembered; a power of two above every lead in periods.
constexpr std::size_t kHistory = 4096;

/// Jog and homing use this share of the machine's accelerations: a hand on a button needs no haste.
constexpr double kByHandShare = 0.2;

} // namespace

Controller::Controller(const recipe::Machine& machine, Channels& channels)
    : m_machine(machine), m_channels(channels), m_period(machine.period),
      m_lead(std::max(1, static_cast<int>(std::lround(machine.setPointLead / machine.period)))), m_history(kHistory),
      m_places(kHistory), m_homing(machine) {
  for (int axis = 0; axis < kAxes; ++axis) {
    m_ramps[static_cast<std::size_t>(axis)] = AxisRamp(kByHandShare * machine.maxAccel[axis], m_period);
    m_most[axis] = kByHandShare * machine.maxAccel[axis];
  }
}

const Cycle& Controller::advance(const Feedback& feedback) {
  ++m_tick;
  m_feedback = feedback;
  m_lastInputs = m_tick == 0 ? feedback.inputs : m_lastInputs;
  m_report.runTick = m_runs ? m_report.runTick + 1 : -1;
  watch();
  takeButtons();
  takeCommands();
  m_window.takeFrom(m_channels.buffers, m_path ? m_path->intervalIndex() : 0);
  if (m_path) {
    m_path->extend(m_window.view().end);
  }
  move();
  const Eigen::Vector3d setPoint = m_report.commanded + m_origin - m_offset;
  if (isConsistent(setPoint)) {
    m_movedTick = setPoint == m_cycle.setPoint ? m_movedTick : m_tick;
    m_cycle.setPoint = setPoint;
  }
  m_history[static_cast<std::size_t>(m_tick) & (kHistory - 1)] = m_cycle.setPoint;
  m_places[static_cast<std::size_t>(m_tick) & (kHistory - 1)] = m_report.place;
  tell();
  m_lastInputs = feedback.inputs;
  return m_cycle;
}

// Stop beats start.
void Controller::takeButtons() {
  m_jogEnabled = m_feedback.inputs.jogEnable && (m_jogEnabled || !m_lastInputs.jogEnable);
  const auto pressed = [this](bool Inputs::*button) { return m_feedback.inputs.*button && !(m_lastInputs.*button); };
  if (pressed(&Inputs::stop)) {
    handle(Event::Stop);
  } else if (pressed(&Inputs::hold)) {
    handle(Event::Hold);
  } else if (pressed(&Inputs::cycleStart)) {
    handle(m_state == State::Held && m_path && !m_path->atEnd() ? Event::Resume : Event::Start);
  }
  const int percent = m_feedback.inputs.overridePercent;
  if (percent != 0 && percent != m_lastInputs.overridePercent) {
    handle(command::Override{percent / 100.0});
  }
}

void Controller::takeCommands() {
  Command command;
  while (m_channels.commands.pop(command)) {
    m_operatorTick = m_tick;
    handle(command);
  }
}

void Controller::handle(const Command& command) {
  struct Handler {
    Controller& c;

    void operator()(command::Enable) const {
      c.handle(Event::Enable);
    }

    void operator()(command::Disable) const {
      c.handle(Event::Disable);
    }

    void operator()(command::Home) const {
      c.handle(Event::Home);
    }

    void operator()(const command::Load& load) const {
      c.load(load.program);
    }

    void operator()(command::Start) const {
      using program::Kind;
      const Kind kind = c.m_program.kind;
      c.handle(kind == Kind::Job ? Event::Start : kind == Kind::Step ? Event::Step : Event::Position);
      if (c.m_state == State::Idle) { // refused: it would be in the way of the next
        c.forgetProgram();
      }
    }

    void operator()(command::Hold) const {
      c.handle(Event::Hold);
    }

    void operator()(command::Resume) const {
      c.handle(Event::Resume);
    }

    void operator()(command::Stop) const {
      c.handle(Event::Stop);
    }

    void operator()(command::Acknowledge) const {
      c.handle(Event::Acknowledge);
    }

    void operator()(const command::Override& o) const {
      c.m_override = std::clamp(o.factor, motion::kLowestOverride, motion::kHighestOverride);
    }

    void operator()(const command::JogAt& jog) const {
      c.jog(jog.velocity);
    }

    void operator()(const command::JogBy& jog) const {
      c.jogBy(jog.way);
    }

    void operator()(const command::SetOrigin& set) const {
      if (c.m_state == State::Idle && set.origin.allFinite()) {
        c.m_report.commanded += c.m_origin - set.origin; // the axes stay where they are
        c.m_origin = set.origin;
      } else {
        ++c.m_report.refused;
      }
    }

    void operator()(const command::SpindleByHand& spindle) const {
      if (c.m_state == State::Idle || c.m_state == State::NotHomed || c.m_state == State::Jogging) {
        c.m_spindle = std::max(0.0, spindle.speed);
      } else {
        ++c.m_report.refused;
      }
    }

    void operator()(const command::CoolantByHand& coolant) const {
      if (c.m_state == State::Idle || c.m_state == State::NotHomed || c.m_state == State::Jogging) {
        c.m_coolant = coolant.on;
      } else {
        ++c.m_report.refused;
      }
    }

    void operator()(command::Heartbeat) const {}
  };

  std::visit(Handler{*this}, command);
}

bool Controller::mayFollow(Event event) const {
  using program::Kind;
  const bool isReady = drivesReady() && m_homed && m_program.number != 0;
  const bool isHeldBack = m_feedback.inputs.stop || m_feedback.inputs.hold; // stop beats start
  switch (event) {
  case Event::Enable:
    return !m_feedback.inputs.emergencyStop && !m_faults.any();
  case Event::Home:
    return drivesReady();
  case Event::Jog:
    return drivesReady() && mayJog();
  case Event::Start:
    return isReady && !isHeldBack && m_program.kind == Kind::Job && !m_path && m_aside != Aside::BackingOff;
  case Event::Step:
    return isReady && !isHeldBack && m_program.kind == Kind::Step && !m_path && m_aside != Aside::BackingOff;
  case Event::Position:
    return isReady && !isHeldBack && m_program.kind == Kind::Positioning && !m_path;
  case Event::Resume: // beside the path only a new program leads back to it
    return isReady && !isHeldBack && m_program.kind != Kind::Step && m_aside == Aside::OnPath &&
           !(m_path && m_path->atEnd());
  case Event::Acknowledge:
    return !m_feedback.inputs.emergencyStop;
  default:
    return true;
  }
}

// Among the rows of the table with the same state and event.
State Controller::choose(Event event, State state) const {
  const bool positions = m_program.kind == program::Kind::Positioning;
  if (event == Event::Resume && positions) {
    return State::Positioning;
  }
  if (event == Event::Enable || (event == Event::AtRest && state != State::Held)) {
    return m_faults.any() ? State::Faulted : m_homed ? State::Idle : State::NotHomed;
  }
  if (event == Event::Acknowledge && m_state == State::Faulted) {
    return !m_drivesOn ? State::Off : m_homed ? State::Idle : State::NotHomed;
  }
  return state;
}

void Controller::handle(Event event) {
  m_report.stops += event == Event::Stop ? 1 : 0;
  if (event == Event::Stop && (m_state == State::Idle || m_state == State::NotHomed)) { // what turns by hand
    m_spindle = 0;
    m_coolant = false;
  }
  const std::optional<State> state = next(m_state, event);
  if (!state || !mayFollow(event)) {
    ++m_report.refused;
    return;
  }
  if (event == Event::Hold && m_state == State::Stepping) {
    m_holdStep = true;
    return;
  }
  if (event == Event::Stop) { // once more while the wheel is being raised: no raising
    m_raise = m_state != State::Stopping || (m_raise && !m_short);
  }
  if (event == Event::Acknowledge) {
    m_faults.clear();
  }
  if (event == Event::ProgramEnd && m_program.kind == program::Kind::Job) {
    ++m_report.jobsEnded;
  }
  enter(choose(event, *state));
}

void Controller::enter(State state) {
  const State from = m_state;
  m_state = state;
  switch (state) {
  case State::Off:
  case State::EmergencyStop:
    m_drivesOn = false;
    m_cutDrives = false;
    break;
  case State::Idle:
  case State::NotHomed:
    if (from == State::Off) {
      m_drivesOn = true;
      m_enabledTick = m_tick;
    }
    break;
  case State::Homing:
    m_homed = false;
    m_homing.begin();
    beginRamps();
    break;
  case State::Jogging:
    if (from != State::Jogging) {
      beginRamps();
    }
    break;
  case State::Starting:
    m_spindle = m_program.spindleSpeed;
    m_coolant = m_program.spindleSpeed > 0;
    m_startTick = m_tick;
    break;
  case State::Held:
    m_restTicks = 0;
    break;
  case State::Stepping:
    m_holdStep = false;
    break;
  case State::Faulted:
    m_drivesOn = m_drivesOn && !m_cutDrives;
    m_cutDrives = false;
    break;
  case State::Running:
  case State::Holding:
  case State::Positioning:
  case State::Stopping:
    break;
  }
  const bool isOver = state == State::Off || state == State::EmergencyStop || state == State::Faulted ||
                      ((state == State::Idle || state == State::NotHomed) && isMoving(from) && from != State::Jogging);
  if (isOver) {
    forgetProgram();
    m_rampsMove = false;
    m_spindle = 0;
    m_coolant = false;
  }
  m_wereReady = m_wereReady && m_drivesOn;
}

void Controller::load(const ProgramHeader& header) {
  const bool allowed = m_state == State::Idle || (m_state == State::Held && m_aside != Aside::BackingOff);
  if (!allowed || header.number == 0 || header.stops != m_report.stops) {
    ++m_report.refused;
    return;
  }
  m_program = header;
  m_report.place = header.place.segment >= 0 ? header.place : m_report.place;
  m_loadedTick = m_tick;
  m_window.begin(header.number);
  m_path.reset();
  for (int axis = 0; axis < kAxes; ++axis) {
    m_most[axis] = std::max(kByHandShare * m_machine.maxAccel[axis], header.limits.acceleration[axis]);
  }
  if (header.limits.rule == recipe::AccelerationRule::Combined) { // which promises no limit of a single axis
    m_most.head<2>() = m_most.head<2>().cwiseMax(2 * header.limits.acceleration.head<2>().norm());
  }
}

void Controller::forgetProgram() {
  m_report.place = m_reachedPlace.value_or(m_report.place);
  m_reachedPlace.reset();
  m_program = {};
  m_window.begin(0);
  m_path.reset();
  m_short.reset();
  m_aside = Aside::OnPath;
  m_report.beside = 0;
  m_runs = false;
  m_raise = false;
}

void Controller::beginRamps() {
  for (int axis = 0; axis < kAxes; ++axis) {
    m_ramps[static_cast<std::size_t>(axis)].begin(m_report.commanded[axis] + m_origin[axis] - m_offset[axis]);
  }
  m_rampsMove = true;
}

bool Controller::mayJog() const {
  return m_jogEnabled || !m_machine.jogEnableRequired;
}

void Controller::jog(const Eigen::Vector3d& velocity) {
  const bool isNew = m_state != State::Jogging;
  if (!velocity.allFinite() || (isNew && velocity.isZero())) {
    return;
  }
  handle(Event::Jog);
  if (m_state == State::Jogging && mayJog()) {
    const double most = (m_homed ? m_machine.jogSpeed : std::min(m_machine.jogSpeed, m_machine.homeSearch)) / 60;
    m_jogVelocity = velocity.cwiseMax(-most).cwiseMin(most);
    m_jogsToTarget = false;
    m_jogTick = m_tick;
  }
}

void Controller::jogBy(const Eigen::Vector3d& way) {
  if (!way.allFinite() || m_state == State::Jogging || (way.cwiseAbs() - m_machine.travel).maxCoeff() > 0) {
    ++m_report.refused;
    return;
  }
  handle(Event::Jog);
  if (m_state == State::Jogging) {
    Eigen::Vector3d target = m_report.commanded + m_origin + way; // machine coordinates
    if (m_homed) {
      target = target.cwiseMax(0).cwiseMin(m_machine.travel);
    }
    m_jogTarget = target - m_offset;
    m_jogsToTarget = true;
  }
}

void Controller::tell() {
  m_cycle.outputs.driveEnable.fill(m_drivesOn);
  m_cycle.outputs.spindleSpeed = m_spindle;
  m_cycle.outputs.coolant = m_coolant;
  // In other faults too: where it stands still the drives lose their power, and the axes could not be braked on their
  // path. But where Arris itself is not well the watchdog shall act.
  if (!m_faults.has(Fault::SetPointInconsistent)) {
    m_cycle.outputs.heartbeat = !m_cycle.outputs.heartbeat;
  }
  m_report.tick = m_tick;
  m_report.state = m_state;
  m_report.aside = m_aside;
  m_report.homed = m_homed;
  m_report.drivesReady = drivesReady();
  m_report.program = m_program.number;
  m_report.kind = m_program.kind;
  m_report.overrideFactor = m_override;
  m_report.mayJog = mayJog();
  m_report.measuredTick = m_feedback.tick;
  m_report.measured = tableOf(m_feedback.position);
  m_report.origin = m_origin;
  m_report.inputs = m_feedback.inputs;
  m_report.outputs = m_cycle.outputs;
  m_report.faults = m_faults;
  m_report.pairsBuffered = static_cast<int>(m_channels.buffers.pairs());
  if (!m_channels.reports.push(m_report)) {
    ++m_report.lost;
  }
}

} // namespace arris::control
