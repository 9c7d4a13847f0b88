#include "ui/presenters/machine_link.h"

#include "core/control/alarms.h"
#include "core/files/wall_clock.h"
#include "core/program/travel.h"

#include <algorithm>
#include <chrono>
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

/// The last places are still under way then for so long at most, ms.
constexpr int kLastPlaces = 300;

} // namespace

MachineLink::MachineLink(const MachineSetup& setup, QObject* parent)
    : MachineLink(setup,
                  makeAxes(setup.axes.value_or(files::Axes::Simulated), setup.machine, setup.pace, setup.moduleFolders),
                  parent) {}

MachineLink::MachineLink(const MachineSetup& setup, MachineAxes axes, QObject* parent)
    : QObject(parent), m_folder(setup.folder), m_pace(axes.pace), m_machine(setup.machine), m_simulated(axes.simulated),
      m_axes(setup.axes.value_or(files::Axes::Simulated)), m_absence(std::move(axes.absence)),
      m_station(setup.machine, std::move(axes.driver), axes.pace,
                {[this](const control::Report& report) { hear(report); },
                 [this](const control::FaultReport& fault) { hear(fault); }}),
      m_order(setup.folder.paneJournal()), m_offer(setup.folder, setup.machine, m_axes, setup.steps),
      m_watcher(setup.watcher) {
  m_pool.setMaxThreadCount(1);
  connect(&m_order, &OrderBook::changed, this, &MachineLink::changed);
  connect(&m_order, &OrderBook::failed, this, &MachineLink::complain);
  connect(&m_offer, &ResumeOffer::changed, this, &MachineLink::changed);
  connect(&m_offer, &ResumeOffer::ready, this, &MachineLink::takeUp);
  connect(&m_timer, &QTimer::timeout, this, &MachineLink::pass);
  setCounting(true);
  m_timer.setTimerType(Qt::PreciseTimer);
  m_timer.start(axes.pace == control::Pace::Real ? kServeEvery : 1);
}

MachineLink::~MachineLink() {
  m_timer.stop();
  blockSignals(true);
  if (!allowed().stop) {
    return;
  }
  m_station.operatorSide().stop();
  for (int waited = 0; waited < kRestPatience && allowed().stop; waited += kServeEvery) {
    passOnce();
  }
  for (int waited = 0; waited < kLastPlaces; waited += kServeEvery) {
    passOnce();
  }
}

void MachineLink::passOnce() {
  if (m_pace == control::Pace::Real) {
    std::this_thread::sleep_for(std::chrono::milliseconds(kServeEvery));
  }
  m_station.pass(kFastPeriods);
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
  if (const auto& refusal = operatorSide().refusal(); refusal != m_refusalSeen) {
    m_refusalSeen = refusal;
    if (refusal) {
      complain(*refusal);
    }
  }
  notePanes();
  noteOrigin();
  renewTimes();
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
  if (m_watcher) {
    m_watcher(report);
  }
  if (m_counters) {
    m_counters->add(report);
  }
  m_worstFollowingError = m_worstFollowingError.cwiseMax(report.followingError.cwiseAbs());
  if (!m_keeper) {
    return;
  }
  m_keeper->add(report);
  if (report.runTick == 0) {
    m_order.runBegins();
    const bool isNew = m_keeper->pane() != m_paneOfRun;
    m_ground = isNew ? 0 : m_ground;
    m_timeBefore = isNew ? 0 : m_paneTime;
    m_paneOfRun = m_keeper->pane();
  }
  if (report.runTick >= 0) {
    m_paneTime = m_timeBefore + static_cast<double>(report.runTick) * m_machine.period;
  }
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

// Whether the job still fits is told at once; the operator's side looks again before every start.
void MachineLink::noteOrigin() {
  if (report().origin == m_originSeen) {
    return;
  }
  m_originSeen = report().origin;
  if (m_complaint && m_complaint->code == base::Code::OutsideTravel) {
    m_complaint.reset();
  }
  if (const auto problem =
          m_loaded ? program::outsideTravel(m_loaded->job.track, m_machine, m_originSeen) : std::nullopt) {
    complain(*problem);
  }
  Q_EMIT changed();
}

Allowed MachineLink::allowed() const {
  Allowed allowed = allowedIn(report(), jobState(), m_loaded != nullptr, m_station.operatorSide().isOrdered());
  const auto& broken = operatorSide().broken();
  const bool isBeingPlanned = m_offer.state() == ResumeOffer::State::Planning;
  allowed.load = allowed.load && !isBeingPlanned;
  allowed.start = allowed.start && !isBeingPlanned && (!broken || broken->origin == report().origin);
  allowed.origin = allowed.origin && !broken;
  allowed.enable = allowed.enable && !m_absence;
  return allowed;
}

void MachineLink::enable() {
  if (allowed().enable) {
    m_station.operatorSide().enable();
  }
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

void MachineLink::start() {
  m_complaint.reset();
  m_refusalSeen.reset();
  m_station.operatorSide().cycleStart();
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
  m_refusalSeen.reset();
  m_station.operatorSide().trace();
}

void MachineLink::park() {
  m_refusalSeen.reset();
  m_station.operatorSide().park();
}

void MachineLink::jogAt(const Eigen::Vector3d& velocity) {
  m_station.operatorSide().jogAt(velocity);
}

void MachineLink::jogBy(const Eigen::Vector3d& way) {
  m_station.operatorSide().jogBy(way);
}

void MachineLink::setOrigin(const Eigen::Vector3d& origin) {
  if (allowed().origin) {
    m_station.operatorSide().setOrigin(origin);
  }
}

void MachineLink::spindleByHand(double speed) {
  m_station.operatorSide().spindleByHand(speed);
}

void MachineLink::coolantByHand(bool on) {
  m_station.operatorSide().coolantByHand(on);
}

void MachineLink::setOverride(double factor) {
  m_station.operatorSide().setOverride(std::clamp(factor, motion::kLowestOverride, motion::kHighestOverride));
}

void MachineLink::inject(control::SimulatedFault fault) {
  if (isSimulated()) {
    m_simulated->inject(fault);
  }
}

void MachineLink::press(control::Button button, bool down) {
  if (isSimulated()) {
    m_simulated->press(button, down);
  }
}

void MachineLink::clearFaults() {
  if (isSimulated()) {
    m_simulated->clearFaults();
  }
}

} // namespace arris::ui
