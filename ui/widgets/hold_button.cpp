#include "ui/widgets/hold_button.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>

namespace arris::ui {
namespace {

constexpr int kTick = 16;        // ms
constexpr double kRing = 22;     // px across
constexpr double kRingLine = 4;  // px
constexpr double kRingInset = 8; // px from the right
constexpr int kEmptyAlpha = 110;
constexpr int kFullTurn = 360 * 16;

} // namespace

HoldButton::HoldButton(const QString& text, QWidget* parent) : QPushButton(text, parent) {
  m_timer.setInterval(kTick);
  connect(&m_timer, &QTimer::timeout, this, &HoldButton::tick);
  connect(this, &QPushButton::pressed, this, &HoldButton::begin);
  connect(this, &QPushButton::released, this, &HoldButton::giveUp);
}

void HoldButton::begin() {
  if (!m_timer.isActive()) { // a key that repeats presses again
    m_since.start();
    m_timer.start();
  }
}

void HoldButton::tick() {
  update();
  if (m_since.elapsed() >= kHoldFor) {
    m_timer.stop();
    Q_EMIT held();
  }
}

void HoldButton::giveUp() {
  m_timer.stop();
  update();
}

void HoldButton::focusOutEvent(QFocusEvent* event) {
  giveUp();
  QPushButton::focusOutEvent(event);
}

void HoldButton::hideEvent(QHideEvent* event) {
  giveUp();
  QPushButton::hideEvent(event);
}

void HoldButton::changeEvent(QEvent* event) {
  if (event->type() == QEvent::EnabledChange || event->type() == QEvent::ActivationChange) {
    giveUp();
  }
  QPushButton::changeEvent(event);
}

void HoldButton::paintEvent(QPaintEvent* event) {
  QPushButton::paintEvent(event);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF ring(width() - kRing - kRingInset, (height() - kRing) / 2, kRing, kRing);
  const QColor color = palette().color(isEnabled() ? QPalette::ButtonText : QPalette::Mid);
  QColor empty = color;
  empty.setAlpha(kEmptyAlpha);
  painter.setPen(QPen(isEnabled() ? empty : color, kRingLine));
  painter.drawEllipse(ring);
  if (m_timer.isActive()) {
    const double share = std::min(1.0, static_cast<double>(m_since.elapsed()) / kHoldFor);
    painter.setPen(QPen(color, kRingLine));
    painter.drawArc(ring, kFullTurn / 4, -qRound(share * kFullTurn));
  }
}

} // namespace arris::ui
