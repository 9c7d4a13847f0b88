#include "ui/figures/corner_bands.h"
#include "ui/figures/profile_plot.h"

#include <algorithm>

// The time that is pointed at, by mouse, finger or keys.

namespace arris::ui {
namespace {

constexpr double kArrowSteps = 200; // from one end of the time that is shown to the other

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
  for (const PanelParts& panel : m_panels) {
    panel.instant->setVisible(time.has_value());
    panel.instant->point1->setCoords(time.value_or(0), 0);
    panel.instant->point2->setCoords(time.value_or(0), 1);
  }
  PointedPlot::markInstant(time);
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

void ProfilePlot::mouseMoveEvent(QMouseEvent* event) {
  PointedPlot::mouseMoveEvent(event);
  if (event->buttons() == Qt::NoButton) {
    pointAt(event->position().x());
  }
}

void ProfilePlot::mouseReleaseEvent(QMouseEvent* event) {
  PointedPlot::mouseReleaseEvent(event);
  const bool tapped = isTap(*event);
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
