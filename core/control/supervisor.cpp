#include "core/control/supervisor.h"

#include "core/control/channels.h"
#include "core/job/program_track.h"
#include "core/program/travel.h"
#include "core/toolpath/glass.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace arris::control {

using program::Kind;

namespace {

/// At the park position, mm.
constexpr double kParked = 1e-6;

/// A button that was pressed longer ago than this is not acted upon, s: the operator's side was held up.
constexpr double kFresh = 0.3;

/// A program that has not shown up after so many periods was refused.
constexpr std::int64_t kLaunchPatience = 200;

} // namespace

Supervisor::Supervisor(recipe::Machine machine, Channels& channels, Listener listener, std::launch planning)
    : m_machine(std::move(machine)), m_channels(channels), m_listener(std::move(listener)), m_planning(planning) {}

bool Supervisor::send(const Command& command) {
  return m_channels.commands.push(command);
}

void Supervisor::serve() {
  send(command::Heartbeat{});
  FaultReport fault;
  while (m_channels.faults.pop(fault)) {
    if (m_listener.fault) {
      m_listener.fault(fault);
    }
  }
  Report report;
  while (m_channels.reports.pop(report)) {
    take(report);
  }
  putOriginBack();
  doWhatPanelWants();
  doWhatWaits();
  takePlan();
  supply();
}

void Supervisor::take(const Report& report) {
  noteRun(report);
  watchPanel(report);
  m_latest = report;
  if (m_launching && (report.program == m_number || report.tick - m_launchTick > kLaunchPatience)) {
    m_launching = false; // it is there, or was refused
  }
  if (m_listener.period) {
    m_listener.period(report);
  }
}

// A run ends where the program has come to its end, or was broken off.
void Supervisor::noteRun(const Report& report) {
  if (!m_isRun) {
    m_isRun = report.runTick >= 0;
    if (m_isRun) {
      m_broken.reset();
    }
    m_jobState = m_isRun ? JobState::Running : m_jobState;
    return;
  }
  if (report.jobsEnded > m_latest.jobsEnded) {
    endRun();
  } else if (report.program == 0) {
    m_jobState = JobState::Aborted;
    m_isRun = false;
  } else {
    const bool held = report.state == State::Held || report.state == State::Holding || report.state == State::Stepping;
    m_jobState = held ? JobState::Interrupted : JobState::Running;
  }
}

void Supervisor::endRun() {
  ++m_done;
  m_broken.reset();
  m_jobState = JobState::Ended;
  m_isRun = false;
}

// A button that asks for what the controller cannot do by itself, as a program has to be planned first. Stop and hold
// beat it.
void Supervisor::watchPanel(const Report& report) {
  const bool stops = report.stops != m_latest.stops || report.inputs.stop || report.inputs.hold;
  if (stops) {
    m_pressedTick = -1;
    giveUpPlans();
  } else if (report.inputs.cycleStart && !m_latest.inputs.cycleStart && report.tick > 0) {
    m_pressedTick = report.tick;
  }
}

void Supervisor::doWhatPanelWants() {
  const std::int64_t pressed = std::exchange(m_pressedTick, -1);
  const bool isFresh = pressed >= 0 && static_cast<double>(m_latest.tick - pressed) * m_machine.period < kFresh;
  if (!isFresh) {
    return;
  }
  if (m_latest.state == State::Held && (m_latest.aside != Aside::OnPath || m_latest.kind == Kind::Step)) {
    m_wantsResume = true;
  } else if (m_latest.state == State::Idle && m_job) {
    cycleStart();
  }
}

void Supervisor::putOriginBack() {
  if (m_broken && m_latest.homed && m_latest.origin != m_broken->origin) {
    setOrigin(m_broken->origin);
  }
}

