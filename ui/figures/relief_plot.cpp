#include "ui/figures/relief_plot.h"

#include "core/base/numbers.h"
#include "ui/figures/profile_plot.h"
#include "ui/text/quantities.h"

#include <algorithm>
#include <cmath>

namespace arris::ui {
namespace {

constexpr int kReliefPoints = 120;
constexpr double kReliefRoom = 0.16;     // of the range, below and above
constexpr double kMarginTextAt = 0.3;    // of the margin: under the curve
constexpr double kLeastRange = 0.002;    // of R
constexpr double kReliefTickRoom = 0.12; // of the range: nearer limits are named together

// In units of figures.
constexpr double kReliefWidth = 540;
constexpr double kReliefHeight = 320;
constexpr double kReliefTick = 8;
constexpr double kReliefPadding = 6;
constexpr double kReliefTextGap = 14;

} // namespace

double reliefDistance(const toolpath::Corner& corner, double wheelRadius, double time) {
  const double rest = time * (corner.blendTime - time);
  return std::sqrt(base::squared(wheelRadius) +
                   base::squared(corner.blendAcceleration * rest) * (1 + std::cos(corner.angle)) / 2);
}

ReliefPlot::ReliefPlot(FigureStyle style, QWidget* parent)
    : QCustomPlot(parent), m_style(std::move(style)), m_curve(addGraph()), m_radius(addGraph()), m_relief(addGraph()),
      m_margin(new QCPItemLine(this)), m_marginText(new QCPItemText(this)) {
  QLocale locale(m_style.locale);
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  setLocale(locale);
  setAntialiasedElements(QCP::aeAll);
  setBackground(QBrush(m_style.palette.paper));
  setFocusPolicy(Qt::NoFocus);
  setMinimumSize(QSizeF(kReliefWidth * m_style.unit, kReliefHeight * m_style.unit).toSize());
  axisRect()->setupFullAxesBox();
  for (QCPAxis* axis : axisRect()->axes()) {
    axis->setBasePen(m_style.pen(m_style.palette.faint, kThinLine));
    axis->setTickPen(m_style.pen(m_style.palette.faint, kThinLine));
    axis->setSubTicks(false);
    axis->setTickLength(0, static_cast<int>(kReliefTick * m_style.unit));
    axis->setTickLabelFont(m_style.font(kSmallTextHeight));
    axis->setTickLabelColor(m_style.palette.ink);
    axis->setTickLabelPadding(static_cast<int>(kReliefPadding * m_style.unit));
    axis->setLabelFont(m_style.font(kSmallTextHeight));
    axis->setLabelColor(m_style.palette.ink);
    axis->setLabelPadding(static_cast<int>(kReliefPadding * m_style.unit));
    axis->setNumberFormat(QStringLiteral("g"));
    axis->grid()->setPen(m_style.pen(m_style.palette.grid, kThinLine));
    axis->grid()->setZeroLinePen(Qt::NoPen);
  }
  xAxis->setLabel(tr("time from A, s"));
  xAxis->ticker()->setTickCount(4);
  yAxis->setLabel(inShownUnits(tr("distance L, mm"), m_style.lengths));
  yAxis->ticker()->setTickCount(4);
  for (QCPAxis* named : {xAxis2, yAxis2}) {
    named->setTicker(QSharedPointer<QCPAxisTickerText>::create());
    named->setTickLabels(true);
  }
  m_curve->setPen(m_style.pen(m_style.palette.distance, kLine + 1));
  m_radius->setPen(limitPen(m_style));
  m_relief->setPen(reliefPen(m_style));
  addMargin();
}

void ReliefPlot::addMargin() {
  m_margin->setPen(m_style.pen(m_style.palette.ink, kLine));
  const double head = kReliefTick * m_style.unit;
  m_margin->setHead(QCPLineEnding(QCPLineEnding::esSpikeArrow, head, head));
  m_margin->setTail(QCPLineEnding(QCPLineEnding::esSpikeArrow, head, head));
  m_marginText->setFont(m_style.font(kSmallTextHeight, true));
  m_marginText->setPositionAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  m_marginText->setPadding(QMargins(static_cast<int>(kReliefTextGap * m_style.unit), 0, 0, 0));
}

// In the unit of the figure.
double ReliefPlot::shown(double millimetres) const {
  return shownLength(millimetres, m_style.lengths);
}

void ReliefPlot::showCorner(const toolpath::Corner& corner, double wheelRadius) {
  const double reliefRadius = wheelRadius + corner.tipDepth;
  m_curve->data()->clear();
  for (int i = 0; i <= kReliefPoints; ++i) {
    const double time = corner.blendTime * i / kReliefPoints;
    m_curve->addData(time, shown(reliefDistance(corner, wheelRadius, time)));
  }
  for (const auto& [line, value] : {std::pair(m_radius, wheelRadius), std::pair(m_relief, reliefRadius)}) {
    line->setData({0, corner.blendTime}, {shown(value), shown(value)}, true);
  }
  const double most = std::max(corner.widest, reliefRadius);
  const double range = std::max(most - wheelRadius, kLeastRange * wheelRadius);
  for (QCPAxis* axis : {yAxis, yAxis2}) {
    axis->setRange(shown(wheelRadius - kReliefRoom * range), shown(wheelRadius + (1 + kReliefRoom) * range));
  }
  for (QCPAxis* axis : {xAxis, xAxis2}) {
    axis->setRange(0, corner.blendTime);
  }
  const auto ends = xAxis2->ticker().dynamicCast<QCPAxisTickerText>();
  ends->clear();
  ends->addTick(0, QStringLiteral("A"));
  ends->addTick(corner.blendTime, QStringLiteral("C"));
  showLimits(wheelRadius, reliefRadius);
  showMargin(corner, reliefRadius);
  replot(rpQueuedReplot);
}

// Where both limits are too near to each other their names stand together.
void ReliefPlot::showLimits(double wheelRadius, double reliefRadius) {
  const auto names = yAxis2->ticker().dynamicCast<QCPAxisTickerText>();
  names->clear();
  const QString atRadius = QStringLiteral("R\n%1").arg(m_style.lengthText(wheelRadius, 3));
  const QString atRelief = QStringLiteral("R + d\n%1").arg(m_style.lengthText(reliefRadius, 3));
  if (shown(reliefRadius - wheelRadius) > 2 * kReliefTickRoom * yAxis->range().size()) {
    names->addTick(shown(wheelRadius), atRadius);
    names->addTick(shown(reliefRadius), atRelief);
  } else {
    names->addTick(shown(wheelRadius), QString(atRelief + QLatin1Char('\n') + atRadius).replace("\nR\n", "\nR "));
  }
}

void ReliefPlot::showMargin(const toolpath::Corner& corner, double reliefRadius) {
  const double middle = corner.blendTime / 2;
  const double margin = corner.widest - reliefRadius;
  m_margin->start->setCoords(middle, shown(reliefRadius));
  m_margin->end->setCoords(middle, shown(corner.widest));
  m_marginText->position->setCoords(middle, shown(reliefRadius + kMarginTextAt * margin));
  m_marginText->setColor(margin < 0 ? m_style.palette.error : m_style.palette.ink);
  const QString number =
      (margin < 0 ? QString() : QStringLiteral("+")) + fixedLengthText(margin, 2, m_style.locale, m_style.lengths);
  m_marginText->setText(inShownUnits(tr("relief\n%1 mm").arg(number), m_style.lengths));
}

} // namespace arris::ui
