#include "ui/figures/profile_plot.h"

#include "ui/figures/corner_bands.h"
#include "ui/figures/polyline.h"
#include "ui/text/quantities.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arris::ui {
namespace {

// In units of figures.
constexpr double kPanelGap = 22;
constexpr double kTimeAxisHeight = 82;
constexpr double kPanelHeightForWords = 215;
constexpr double kTickPitch = 48; // of the values of an axis
constexpr double kLeastPanelHeight = 76;
constexpr double kTickLength = 8;
constexpr double kOverlaidLine = 8;
constexpr double kPrintTolerance = 0.2;

constexpr double kLineBreak = std::numeric_limits<double>::quiet_NaN();

// Where the travel ends of the axis whose position a panel shows.
std::optional<double> travelFor(Panel panel, const ProfileLimits& limits) {
  return panel == Panel::PositionX ? limits.travelX : panel == Panel::PositionY ? limits.travelY : std::nullopt;
}

QVector<QCPGraphData> asGraphData(const QPolygonF& curve, double scale) {
  QVector<QCPGraphData> data;
  data.reserve(curve.size());
  for (const QPointF& point : curve) {
    data.append({point.x(), point.y() * scale});
  }
  return data;
}

} // namespace

ProfilePlot::ProfilePlot(const FigureStyle& style, PlotContent content, QWidget* parent) : PointedPlot(style, parent) {
  plotLayout()->clear();
  plotLayout()->setRowSpacing(0);
  auto* margins = new QCPMarginGroup(this);
  const std::span<const Panel> panels = panelsOf(content);
  for (const Panel panel : panels) {
    addPanel(panel, panel == panels.back());
    m_panels.back().rect->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
    addInstant(m_panels.back());
  }
  connect(m_panels.front().rect->axis(QCPAxis::atBottom), QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged), this,
          &ProfilePlot::fitPositions);
  m_bands = new CornerBands(m_panels.front().rect, style);
  // All panels are equally high: the corners' labels and the time axis stand in rows of their own.
  addSpace(0, m_bands->labelHeight());
  addSpace(plotLayout()->rowCount(), static_cast<int>(kTimeAxisHeight * style.unit));
  const double least = static_cast<double>(m_panels.size()) * (kLeastPanelHeight + kPanelGap) + kTimeAxisHeight;
  setMinimumHeight(static_cast<int>(least * style.unit) + m_bands->labelHeight());
}

void ProfilePlot::addSpace(int row, int height) {
  auto* space = new QCPLayoutElement(this);
  space->setMinimumSize(0, height);
  space->setMaximumSize(QWIDGETSIZE_MAX, height);
  plotLayout()->insertRow(row);
  plotLayout()->addElement(row, 0, space);
}

void ProfilePlot::addPanel(Panel panel, bool last) {
  auto* rect = new QCPAxisRect(this);
  plotLayout()->addElement(plotLayout()->rowCount(), 0, rect);
  const double unit = m_style.unit;
  const int gap = static_cast<int>(kPanelGap / 2 * unit);
  rect->setAutoMargins(QCP::msLeft | QCP::msRight);
  rect->setMargins(QMargins(0, gap, 0, gap));
  rect->setupFullAxesBox();
  rect->setRangeDrag(Qt::Horizontal);
  rect->setRangeZoom(Qt::Horizontal);
  for (QCPAxis* axis : rect->axes()) {
    styleAxis(*axis);
    axis->setTickLengthIn(0);
    axis->setTickLengthOut(0);
    axis->grid()->setZeroLinePen(m_style.pen(m_style.palette.faint, kThinLine));
    axis->setNumberFormat(QStringLiteral("g"));
    axis->setLayer(QStringLiteral("axes"));
    axis->grid()->setLayer(QStringLiteral("grid"));
  }
  const int tick = static_cast<int>(kTickLength * unit);
  rect->axis(QCPAxis::atLeft)->setTickLengthOut(tick);
  rect->axis(QCPAxis::atLeft)->setLabel(axisTitle(panel, true, m_style.lengths));
  rect->axis(QCPAxis::atLeft)->ticker()->setTickCount(4);
  rect->axis(QCPAxis::atBottom)->grid()->setZeroLinePen(Qt::NoPen);
  rect->axis(QCPAxis::atBottom)->setTickLabels(last);
  rect->axis(QCPAxis::atBottom)->setTickLengthOut(last ? tick : 0);
  rect->axis(QCPAxis::atBottom)->ticker()->setTickCount(10);
  if (last) {
    rect->axis(QCPAxis::atBottom)->setLabel(tr("time, s"));
  }
  rect->axis(QCPAxis::atTop)->setTicks(false);
  QCPAxis* right = rect->axis(QCPAxis::atRight);
  right->setTicker(QSharedPointer<QCPAxisTickerText>::create());
  right->setTickLabels(true);
  right->setTickLabelColor(m_style.palette.faint);
  // One time axis for all: whichever is dragged takes the others along.
  for (const PanelParts& other : m_panels) {
    QCPAxis* mine = rect->axis(QCPAxis::atBottom);
    QCPAxis* theirs = other.rect->axis(QCPAxis::atBottom);
    connect(mine, QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged), theirs,
            QOverload<const QCPRange&>::of(&QCPAxis::setRange));
    connect(theirs, QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged), mine,
            QOverload<const QCPRange&>::of(&QCPAxis::setRange));
  }
  m_panels.push_back({panel, rect, {}, {}, {}, nullptr});
}