void Supervisor::doWhatWaits() {
  if (m_latest.state != State::Held) {
    const bool goesOn = m_latest.state == State::Holding || m_latest.state == State::Stepping;
    m_wantsResume = m_wantsResume && goesOn;
    m_wantsStep = goesOn ? m_wantsStep : 0;
    return;
  }
  if (m_latest.aside == Aside::BackingOff || m_launching || m_plan) { // soon
    return;
  }
  const bool onPath = m_latest.aside == Aside::OnPath;
  if (std::exchange(m_wantsResume, false)) {
    if (onPath && m_latest.kind != Kind::Step) {
      send(command::Resume{});
    } else {
      plan([job = m_job, place = m_latest.place,
            at = m_latest.commanded] { return program::resumeProgram(*job, place, job->recipe.overlap, at); },
           false);
    }
  } else if (m_wantsStep != 0 && (!onPath || m_machine.backOff == 0)) {
    plan(
        [job = m_job, place = m_latest.place, distance = std::exchange(m_wantsStep, 0), beside = m_latest.beside,
         at = m_latest.commanded]() -> std::optional<program::Program> {
          auto step = program::stepProgram(*job, place, distance, beside, at);
          return step ? std::optional(std::move(step->program)) : std::nullopt;
        },
        false);
  }
}

/// Plans in the background; true where it is under way or, planned at once, launched.
template <typename Way> bool Supervisor::plan(Way way, bool beginsRun, const program::JobPlace& place) {
  m_refusal.reset();
  m_plan = Plan{std::async(m_planning, [way = std::move(way)]() -> std::optional<program::Program> { return way(); }),
                m_latest.state, m_latest.stops, beginsRun, place};
  return m_planning == std::launch::async || takePlan();
}

// False where what was planned cannot be launched.
bool Supervisor::takePlan() {
  if (!m_plan || m_plan->program.wait_for(std::chrono::seconds(0)) == std::future_status::timeout) {
    return true;
  }
  Plan plan = std::move(*m_plan);
  m_plan.reset();
  auto program = plan.program.get();
  if (!plan.isWanted || m_latest.state != plan.state || m_latest.stops != plan.stops || !program) {
    return false;
  }
  if (program->track.empty() && plan.beginsRun) { // it was broken off at its very end
    endRun();
    return true;
  }
  return launch(std::move(*program), plan);
}

// One that is being planned is thrown away once it is there: waiting for it would take time.
void Supervisor::giveUpPlans() {
  m_wantsResume = false;
  m_wantsStep = 0;
  if (m_plan) {
    m_plan->isWanted = false;
  }
}

void Supervisor::supply() {
  while (m_stream && !m_stream->done() && m_channels.buffers.put(m_stream->pair())) {
    m_stream->advance();
  }
}

bool Supervisor::launch(program::Program program, const Plan& plan) {
  // The origin may have been moved since the job was planned.
  m_refusal = program::outsideTravel(program.track, m_machine, m_latest.origin);
  if (m_refusal || program.track.empty() || m_launching) {
    return false;
  }
  m_program = std::move(program);
  ++m_number;
  m_stream.emplace(m_program, m_number,
                   [this](int segment) { return m_room ? m_room->beside(segment, m_machine.backOff) : 0; });
  ProgramHeader header;
  header.number = m_number;
  header.kind = m_program.kind;
  header.limits = m_program.limits;
  if (m_job) {
    header.clearanceHeight = job::heightsOf(m_job->recipe, m_job->machine).clearance;
    header.wheelSide = toolpath::wheelSide(m_job->recipe.direction);
    header.spindleSpeed = m_program.kind == Kind::Positioning ? 0 : m_job->recipe.spindle;
  }
  header.beginsRun = plan.beginsRun;
  header.place = plan.place;
  header.stops = plan.stops;
  m_launching = true;
  m_launchTick = m_latest.tick;
  const bool sent = send(command::Load{header}) && send(command::Start{});
  supply();
  return sent;
}

bool Supervisor::isIdle() const {
  return m_latest.state == State::Idle && m_latest.drivesReady && m_latest.program == 0 && !m_plan && !m_launching;
}

bool Supervisor::enable() {
  return m_latest.state == State::Off && send(command::Enable{});
}

bool Supervisor::disable() {
  return next(m_latest.state, Event::Disable).has_value() && send(command::Disable{});
}

bool Supervisor::home() {
  return next(m_latest.state, Event::Home).has_value() && m_latest.drivesReady && send(command::Home{});
}

bool Supervisor::acknowledge() {
  return next(m_latest.state, Event::Acknowledge).has_value() && send(command::Acknowledge{});
}

