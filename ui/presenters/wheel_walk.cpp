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
  m_plan = plan;
  if (const job::Trajectory* way = trajectory()) {
    m_time = m_share ? way->timeAfter(*m_share * way->length()) : startOfWork(plan->job);
  }
  Q_EMIT changed();
}

const job::Trajectory* WheelWalk::trajectory() const {
  return m_plan ? m_plan->trajectory.get() : nullptr;
}

std::optional<job::Sample> WheelWalk::place() const {
  return trajectory() ? std::optional(trajectory()->at(m_time)) : std::nullopt;
}

double WheelWalk::duration() const {
  return trajectory() ? m_plan->job.duration : 0;
}

bool WheelWalk::isAtStart() const {
  return m_time <= 0;
}

bool WheelWalk::isAtEnd() const {
  return m_time >= duration();
}

void WheelWalk::goTo(double time) {
  m_time = time;
  m_share = trajectory()->at(time).path / trajectory()->length();
  Q_EMIT changed();
}

void WheelWalk::step(double way) {
  if (trajectory()) {
    const double to = trajectory()->timeAfter(trajectory()->at(m_time).path + way);
    goTo(trajectory()->firstChange(m_time, to));
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
  if (trajectory()) {
    goTo(trajectory()->nearest(point, m_time, reach).time);
  }
}

bool WheelWalk::putTo(const geometry::Point& point, double reach) {
  if (!trajectory()) {
    return false;
  }
  const job::Trajectory::Near anywhere = trajectory()->nearest(point);
  if (anywhere.distance <= reach) {
    goTo(anywhere.time);
  }
  return anywhere.distance <= reach;
}

} // namespace arris::ui
