#include "core/files/wall_clock.h"
#include "ui/presenters/machine_link.h"

#include <algorithm>
#include <limits>

// The panes of an order: what is loaded for them, how far they are, what becomes of them.

namespace arris::ui {

using control::JobState;

// What has become of the pane since the last time.
void MachineLink::notePanes() {
  if (m_way && (report().runTick >= 0 || jobState() == JobState::Aborted)) {
    m_ground = std::max(m_ground, m_way->before(report().place));
  }
  const int done = operatorSide().panesDone();
  if (done > m_doneSeen) {
    if (report().jobsEnded == m_jobsSeen) { // nothing was left of it
      m_keeper->nothingLeft();
    }
    m_order.paneEnded(m_paneTime);
  } else if (jobState() == JobState::Aborted && m_toldJob != JobState::Aborted) {
    m_order.paneBroken(m_paneTime);
  }
  m_doneSeen = done;
  m_jobsSeen = report().jobsEnded;
  if (m_keeper) {
    m_keeper->setOrdered(m_order.toGrind());
  }
}

// In the background: for a job of many segments it takes its time.
void MachineLink::renewTimes() {
  const double factor = report().overrideFactor;
  if (!m_loaded || m_timesAsked || (m_times && m_times->overrideFactor() == factor)) {
    return;
  }
  m_timesAsked = true;
  m_pool.start([this, plan = m_loaded, factor] {
    auto times = std::make_shared<const program::Timetable>(plan->job, factor);
    QMetaObject::invokeMethod(
        this,
        [this, plan, times] {
          m_timesAsked = false;
          if (plan == m_loaded) {
            m_times = times;
          }
        },
        Qt::QueuedConnection);
  });
}

bool MachineLink::goesOnWithAPane() const {
  return operatorSide().broken().has_value() || jobState() == JobState::Aborted;
}

bool MachineLink::isRevision(const Plan& plan) const {
  return m_loaded && (plan.import->hash != m_loaded->import->hash || plan.import->file != m_loaded->import->file ||
                      plan.job.recipe != m_loaded->job.recipe);
}

double MachineLink::progress() const {
  if (!m_way || m_way->length() == 0) {
    return 0;
  }
  return jobState() == JobState::Ended ? 1 : std::clamp(m_ground / m_way->length(), 0.0, 1.0);
}

double MachineLink::wayLeft() const {
  return m_way ? m_way->length() * (1 - progress()) : 0;
}

double MachineLink::timeLeft() const {
  if (!m_loaded || jobState() == JobState::Ended) {
    return 0;
  }
  const auto& broken = operatorSide().broken();
  const program::JobPlace place = broken                                ? broken->place
                                  : jobState() == JobState::Initialized ? program::JobPlace()
                                                                        : report().place;
  if (!m_times) {
    return m_loaded->job.duration * (1 - progress()) / report().overrideFactor;
  }
  return m_times->left(place) * m_times->overrideFactor() / report().overrideFactor;
}

// Nothing is loaded where its runs could leave nothing to resume from.
bool MachineLink::prepare(const PlanPointer& plan, const control::PaneOrder& panes,
                          const std::optional<control::Supervisor::Broken>& broken) {
  const std::shared_ptr<const job::Job> job(plan, &plan->job);
  auto keeper = std::make_unique<control::RunKeeper>(m_folder, job, plan->import->file.string(), plan->import->hash,
                                                     files::wallClock, m_axes, panes);
  if (const base::Problems problems = keeper->takeProblems(); !problems.empty()) {
    complain(problems.front());
    return false;
  }
  if (!m_station.operatorSide().load(job, panes.ordered, broken)) {
    return false;
  }
  m_keeper = std::move(keeper);
  m_loaded = plan;
  m_way.emplace(m_loaded->job);
  m_times.reset();
  m_ground = broken ? m_way->before(broken->place) : 0;
  m_paneTime = 0;
  m_paneOfRun = broken ? panes.first : 0;
  m_doneSeen = 0;
  m_originSeen.setConstant(std::numeric_limits<double>::quiet_NaN()); // it is looked at anew
  m_complaint.reset();
  return true;
}

void MachineLink::load(const PlanPointer& plan) {
  if (!allowed().load || !plan->job.canBeGround()) {
    return;
  }
  giveUpPane();
  m_offer.setAside();
  const bool goesOn = isRevision(*plan) && m_order.isUnderWay(plan->import->hash);
  const control::PaneOrder panes =
      goesOn ? control::PaneOrder{m_order.pane(), m_order.toGrind()} : control::PaneOrder{1, m_order.wanted()};
  if (prepare(plan, panes, std::nullopt) && !goesOn) {
    m_order.begin(plan->import->file.filename().string(), plan->import->hash);
  }
  Q_EMIT changed();
}

void MachineLink::load(const PlanPointer& plan, int panes) {
  if (allowed().load) {
    m_order.setWanted(panes);
    load(plan);
  }
}

// With its place, its origin, and the panes that were done of its order.
void MachineLink::takeUp(const TakenUp& job) {
  const files::ResumePoint& point = job.point;
  giveUpPane();
  if (prepare(job.plan, {point.pane, point.panes}, control::Supervisor::Broken{point.place, point.origin})) {
    m_timeBefore = m_paneTime = point.time;
    const int rejects = std::min(job.before.rejects, point.pane - 1);
    m_order.setWanted(point.panes - rejects);
    m_order.begin(job.plan->import->file.filename().string(), job.plan->import->hash,
                  {point.pane - 1 - rejects, rejects});
  }
  Q_EMIT changed();
}

void MachineLink::giveUpPane() {
  m_order.judge(m_order.open() == OrderBook::Open::Broken ? files::Verdict::Reject : files::Verdict::Good);
}

void MachineLink::judge(files::Verdict verdict) {
  const bool isBroken = m_order.open() == OrderBook::Open::Broken;
  if (!allowed().judge || (isBroken && verdict != files::Verdict::Reject)) {
    return;
  }
  m_order.judge(verdict);
  if (isBroken &&
      m_station.operatorSide().load(std::shared_ptr<const job::Job>(m_loaded, &m_loaded->job), m_order.toGrind())) {
    m_keeper->nothingLeft();
    m_doneSeen = 0;
    m_ground = 0;
  }
  Q_EMIT changed();
}

} // namespace arris::ui