QString ProfilePlot::axisTitle(Panel panel, bool inWords, LengthUnit unit) {
  return inShownUnits(titleInMillimetres(panel, inWords), unit);
}

QString ProfilePlot::titleInMillimetres(Panel panel, bool inWords) {
  switch (panel) {
  case Panel::SpeedX:
    return inWords ? tr("X velocity\nmm/s") : tr("v X\nmm/s");
  case Panel::SpeedY:
    return inWords ? tr("Y velocity\nmm/s") : tr("v Y\nmm/s");
  case Panel::AccelerationX:
    return inWords ? tr("X acceleration\nmm/s²") : tr("a X\nmm/s²");
  case Panel::AccelerationY:
    return inWords ? tr("Y acceleration\nmm/s²") : tr("a Y\nmm/s²");
  case Panel::Speed:
    return inWords ? tr("Path speed\nmm/s") : tr("v\nmm/s");
  case Panel::PositionX:
    return inWords ? tr("X position\nmm") : tr("X\nmm");
  case Panel::PositionY:
    return inWords ? tr("Y position\nmm") : tr("Y\nmm");
  case Panel::Distance:
    break;
  }
  return inWords ? tr("Wheel to corner\nmm") : tr("L\nmm");
}

// Words where they fit beside the panels, symbols where they do not.
void ProfilePlot::setAxisTitles(double height) {
  const double each = (height / m_style.unit - kTimeAxisHeight) / static_cast<double>(m_panels.size()) - kPanelGap;
  const int ticks = std::clamp(static_cast<int>(each / kTickPitch), 3, 4);
  for (const PanelParts& panel : m_panels) {
    panel.rect->axis(QCPAxis::atLeft)->ticker()->setTickCount(ticks);
    panel.rect->axis(QCPAxis::atLeft)->setLabel(axisTitle(panel.kind, each > kPanelHeightForWords, m_style.lengths));
  }
}

QColor ProfilePlot::colorOf(Panel panel) const {
  switch (panel) {
  case Panel::SpeedX:
  case Panel::AccelerationX:
  case Panel::PositionX:
    return m_style.palette.x;
  case Panel::SpeedY:
  case Panel::AccelerationY:
  case Panel::PositionY:
    return m_style.palette.y;
  case Panel::Speed:
    return m_style.palette.speed;
  case Panel::Distance:
    break;
  }
  return m_style.palette.distance;
}

void ProfilePlot::setProfiles(const std::vector<ProfileCurves>& profiles, const ProfileLimits& limits, bool keepView) {
  clearGraphs();
  for (PanelParts& panel : m_panels) {
    panel.graphs.clear();
    panel.curves.clear();
  }
  m_cornerBands = profiles.empty() ? std::vector<CornerBand>() : profiles.front().bands;
  m_bands->show(m_cornerBands, limits.corners, m_panels.back().rect);
  setTimes(profiles);
  for (PanelParts& panel : m_panels) {
    panel.rect->axis(QCPAxis::atLeft)->setTickLabels(!profiles.empty()); // a scale of nothing says nothing
    panel.rect->axis(QCPAxis::atRight)->ticker().dynamicCast<QCPAxisTickerText>()->clear();
    panel.travel = travelFor(panel.kind, limits);
    setRange(panel, profiles, limits);
    addLimits(panel, limits);
    for (const ProfileCurves& curves : profiles) {
      addCurve(panel, curves, profiles.size() > 1 && &curves == &profiles.front());
    }
  }
  if (!keepView) {
    showWork();
  }
  fitPositions();
  refresh();
}