bool Supervisor::setOrigin(const Eigen::Vector3d& origin) {
  return isIdle() && origin.allFinite() && send(command::SetOrigin{origin});
}

bool Supervisor::jogAt(const Eigen::Vector3d& velocity) {
  const bool allowed = m_latest.state == State::Jogging || (next(m_latest.state, Event::Jog) && m_latest.drivesReady);
  return allowed && send(command::JogAt{velocity});
}

bool Supervisor::jogBy(const Eigen::Vector3d& way) {
  const bool allowed = m_latest.state != State::Jogging && next(m_latest.state, Event::Jog) && m_latest.drivesReady;
  return allowed && send(command::JogBy{way});
}

bool Supervisor::spindleByHand(double speed) {
  return isIdle() && send(command::SpindleByHand{speed});
}

bool Supervisor::coolantByHand(bool on) {
  return isIdle() && send(command::CoolantByHand{on});
}

void Supervisor::setOverride(double factor) {
  send(command::Override{factor});
}

bool Supervisor::load(std::shared_ptr<const job::Job> job, int panes, const std::optional<Broken>& broken) {
  if (isBusy() || !job || !job->canBeGround() || panes < 1) {
    return false;
  }
  m_room = std::make_unique<program::Room>(*job);
  m_job = std::move(job);
  m_jobState = JobState::Initialized;
  m_broken = broken;
  m_done = 0;
  m_ordered = panes;
  return true;
}

bool Supervisor::isBusy() const {
  return m_isRun || m_launching || m_plan || m_latest.program != 0;
}

bool Supervisor::unload() {
  if (isBusy()) {
    return false;
  }
  m_room.reset();
  m_job.reset();
  m_broken.reset();
  m_jobState = JobState::Idle;
  return true;
}

bool Supervisor::cycleStart() {
  if (m_broken) {
    return m_latest.origin == m_broken->origin && startFrom(m_broken->place);
  }
  return m_jobState == JobState::Aborted ? startFrom(m_latest.place) : start();
}

bool Supervisor::start() {
  if (!isIdle() || !m_latest.homed || !m_job) {
    return false;
  }
  const bool isParked = (m_latest.commanded - m_job->machine.park).cwiseAbs().maxCoeff() <= kParked;
  return plan(
      [job = m_job, isParked, at = m_latest.commanded] {
        return isParked ? program::jobProgram(*job) : program::resumeProgram(*job, {0, 0}, job->recipe.overlap, at);
      },
      true, {0, 0});
}

bool Supervisor::startFrom(const program::JobPlace& place) {
  const bool isOfJob = m_job && place.segment >= 0 && place.segment < static_cast<int>(m_job->track.size());
  if (!isIdle() || !m_latest.homed || !isOfJob) {
    return false;
  }
  return plan([job = m_job, place,
               at = m_latest.commanded] { return program::resumeProgram(*job, place, job->recipe.overlap, at); },
              true, place);
}

// Sent in every state: what was ordered before may be on its way, and then it follows it.
bool Supervisor::hold() {
  const bool holdsSomething = isOrdered() || next(m_latest.state, Event::Hold).has_value();
  giveUpPlans();
  return send(command::Hold{}) && holdsSomething;
}

bool Supervisor::resume() {
  m_wantsResume = m_latest.state == State::Held || m_latest.state == State::Holding;
  return m_wantsResume;
}

bool Supervisor::step(double distance) {
  const bool allowed = m_latest.state == State::Held && m_job && std::isfinite(distance) && distance != 0;
  m_wantsStep = allowed ? distance : 0;
  return allowed;
}

void Supervisor::stop() {
  giveUpPlans();
  send(command::Stop{});
}

bool Supervisor::trace() {
  return isIdle() && m_latest.homed && m_job &&
         plan([job = m_job, at = m_latest.commanded] { return program::traceProgram(*job, at); }, false);
}

bool Supervisor::park() {
  const recipe::Recipe recipe = m_job ? m_job->recipe : recipe::Recipe{};
  return isIdle() && m_latest.homed &&
         plan([recipe, machine = m_machine,
               at = m_latest.commanded] { return program::parkProgram(recipe, machine, at); },
              false);
}

} // namespace arris::control
