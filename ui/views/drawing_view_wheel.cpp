#include "ui/views/drawing_view.h"

#include <QKeyEvent>

#include <algorithm>
#include <cmath>

// The wheel over the drawing, where the machine has it or where the operator drags it.

namespace arris::ui {
namespace {

constexpr double kWheelLine = 2; // px
constexpr double kWheelCentre = 3;
constexpr int kWheelAlpha = 60;
constexpr int kPlannedAlpha = 14;
constexpr double kLeastGrip = 26;   // px round the centre: a finger takes a small wheel too
constexpr double kMostGrip = 80;    // and a large one leaves room to pan
constexpr double kFollowReach = 40; // px

} // namespace

void DrawingView::setWheel(const std::optional<LiveWheel>& wheel) {
  m_wheel = wheel;
  viewport()->update();
}

void DrawingView::bringWheelIntoView() {
  if (!m_wheel || frame().contains(viewportTransform().map(toQt(m_wheel->at)))) {
    return;
  }
  centerOn(toQt(m_wheel->at));
  m_fitted = false;
}

void DrawingView::setWheelMovable(bool movable) {
  m_wheelMovable = movable;
}

void DrawingView::paintWheel(QPainter& painter) const {
  const QPointF at = viewportTransform().map(toQt(m_wheel->at));
  const double radius = m_plan->drawing.wheelRadius * pixelsPerMillimetre();
  QColor disc = m_style.palette.x;
  painter.setPen(QPen(disc, kWheelLine, m_wheelMovable ? Qt::DashLine : Qt::SolidLine)); // planned, or where it is
  disc.setAlpha(m_wheelMovable ? kPlannedAlpha : kWheelAlpha);
  painter.setBrush(disc);
  painter.drawEllipse(at, radius, radius);
  painter.drawEllipse(at, kWheelCentre, kWheelCentre);
}

geometry::Point DrawingView::onTable(const QPointF& place) const {
  const QPointF there = viewportTransform().inverted().map(place);
  return {there.x(), there.y()};
}

bool DrawingView::isOnWheel(const QPointF& place) const {
  if (!m_wheelMovable || !m_wheel || !m_plan) {
    return false;
  }
  const double radius = m_plan->drawing.wheelRadius * pixelsPerMillimetre();
  const QPointF from = place - viewportTransform().map(toQt(m_wheel->at));
  return std::hypot(from.x(), from.y()) <= std::clamp(radius, kLeastGrip, kMostGrip);
}

void DrawingView::dragWheelTo(const QPointF& place) {
  Q_EMIT wheelDragged(onTable(place), kFollowReach / pixelsPerMillimetre());
}

bool DrawingView::stepWheel(int key) {
  const bool isOn = key == Qt::Key_Period || key == Qt::Key_PageDown;
  const bool isBack = key == Qt::Key_Comma || key == Qt::Key_PageUp;
  if (!m_wheelMovable || (!isOn && !isBack)) {
    return false;
  }
  Q_EMIT wheelStepped(isOn ? 1 : -1);
  return true;
}

} // namespace arris::ui
