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
constexpr double kLeastPanelHeight = 85;
constexpr double kTickLength = 8;
constexpr double kLabelPadding = 8;
constexpr double kOverlaidLine = 8;
constexpr double kProfileZoomStep = 1.5;
constexpr double kPrintTolerance = 0.2;

// Values of the right-hand axis nearer than this share of it would stand on each other.
constexpr double kTickRoom = 0.25;

// The distance is shown over at least this share of the wheel radius.
constexpr double kLeastDistanceRange = 0.02;

constexpr double kLineBreak = std::numeric_limits<double>::quiet_NaN();

bool isSymmetric(Panel panel) {
  return panel != Panel::Speed && panel != Panel::Distance;
}

QVector<QCPGraphData> asGraphData(const QPolygonF& curve) {
  QVector<QCPGraphData> data;
  data.reserve(curve.size());
  for (const QPointF& point : curve) {
    data.append({point.x(), point.y()});
  }
  return data;
}

// A value of the right-hand axis with the words beside it.
void addTick(QCPAxis* axis, double value, const QString& words) {
  axis->ticker().dynamicCast<QCPAxisTickerText>()->addTick(value, words);
}

} // namespace

ProfilePlot::ProfilePlot(const FigureStyle& style, QWidget* parent) : QCustomPlot(parent), m_style(style) {
  QLocale locale(style.locale);
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  setLocale(locale);
  setAntialiasedElements(QCP::aeAll);
  setBackground(QBrush(style.palette.paper));
  setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  plotLayout()->clear();
  plotLayout()->setRowSpacing(0);
  auto* margins = new QCPMarginGroup(this);
  for (int i = 0; i < kPanelCount; ++i) {
    addPanel(static_cast<Panel>(i));
    PanelParts& panel = m_panels[static_cast<std::size_t>(i)];
    panel.rect->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
    addInstant(panel);
  }
  m_bands = new CornerBands(m_panels.front().rect, style);
  // All panels are equally high: the corners' labels and the time axis stand in rows of their own.
  addSpace(0, m_bands->labelHeight());
  addSpace(plotLayout()->rowCount(), static_cast<int>(kTimeAxisHeight * style.unit));
  const double least = kPanelCount * (kLeastPanelHeight + kPanelGap) + kTimeAxisHeight;
  setMinimumHeight(static_cast<int>(least * style.unit) + m_bands->labelHeight());
}

void ProfilePlot::addSpace(int row, int height) {
  auto* space = new QCPLayoutElement(this);
  space->setMinimumSize(0, height);
  space->setMaximumSize(QWIDGETSIZE_MAX, height);
  plotLayout()->insertRow(row);
  plotLayout()->addElement(row, 0, space);
}

void ProfilePlot::addPanel(Panel panel) {
  auto* rect = new QCPAxisRect(this);
  plotLayout()->addElement(plotLayout()->rowCount(), 0, rect);
  m_panels[static_cast<std::size_t>(panel)].rect = rect;
  const bool last = static_cast<int>(panel) + 1 == kPanelCount;
  const double unit = m_style.unit;
  const int gap = static_cast<int>(kPanelGap / 2 * unit);
  rect->setAutoMargins(QCP::msLeft | QCP::msRight);
  rect->setMargins(QMargins(0, gap, 0, gap));
  rect->setupFullAxesBox();
  rect->setRangeDrag(Qt::Horizontal);
  rect->setRangeZoom(Qt::Horizontal);
  for (QCPAxis* axis : rect->axes()) {
    axis->setBasePen(m_style.pen(m_style.palette.faint, kThinLine));
    axis->setTickPen(m_style.pen(m_style.palette.faint, kThinLine));
    axis->setSubTicks(false);
    axis->setTickLengthIn(0);
    axis->setTickLengthOut(0);
    axis->setTickLabelFont(m_style.font(kSmallTextHeight));
    axis->setTickLabelColor(m_style.palette.ink);
    axis->setTickLabelPadding(static_cast<int>(kLabelPadding * unit));
    axis->setLabelFont(m_style.font(kSmallTextHeight));
    axis->setLabelColor(m_style.palette.ink);
    axis->setLabelPadding(static_cast<int>(kLabelPadding * unit));
    axis->grid()->setPen(m_style.pen(m_style.palette.grid, kThinLine));
    axis->grid()->setZeroLinePen(m_style.pen(m_style.palette.faint, kThinLine));
    axis->setNumberFormat(QStringLiteral("g"));
    axis->setLayer(QStringLiteral("axes"));
    axis->grid()->setLayer(QStringLiteral("grid"));
  }
  const int tick = static_cast<int>(kTickLength * unit);
  rect->axis(QCPAxis::atLeft)->setTickLengthOut(tick);
  rect->axis(QCPAxis::atLeft)->setLabel(axisTitle(panel, true));
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
  for (PanelParts& other : m_panels) {
    if (other.rect && other.rect != rect) {
      QCPAxis* mine = rect->axis(QCPAxis::atBottom);
      QCPAxis* theirs = other.rect->axis(QCPAxis::atBottom);
      connect(mine, QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged), theirs,
              QOverload<const QCPRange&>::of(&QCPAxis::setRange));
      connect(theirs, QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged), mine,
              QOverload<const QCPRange&>::of(&QCPAxis::setRange));
    }
  }
}

