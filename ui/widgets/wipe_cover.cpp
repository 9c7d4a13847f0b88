#include "ui/widgets/wipe_cover.h"

namespace arris::ui {
namespace {

constexpr int kCountEvery = 200; // ms
constexpr int kCountSize = 28;   // px
constexpr int kMillisecond = 1000;

} // namespace

WipeCover::WipeCover(QWidget* parent) : QLabel(parent) {
  setObjectName(QStringLiteral("cover"));
  setAlignment(Qt::AlignCenter);
  setWordWrap(true);
  setAutoFillBackground(true);
  QFont large = font();
  large.setPixelSize(kCountSize);
  setFont(large);
  m_timer.setInterval(kCountEvery);
  connect(&m_timer, &QTimer::timeout, this, &WipeCover::tick);
  hide();
}

void WipeCover::begin() {
  setGeometry(parentWidget()->rect());
  m_since.start();
  m_timer.start();
  tick();
  show();
  raise();
}

void WipeCover::tick() {
  const auto passed = static_cast<int>(m_since.elapsed() / kMillisecond);
  if (passed >= kLasts) {
    m_timer.stop();
    hide();
    Q_EMIT ended();
    return;
  }
  setText(tr("The screen is locked for wiping: %1 s\nFEED HOLD and STOP work whenever something moves.")
              .arg(kLasts - passed));
}

} // namespace arris::ui