void ProfilePlot::setTimes(const std::vector<ProfileCurves>& profiles) {
  m_workFrom = profiles.empty() ? 0 : std::numeric_limits<double>::infinity();
  m_workTo = m_duration = profiles.empty() ? 1 : 0;
  for (const ProfileCurves& curves : profiles) {
    m_workFrom = std::min(m_workFrom, curves.workFrom);
    m_workTo = std::max(m_workTo, curves.workTo);
    m_duration = std::max(m_duration, curves.duration);
  }
}

// Of two profiles the first lies wide and pale under the second: told apart without colour, and where they agree.
void ProfilePlot::addCurve(PanelParts& panel, const ProfileCurves& curves, bool under) {
  QCPGraph* graph = addGraph(panel.rect->axis(QCPAxis::atBottom), panel.rect->axis(QCPAxis::atLeft));
  graph->setPen(under ? overlaidPen(m_style, colorOf(panel.kind)) : m_style.pen(colorOf(panel.kind), kLine + 0.5));
  graph->data()->set(asGraphData(curveOf(curves, panel.kind), shown(1)), true);
  panel.graphs.push_back(graph);
  panel.curves.push_back(graph);
}

void ProfilePlot::selectCorner(int corner) {
  m_bands->select(corner);
  refresh();
}

void ProfilePlot::showTimes(double from, double to) {
  for (const PanelParts& panel : m_panels) {
    panel.rect->axis(QCPAxis::atBottom)->setRange(from, to);
  }
  refresh();
}

std::pair<double, double> ProfilePlot::shownTimes() const {
  const QCPRange shown = m_panels.front().rect->axis(QCPAxis::atBottom)->range();
  return {shown.lower, shown.upper};
}

void ProfilePlot::showWork() {
  showTimes(m_workFrom, std::max(m_workTo, m_workFrom + 1e-3));
}

void ProfilePlot::showAll() {
  showTimes(0, m_duration);
}

void ProfilePlot::resizeEvent(QResizeEvent* event) {
  if (!event->size().isEmpty()) { // as a hidden part of a splitter it has no size to be drawn at
    setAxisTitles(event->size().height() - m_bands->labelHeight());
    PointedPlot::resizeEvent(event);
  }
}

void ProfilePlot::zoomBy(double factor) {
  QCPAxis* time = m_panels.front().rect->axis(QCPAxis::atBottom);
  time->scaleRange(1 / factor);
  refresh();
}

void ProfilePlot::prepareForPrint(const QSize& size) {
  setAxisTitles(size.height() - m_bands->labelHeight());
  setViewport(QRect(QPoint(), size));
  for (const auto phase : {QCPLayoutElement::upPreparation, QCPLayoutElement::upMargins, QCPLayoutElement::upLayout}) {
    plotLayout()->update(phase);
  }
  for (const PanelParts& panel : m_panels) {
    for (QCPGraph* graph : panel.graphs) {
      QPolygonF device;
      for (const QCPGraphData& point : *graph->data()) {
        device.append(graph->coordsToPixels(point.key, point.value));
      }
      graph->setAdaptiveSampling(false);
      graph->data()->clear();
      for (const Stretch& run : clipped(device, panel.rect->rect())) {
        QPolygonF fine = thinned(columnExtremes(run.points, 1), kPrintTolerance * m_style.unit);
        for (const QPointF& point : fine) {
          graph->addData(graph->keyAxis()->pixelToCoord(point.x()), graph->valueAxis()->pixelToCoord(point.y()));
        }
        graph->addData(graph->keyAxis()->pixelToCoord(run.points.back().x()), kLineBreak);
      }
    }
  }
}

QPen overlaidPen(const FigureStyle& style, const QColor& color) {
  constexpr int kPaleness = 150; // of 255: how much of the paper shines through
  const auto mixed = [&](int ink, int paper) { return (ink * (255 - kPaleness) + paper * kPaleness) / 255; };
  const QColor& paper = style.palette.paper;
  return style.pen(
      QColor(mixed(color.red(), paper.red()), mixed(color.green(), paper.green()), mixed(color.blue(), paper.blue())),
      kOverlaidLine);
}

QPen limitPen(const FigureStyle& style) {
  QPen pen = style.pen(style.palette.error, kThinLine + 0.5);
  pen.setDashPattern({8, 5});
  return pen;
}

QPen reliefPen(const FigureStyle& style) {
  QPen pen = style.pen(style.palette.ink, kThinLine + 0.5);
  pen.setDashPattern({3, 2});
  return pen;
}

} // namespace arris::ui
