#include "ui/figures/pointed_plot.h"

namespace arris::ui {
namespace {

constexpr double kPlotZoomStep = 1.5;
constexpr double kAxisPadding = 8; // units of figures
constexpr int kFocusFrame = 3;     // px, as the theme's

} // namespace

PointedPlot::PointedPlot(const FigureStyle& style, QWidget* parent) : QCustomPlot(parent), m_style(style) {
  QLocale locale(style.locale);
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  setLocale(locale);
  setAntialiasedElements(QCP::aeAll);
  setBackground(QBrush(style.palette.paper));
  setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
}

void PointedPlot::styleAxis(QCPAxis& axis) const {
  const auto padding = static_cast<int>(kAxisPadding * m_style.unit);
  axis.setBasePen(m_style.pen(m_style.palette.faint, kThinLine));
  axis.setTickPen(m_style.pen(m_style.palette.faint, kThinLine));
  axis.setSubTicks(false);
  axis.setTickLabelFont(m_style.font(kSmallTextHeight));
  axis.setTickLabelColor(m_style.palette.ink);
  axis.setTickLabelPadding(padding);
  axis.setLabelFont(m_style.font(kSmallTextHeight));
  axis.setLabelColor(m_style.palette.ink);
  axis.setLabelPadding(padding);
  axis.grid()->setPen(m_style.pen(m_style.palette.grid, kThinLine));
}

double PointedPlot::shown(double millimetres) const {
  return shownLength(millimetres, m_style.lengths);
}

void PointedPlot::zoomIn() {
  zoomBy(kPlotZoomStep);
}

void PointedPlot::zoomOut() {
  zoomBy(1 / kPlotZoomStep);
}

// On a layer that is drawn alone: what belongs to the time follows the mouse, and the curves stay.
void PointedPlot::markInstant(std::optional<double> time) {
  m_instant = time;
  if (isVisible()) {
    layer(QStringLiteral("overlay"))->replot();
  }
}

// Hidden, the plot has no size to be drawn at.
void PointedPlot::refresh() {
  if (isVisible()) {
    replot(rpQueuedReplot);
  }
}

void PointedPlot::showEvent(QShowEvent* event) {
  QCustomPlot::showEvent(event);
  refresh();
}

bool PointedPlot::isTap(const QMouseEvent& release) const {
  return (release.pos() - mMousePressPos).manhattanLength() < QApplication::startDragDistance();
}

void PointedPlot::keyPressEvent(QKeyEvent* event) {
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
void PointedPlot::paintEvent(QPaintEvent* event) {
  QCustomPlot::paintEvent(event);
  if (hasFocus()) {
    QPainter painter(this);
    painter.setPen(QPen(m_style.palette.ink, kFocusFrame));
    painter.drawRect(rect().adjusted(kFocusFrame / 2, kFocusFrame / 2, -kFocusFrame / 2 - 1, -kFocusFrame / 2 - 1));
  }
}

} // namespace arris::ui