QString ProfilePlot::axisTitle(Panel panel, bool inWords) {
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
  case Panel::Distance:
    break;
  }
  return inWords ? tr("Wheel to corner\nmm") : tr("L\nmm");
}

// Words where they fit beside the panels, symbols where they do not.
void ProfilePlot::setAxisTitles(double height) {
  const double panel = (height / m_style.unit - kTimeAxisHeight) / kPanelCount - kPanelGap;
  for (int i = 0; i < kPanelCount; ++i) {
    const auto kind = static_cast<Panel>(i);
    m_panels.at(static_cast<std::size_t>(i))
        .rect->axis(QCPAxis::atLeft)
        ->setLabel(axisTitle(kind, panel > kPanelHeightForWords));
  }
}

QColor ProfilePlot::colorOf(Panel panel) const {
  switch (panel) {
  case Panel::SpeedX:
  case Panel::AccelerationX:
    return m_style.palette.x;
  case Panel::SpeedY:
  case Panel::AccelerationY:
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
  m_cornerBands = profiles.empty() ? std::vector<CornerBand>() : profiles.front().bands;
  m_bands->show(m_cornerBands, limits.corners, m_panels.back().rect);
  setTimes(profiles);
  for (int i = 0; i < kPanelCount; ++i) {
    PanelParts& panel = m_panels[static_cast<std::size_t>(i)];
    const auto kind = static_cast<Panel>(i);
    panel.graphs.clear();
    panel.rect->axis(QCPAxis::atRight)->ticker().dynamicCast<QCPAxisTickerText>()->clear();
    setRange(panel, kind, profiles, limits);
    addLimits(panel, kind, limits);
    for (const ProfileCurves& curves : profiles) {
      addCurve(panel, kind, curves, profiles.size() > 1 && &curves == &profiles.front());
    }
  }
  if (!keepView) {
    showWork();
  }
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
void ProfilePlot::addCurve(PanelParts& panel, Panel kind, const ProfileCurves& curves, bool under) {
  QCPGraph* graph = addGraph(panel.rect->axis(QCPAxis::atBottom), panel.rect->axis(QCPAxis::atLeft));
  graph->setPen(under ? overlaidPen(m_style, colorOf(kind)) : m_style.pen(colorOf(kind), kLine + 0.5));
  graph->data()->set(asGraphData(curves.panels[static_cast<std::size_t>(kind)]), true);
  panel.graphs.push_back(graph);
}

void ProfilePlot::setRange(PanelParts& panel, Panel kind, const std::vector<ProfileCurves>& profiles,
                           const ProfileLimits& limits) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  const auto include = [&](double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  };
  for (const ProfileCurves& curves : profiles) {
    const auto [low, high] = curves.range[static_cast<std::size_t>(kind)];
    if (kind != Panel::Distance || high > 0) {
      include(low);
      include(high);
    }
  }
  if (kind == Panel::Distance) {
    include(limits.wheelRadius.value_or(0));
    for (const ProfileLimits::Corner& corner : limits.corners) {
      include(corner.reliefRadius.value_or(limits.wheelRadius.value_or(0)));
    }
  } else {
    include(0);
    const std::optional<double> limit = kind == Panel::AccelerationX   ? limits.accelX
                                        : kind == Panel::AccelerationY ? limits.accelY
                                                                       : limits.feed;
    include(limit.value_or(0));
    include(isSymmetric(kind) ? -limit.value_or(0) : 0);
  }
  if (isSymmetric(kind)) {
    most = std::max(most, -least);
    least = -most;
  }
  if (kind == Panel::Distance) {
    most = std::max(most, least * (1 + kLeastDistanceRange));
  }
  const double room = most > least ? 0.12 * (most - least) : 1;
  const double below = kind == Panel::Speed ? 0 : room;
  panel.rect->axis(QCPAxis::atLeft)->setRange(least - below, most + room);
  panel.rect->axis(QCPAxis::atRight)->setRange(least - below, most + room);
}

void ProfilePlot::addLimits(PanelParts& panel, Panel kind, const ProfileLimits& limits) {
  if (kind == Panel::Distance) {
    addReliefLimits(panel, limits);
    return;
  }
  const bool acceleration = kind == Panel::AccelerationX || kind == Panel::AccelerationY;
  const std::optional<double> limit = kind == Panel::AccelerationX   ? limits.accelX
                                      : kind == Panel::AccelerationY ? limits.accelY
                                                                     : limits.feed;
  if (!limit) {
    return;
  }
  const QString words = acceleration ? tr("limit %1") : tr("feed %1");
  addLimitLine(panel, *limit, words.arg(numberText(*limit, 2, m_style.locale)));
  if (isSymmetric(kind)) {
    addLimitLine(panel, -*limit, words.arg(numberText(-*limit, 2, m_style.locale)));
  }
}

void ProfilePlot::addLimitLine(PanelParts& panel, double value, const QString& words) {
  QCPGraph* line = addGraph(panel.rect->axis(QCPAxis::atBottom), panel.rect->axis(QCPAxis::atLeft));
  line->setPen(limitPen(m_style));
  const double far = 1e7; // s: beyond any profile
  line->data()->set({{-far, value}, {far, value}}, true);
  panel.graphs.push_back(line);
  addTick(panel.rect->axis(QCPAxis::atRight), value, words);
}

// R all along, and R + d of each corner over its band; their values stand together where they are too near.
void ProfilePlot::addReliefLimits(PanelParts& panel, const ProfileLimits& limits) {
  if (!limits.wheelRadius) {
    return;
  }
  const double radius = *limits.wheelRadius;
  const QString atRadius = QStringLiteral("R %1").arg(numberText(radius, 3, m_style.locale));
  addLimitLine(panel, radius, atRadius);
  QCPGraph* relief = addGraph(panel.rect->axis(QCPAxis::atBottom), panel.rect->axis(QCPAxis::atLeft));
  relief->setPen(reliefPen(m_style));
  panel.graphs.push_back(relief);
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  for (const CornerBand& band : m_cornerBands) {
    const auto corner = std::find_if(limits.corners.begin(), limits.corners.end(),
                                     [&](const ProfileLimits::Corner& c) { return c.id == band.corner; });
    if (band.zone == Zone::Corner && corner != limits.corners.end() && corner->reliefRadius) {
      relief->addData({band.from, band.to, band.to}, {*corner->reliefRadius, *corner->reliefRadius, kLineBreak}, true);
      least = std::min(least, *corner->reliefRadius);
      most = std::max(most, *corner->reliefRadius);
    }
  }
  if (most == 0) {
    return;
  }
  const QString lower = numberText(least, 2, m_style.locale);
  const QString upper = numberText(most, 2, m_style.locale);
  const QString atRelief = QStringLiteral("R + d %1").arg(lower == upper ? lower : lower + QStringLiteral("–") + upper);
  QCPAxis* right = panel.rect->axis(QCPAxis::atRight);
  if (least - radius > kTickRoom * right->range().size()) {
    addTick(right, least, atRelief);
  } else {
    addTick(right, radius, atRelief + QLatin1Char('\n') + atRadius);
  }
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

void ProfilePlot::showWork() {
  showTimes(m_workFrom, std::max(m_workTo, m_workFrom + 1e-3));
}

void ProfilePlot::showAll() {
  showTimes(0, m_duration);
}

// Hidden, the plot has no size to be drawn at.
void ProfilePlot::refresh() {
  if (isVisible()) {
    replot(rpQueuedReplot);
  }
}

void ProfilePlot::showEvent(QShowEvent* event) {
  QCustomPlot::showEvent(event);
  refresh();
}

void ProfilePlot::resizeEvent(QResizeEvent* event) {
  if (!event->size().isEmpty()) { // as a hidden part of a splitter it has no size to be drawn at
    setAxisTitles(event->size().height() - m_bands->labelHeight());
    QCustomPlot::resizeEvent(event);
  }
}

void ProfilePlot::zoomBy(double factor) {
  QCPAxis* time = m_panels.front().rect->axis(QCPAxis::atBottom);
  time->scaleRange(1 / factor);
  refresh();
}

void ProfilePlot::zoomIn() {
  zoomBy(kProfileZoomStep);
}

void ProfilePlot::zoomOut() {
  zoomBy(1 / kProfileZoomStep);
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
