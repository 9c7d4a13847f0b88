#include "ui/presenters/wheel_walk.h"

#include <algorithm>

namespace arris::ui {
namespace {

constexpr double kWheelStep = 10; // mm

// When the wheel first comes onto the glass.
double startOfWork(const job::Job& job) {
  const auto first = std::find_if(job.pieces.begin(), job.pieces.end(),
                                  [](const job::PlannedPiece& piece) { return piece.phase == job::Phase::LeadIn; });
  return first != job.pieces.end() ? first->motion.time : 0;
}

} // namespace

WheelWalk::WheelWalk(const Planner& planner, QObject* parent) : QObject(parent) {
  connect(&planner, &Planner::planned, this, &WheelWalk::takePlan);
  if (planner.plan()) {
    takePlan(planner.plan());
  }
}

void WheelWalk::takePlan(const PlanPointer& plan) {
  if (!m_plan || m_plan->import->file != plan->import->file) {
    m_share.reset();
  }
  m_trajectory.reset(); // it refers to the plan before
  m_plan = plan;
  if (!plan->job.pieces.empty()) {
    m_trajectory = std::make_unique<const job::Trajectory>(plan->job);
    m_time = m_share ? m_trajectory->timeAfter(*m_share * m_trajectory->length()) : startOfWork(plan->job);
  }
  Q_EMIT changed();
}

std::optional<job::Sample> WheelWalk::place() const {
  return m_trajectory ? std::optional(m_trajectory->at(m_time)) : std::nullopt;
}

double WheelWalk::duration() const {
  return m_trajectory ? m_plan->job.duration : 0;
}

bool WheelWalk::isAtStart() const {
  return m_time <= 0;
}

bool WheelWalk::isAtEnd() const {
  return m_time >= duration();
}

void WheelWalk::goTo(double time) {
  m_time = time;
  m_share = m_trajectory->at(time).path / m_trajectory->length();
  Q_EMIT changed();
}

void WheelWalk::step(double way) {
  if (m_trajectory) {
    const double to = m_trajectory->timeAfter(m_trajectory->at(m_time).path + way);
    goTo(m_trajectory->firstChange(m_time, to));
    Q_EMIT stepped();
  }
}

void WheelWalk::stepOn() {
  step(kWheelStep);
}

void WheelWalk::stepBack() {
  step(-kWheelStep);
}

void WheelWalk::dragTo(const geometry::Point& point, double reach) {
  if (m_trajectory) {
    goTo(m_trajectory->nearest(point, m_time, reach).time);
  }
}

bool WheelWalk::putTo(const geometry::Point& point, double reach) {
  if (!m_trajectory) {
    return false;
  }
  const job::Trajectory::Near anywhere = m_trajectory->nearest(point);
  if (anywhere.distance <= reach) {
    goTo(anywhere.time);
  }
  return anywhere.distance <= reach;
}

} // namespace arris::ui
