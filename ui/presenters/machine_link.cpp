#include "ui/presenters/machine_link.h"

#include "core/control/alarms.h"
#include "core/files/wall_clock.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

namespace arris::ui {

using control::JobState;
using control::State;

namespace {

/// Reports are taken so often, ms: well within the half second after which the controller misses its operator.
constexpr int kServeEvery = 20;

/// In simulated time: so many seconds pass each time, in pieces of so many periods.
constexpr double kFastSeconds = 1;
constexpr int kFastPeriods = 10;

/// For the axes to come to rest at the end, ms.
constexpr int kRestPatience = 60'000;

} // namespace

MachineLink::MachineLink(const MachineSetup& setup, QObject* parent)
    : MachineLink(setup, std::make_unique<control::SimulatedAxes>(setup.machine, setup.pace, setup.machine.travel / 2),
                  parent) {}

MachineLink::MachineLink(const MachineSetup& setup, std::unique_ptr<control::SimulatedAxes> axes, QObject* parent)
    : QObject(parent), m_folder(setup.folder), m_pace(setup.pace), m_machine(setup.machine), m_axes(axes.get()),
      m_station(setup.machine, std::move(axes), setup.pace,
                {[this](const control::Report& report) { hear(report); },
                 [this](const control::FaultReport& fault) { hear(fault); }}) {
  connect(&m_timer, &QTimer::timeout, this, &MachineLink::pass);
  setCounting(true);
  m_timer.setTimerType(Qt::PreciseTimer);
  m_timer.start(setup.pace == control::Pace::Real ? kServeEvery : 1);
}

MachineLink::~MachineLink() {
  m_timer.stop();
  blockSignals(true);
  if (control::isMoving(report().state)) {
    m_station.operatorSide().stop();
  }
  for (int waited = 0; waited < kRestPatience && control::isMoving(report().state); waited += kServeEvery) {
    if (m_pace == control::Pace::Real) {
      std::this_thread::sleep_for(std::chrono::milliseconds(kServeEvery));
    }
    m_station.pass(kFastPeriods);
  }
}

void MachineLink::pass() {
  const int rounds =
      m_pace == control::Pace::Real ? 1 : static_cast<int>(kFastSeconds / m_machine.period) / kFastPeriods;
  for (int i = 0; i < rounds; ++i) {
    m_station.pass(kFastPeriods);
  }
  if (m_keeper) {
    for (const base::Problem& problem : m_keeper->takeProblems()) {
      complain(problem);
    }
  }
  if (const auto failure = m_counters ? m_counters->takeFailure() : std::nullopt) {
    complain(*failure);
  }
  if (const auto& refusal = m_station.operatorSide().refusal()) {
    complain(*refusal);
  }
  Q_EMIT reported();
  tellChanges();
}

void MachineLink::complain(const base::Problem& problem) {
  if (m_complaint != problem) {
    m_complaint = problem;
    Q_EMIT changed();
  }
}

void MachineLink::tellChanges() {
  const Allowed now = allowed();
  if (now != m_told || report().state != m_toldState || jobState() != m_toldJob) {
    m_told = now;
    m_toldState = report().state;
    m_toldJob = jobState();
    Q_EMIT changed();
  }
}

void MachineLink::hear(const control::Report& report) {
  if (m_keeper) {
    m_keeper->add(report);
  }
  if (m_counters) {
    m_counters->add(report);
  }
  m_worstFollowingError = m_worstFollowingError.cwiseMax(report.followingError.cwiseAbs());
}

void MachineLink::hear(const control::FaultReport& fault) {
  m_alarms.push_back({fault, log(fault)});
  Q_EMIT alarmRaised(m_alarms.back());
}

// Each once: a run's keeper logs those that come while a job is loaded.
files::Alarm MachineLink::log(const control::FaultReport& fault) {
  if (m_keeper) {
    return m_keeper->add(fault);
  }
  files::Alarm alarm = control::alarmOf(fault, files::wallClock());
  std::error_code none; // whatever it is, writing meets it again
  std::filesystem::create_directories(m_folder.root, none);
  logged(files::appendAlarm(m_folder.alarmLog(), alarm));
  return alarm;
}

void MachineLink::logged(const base::Expected<void>& result) {
  if (!result) {
    complain(result.error());
  }
}

void MachineLink::setCounting(bool counts) {
  m_counters.reset();
  if (counts) {
    m_counters.emplace(m_folder.counters(), m_machine.period, files::wallClock());
    if (const auto& damage = m_counters->damage()) {
      complain(*damage);
    }
  }
}

Allowed MachineLink::allowed() const {
  return allowedIn(report(), jobState(), m_loaded != nullptr, m_station.operatorSide().isOrdered());
}

double MachineLink::progress() const {
  return jobState() == JobState::Ended ? 1 : std::clamp(report().path / m_length, 0.0, 1.0);
}

double MachineLink::timeLeft() const {
  return m_loaded ? m_loaded->job.duration * (1 - progress()) : 0;
}

void MachineLink::enable() {
  m_station.operatorSide().enable();
}

void MachineLink::disable() {
  m_station.operatorSide().disable();
}

void MachineLink::home() {
  m_station.operatorSide().home();
}

void MachineLink::acknowledge() {
  if (allowed().acknowledge && m_station.operatorSide().acknowledge()) {
    m_complaint.reset();
    for (Alarm& alarm : m_alarms) {
      if (std::exchange(alarm.isActive, false)) {
        alarm.logged.acknowledged = true;
        logged(files::appendAlarm(m_folder.alarmLog(), alarm.logged));
      }
    }
    Q_EMIT changed();
  }
}

// Nothing is loaded where its runs could leave nothing to resume from.
void MachineLink::load(const PlanPointer& plan, int panes) {
  if (!allowed().load) {
    return;
  }
  const std::shared_ptr<const job::Job> job(plan, &plan->job);
  auto keeper = std::make_unique<control::RunKeeper>(m_folder, job, plan->import->file.string(), plan->import->hash,
                                                     files::wallClock, control::PaneOrder{1, panes});
  if (const base::Problems problems = keeper->takeProblems(); !problems.empty()) {
    complain(problems.front());
    return;
  }
  if (!m_station.operatorSide().load(job, panes)) {
    return;
  }
  m_keeper = std::move(keeper);
  m_loaded = plan;
  m_length = motion::arcLength(job->track);
  m_complaint.reset();
  Q_EMIT changed();
}

void MachineLink::start() {
  m_complaint.reset();
  if (jobState() == JobState::Aborted) {
    m_station.operatorSide().startFrom(report().place);
  } else {
    m_station.operatorSide().start();
  }
}

void MachineLink::hold() {
  m_station.operatorSide().hold();
}

void MachineLink::resume() {
  m_station.operatorSide().resume();
}

void MachineLink::step(double distance) {
  m_station.operatorSide().step(distance);
}

void MachineLink::stop() {
  m_station.operatorSide().stop();
}

void MachineLink::trace() {
  m_station.operatorSide().trace();
}

void MachineLink::park() {
  m_station.operatorSide().park();
}

void MachineLink::jogAt(const Eigen::Vector3d& velocity) {
  m_station.operatorSide().jogAt(velocity);
}

void MachineLink::setOverride(double factor) {
  m_station.operatorSide().setOverride(std::clamp(factor, motion::kLowestOverride, motion::kHighestOverride));
}

void MachineLink::inject(control::SimulatedFault fault) {
  m_axes->inject(fault);
}

void MachineLink::clearFaults() {
  m_axes->clearFaults();
}

} // namespace arris::ui
