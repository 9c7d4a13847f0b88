#include "ui/presenters/resume_offer.h"

#include "core/files/set_aside.h"

#include <utility>

namespace arris::ui {

ResumeOffer::ResumeOffer(files::StateFolder folder, recipe::Machine machine, files::Axes axes, PlannerSteps steps,
                         QObject* parent)
    : QObject(parent), m_folder(std::move(folder)), m_machine(std::move(machine)), m_axes(axes),
      m_steps(std::move(steps)) {
  m_pool.setMaxThreadCount(1);
  control::FoundJob found = control::findBrokenJob(m_folder);
  m_job = std::move(found.job);
  if (m_job) {
    m_state = State::Offered;
  } else if (!found.problems.empty()) {
    m_problems = std::move(found.problems);
    moveAside();
  }
}

ResumeOffer::~ResumeOffer() {
  m_stop.request_stop();
  m_pool.waitForDone();
}

void ResumeOffer::takeUp() {
  if (m_state != State::Offered) {
    return;
  }
  m_problems = control::checkMachine(m_job->point, m_machine);
  if (const auto problem = control::checkAxes(m_job->point, m_axes)) {
    m_problems.push_back(*problem);
  }
  if (m_problems.empty()) {
    m_state = State::Planning;
    m_stop = std::stop_source();
    m_pool.start(
        [this, point = m_job->point, steps = m_steps, journal = m_folder.paneJournal(), stop = m_stop.get_token()] {
          const Outcome outcome = plan(point, steps, journal, stop);
          QMetaObject::invokeMethod(
              this,
              [this, outcome, stop] {
                if (!stop.stop_requested()) {
                  take(outcome);
                }
              },
              Qt::QueuedConnection);
        });
  }
  Q_EMIT changed();
}

void ResumeOffer::cancel() {
  if (m_state == State::Planning) {
    m_stop.request_stop();
    m_state = State::Offered;
    Q_EMIT changed();
  }
}

// In the worker's thread.
ResumeOffer::Outcome ResumeOffer::plan(const files::ResumePoint& point, const PlannerSteps& steps,
                                       const std::filesystem::path& journal, const std::stop_token& stop) {
  auto read = steps.read(point.patternFile, pattern::importOptions(point.recipe), {stop});
  if (!read) { // its medium may only not be there
    return {std::nullopt, {read.error()}, true};
  }
  if (const auto problem = control::checkPattern(point, read->hash)) {
    return {std::nullopt, {*problem}, false};
  }
  const auto import = std::make_shared<const Import>(*std::move(read));
  job::Job job = steps.plan(import->pattern, point.recipe, point.machine, {stop});
  if (!job.canBeGround()) {
    return {std::nullopt, job.problems, false};
  }
  if (const auto problem = control::checkPlace(point, job)) {
    return {std::nullopt, {*problem}, false};
  }
  const PlanPointer plan = planOf(import, std::move(job));
  const auto panes = files::readPanes(journal);
  return {TakenUp{plan, point, panes ? files::countBefore(point.pane, point.patternHash, *panes) : files::PaneCounts()},
          {},
          false};
}

void ResumeOffer::take(const Outcome& outcome) {
  m_problems = outcome.problems;
  if (outcome.job) {
    m_state = State::None;
    m_job.reset();
    Q_EMIT ready(*outcome.job);
  } else if (outcome.staysOffered) {
    m_state = State::Offered;
  } else {
    moveAside();
  }
  Q_EMIT changed();
}

void ResumeOffer::moveAside() {
  m_aside = files::setAside(m_folder.resumePoint()).value_or(std::filesystem::path());
  m_job.reset();
  m_state = State::SetAside;
}

void ResumeOffer::setAside() {
  if (m_state == State::Offered) {
    m_problems.clear();
    moveAside();
    Q_EMIT changed();
  }
}

void ResumeOffer::discard() {
  if (m_state == State::Offered) {
    std::error_code none;
    std::filesystem::remove(m_folder.resumePoint(), none);
    dismiss();
  }
}

void ResumeOffer::dismiss() {
  if (m_state != State::Planning) {
    m_state = State::None;
    m_job.reset();
    m_problems.clear();
    Q_EMIT changed();
  }
}

} // namespace arris::ui
