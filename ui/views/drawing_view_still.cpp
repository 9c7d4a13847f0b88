#include "ui/views/drawing_view.h"

#include <QCoreApplication>
#include <QPointer>
#include <QThreadPool>

#include <algorithm>

// The drawing as a still picture under the wheel, and when it is painted anew.

namespace arris::ui {
namespace {

constexpr double kStillMargin = 0.25; // of the view, each way
constexpr int kGroundAtOnce = 2000;   // segments that are added in one painting

} // namespace

// The view with a margin: a pan within it paints nothing anew.
QRectF DrawingView::stillFrame() const {
  const QSize margin = (frame().size() * kStillMargin).toSize(); // whole pixels, so that nothing blurs
  return frame().adjusted(-margin.width(), -margin.height(), margin.width(), margin.height());
}

QPointF DrawingView::movedSinceStill() const {
  const QTransform now = viewportTransform();
  return {now.dx() - m_still.toView.dx(), now.dy() - m_still.toView.dy()};
}

bool DrawingView::hasScaleOfStill() const {
  const QTransform now = viewportTransform();
  return m_still.toView.m11() == now.m11() && m_still.toView.m22() == now.m22();
}

int DrawingView::groundSegments() const {
  return m_wheel ? std::clamp(m_wheel->done.segment, 0, static_cast<int>(m_plan->job.track.size())) : 0;
}

// Less ground than there: another pane, or a step back.
bool DrawingView::isStillOutdated() const {
  const QSize size = (stillFrame().size() * devicePixelRatioF()).toSize();
  const int more = groundSegments() - m_still.groundTo;
  return m_still.plan != m_plan || m_still.selected != m_selected || m_still.picture.size() != size ||
         !hasScaleOfStill() || !stillFrame().translated(movedSinceStill()).contains(frame()) || more < 0 ||
         more > kGroundAtOnce;
}

// A pan will soon leave it.
bool DrawingView::isStillShort() const {
  const QMarginsF half =
      QMarginsF(frame().width(), frame().height(), frame().width(), frame().height()) * (kStillMargin / 2);
  return !frame().marginsAdded(half).translated(movedSinceStill()).contains(frame());
}

bool DrawingView::isUpToDate() const {
  return !m_plan || !isStillOutdated();
}

// What has been ground since the last time is added; all else is painted anew only where a pan or a zoom shows more: a
// large drawing in another thread, while the picture before stands in for it.
void DrawingView::renewStill(QPainter::RenderHints hints) {
  if (!isStillOutdated()) {
    QPainter painter(&m_still.picture);
    painter.setRenderHints(hints);
    painter.translate(-m_still.frame.topLeft());
    for (const int ground = groundSegments(); m_still.groundTo < ground; ++m_still.groundTo) {
      paintGround(painter, *m_plan, m_style, m_still.toView, m_still.groundTo);
    }
    if (!isStillShort() || isPaintedAtOnce(*m_plan)) {
      return;
    }
  }
  const bool hasLines = m_still.plan == m_plan;
  const StillRequest request{m_plan,       m_selected,          viewportTransform(),
                             stillFrame(), devicePixelRatioF(), hints,
                             m_style,      groundSegments(),    hasLines ? m_still.lines : nullptr};
  if (isPaintedAtOnce(*m_plan)) {
    m_still = paintStill(request);
  } else if (!m_isPainting) {
    m_isPainting = true;
    QThreadPool::globalInstance()->start([view = QPointer(this), request] { // the view may be gone by then
      QMetaObject::invokeMethod(
          qApp,
          [view, still = paintStill(request)] {
            if (view) {
              view->take(still);
            }
          },
          Qt::QueuedConnection);
    });
  }
}

// The next painting looks whether it is what is wanted by now.
void DrawingView::take(const StillDrawing& still) {
  m_isPainting = false;
  if (still.plan == m_plan) {
    m_still = still;
  }
  viewport()->update();
}

void DrawingView::paintOverStill(QPainter& painter) {
  renewStill(painter.renderHints());
  const QTransform now = viewportTransform();
  const QPointF moved = movedSinceStill();
  if (!m_still.plan) { // it is being painted
    painter.fillRect(frame(), m_style.palette.paper);
  } else if (hasScaleOfStill()) {
    painter.drawImage(m_still.frame.topLeft() + moved, m_still.picture);
  } else { // as much as there is of it
    painter.save();
    painter.setTransform(m_still.toView.inverted() * now, true);
    painter.drawImage(m_still.frame.topLeft(), m_still.picture);
    painter.restore();
  }
  paintLegend(painter);
  if (!m_wheel) {
    return;
  }
  if (m_still.groundTo == m_wheel->done.segment && m_still.groundTo < static_cast<int>(m_plan->job.track.size())) {
    paintGround(painter, *m_plan, m_style, now, m_still.groundTo, m_wheel->done.lambda);
  }
  paintWheel(painter);
}

// A tap meets the labels where they are now.
std::vector<CornerLabel> DrawingView::labels() const {
  if (m_still.plan != m_plan || !hasScaleOfStill()) {
    return {};
  }
  std::vector<CornerLabel> labels = m_still.labels;
  const QPointF moved = movedSinceStill();
  for (CornerLabel& label : labels) {
    label.anchor += moved;
    label.badge.translate(moved);
    label.box.translate(moved);
  }
  return labels;
}

} // namespace arris::ui
