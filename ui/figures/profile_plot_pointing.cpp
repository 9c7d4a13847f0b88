#include "ui/figures/corner_bands.h"
#include "ui/figures/profile_plot.h"

#include <algorithm>

// The time that is pointed at, by mouse, finger or keys.

namespace arris::ui {
namespace {

constexpr double kArrowSteps = 200; // from one end of the time that is shown to the other
constexpr int kFocusFrame = 3;      // px, as the theme's

} // namespace

// On the layer that is drawn alone: the line follows the mouse and the curves stay.
void ProfilePlot::addInstant(PanelParts& panel) {
  panel.instant = new QCPItemStraightLine(this);
  panel.instant->setLayer(QStringLiteral("overlay"));
  panel.instant->setClipAxisRect(panel.rect);
  panel.instant->setPen(m_style.pen(m_style.palette.ink, kLine));
  panel.instant->setVisible(false);
  for (QCPItemPosition* position : {panel.instant->point1, panel.instant->point2}) {
    position->setAxes(panel.rect->axis(QCPAxis::atBottom), panel.rect->axis(QCPAxis::atLeft));
    position->setAxisRect(panel.rect);
    position->setTypeX(QCPItemPosition::ptPlotCoords);
    position->setTypeY(QCPItemPosition::ptAxisRectRatio);
  }
}

void ProfilePlot::markInstant(std::optional<double> time) {
  m_instant = time;
  for (const PanelParts& panel : m_panels) {
    panel.instant->setVisible(time.has_value());
    panel.instant->point1->setCoords(time.value_or(0), 0);
    panel.instant->point2->setCoords(time.value_or(0), 1);
  }
  if (isVisible()) {
    layer(QStringLiteral("overlay"))->replot();
  }
}

void ProfilePlot::pointAt(double x) {
  const QRect panel = m_panels.front().rect->rect();
  if (x >= panel.left() && x <= panel.right()) {
    Q_EMIT instantPointed(m_panels.front().rect->axis(QCPAxis::atBottom)->pixelToCoord(x));
  }
}

void ProfilePlot::pointBeside(int steps) {
  const QCPRange shown = m_panels.front().rect->axis(QCPAxis::atBottom)->range();
  const double from = m_instant && shown.contains(*m_instant) ? *m_instant : shown.center();
  Q_EMIT instantPointed(std::clamp(from + steps * shown.size() / kArrowSteps, shown.lower, shown.upper));
}

void ProfilePlot::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
  case Qt::Key_Left:
    pointBeside(-1);
    break;
  case Qt::Key_Right:
    pointBeside(1);
    break;
  case Qt::Key_Plus:
    zoomIn();
    break;
  case Qt::Key_Minus:
    zoomOut();
    break;
  case Qt::Key_Home:
    showWork();
    break;
  default:
    QCustomPlot::keyPressEvent(event);
  }
}

// With the frame of what has the focus.
void ProfilePlot::paintEvent(QPaintEvent* event) {
  QCustomPlot::paintEvent(event);
  if (hasFocus()) {
    QPainter painter(this);
    painter.setPen(QPen(m_style.palette.ink, kFocusFrame));
    painter.drawRect(rect().adjusted(kFocusFrame / 2, kFocusFrame / 2, -kFocusFrame / 2 - 1, -kFocusFrame / 2 - 1));
  }
}

void ProfilePlot::mouseMoveEvent(QMouseEvent* event) {
  QCustomPlot::mouseMoveEvent(event);
  if (event->buttons() == Qt::NoButton) {
    pointAt(event->position().x());
  }
}

void ProfilePlot::mouseReleaseEvent(QMouseEvent* event) {
  QCustomPlot::mouseReleaseEvent(event);
  const bool tapped = (event->pos() - mMousePressPos).manhattanLength() < QApplication::startDragDistance();
  const double time = m_panels.front().rect->axis(QCPAxis::atBottom)->pixelToCoord(event->position().x());
  if (tapped) {
    pointAt(event->position().x());
  }
  for (const CornerBand& band : m_cornerBands) {
    if (tapped && band.zone == Zone::Corner && time >= band.from && time <= band.to) {
      Q_EMIT cornerTapped(band.corner);
      return;
    }
  }
}

} // namespace arris::ui
