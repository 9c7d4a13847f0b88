#include "ui/figures/corner_bands.h"

#include "ui/text/quantities.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>
#include <limits>

namespace arris::ui {
namespace {

// In units of figures.
constexpr double kBandBadgeHeight = 40;
constexpr double kBandAngleHeight = 34;
constexpr double kBandGap = 8;
constexpr double kNarrowest = 6;

constexpr int kSelectedShade = 5; // % of ink

// Of a corner that is selected: nearer to the ink, on light and on dark paper.
QColor shaded(const QColor& color, const QColor& ink) {
  const auto mixed = [](int of, int with) { return (of * (100 - kSelectedShade) + with * kSelectedShade) / 100; };
  return {mixed(color.red(), ink.red()), mixed(color.green(), ink.green()), mixed(color.blue(), ink.blue())};
}

} // namespace

CornerBands::CornerBands(QCPAxisRect* top, FigureStyle style)
    : QCPLayerable(top->parentPlot(), QStringLiteral("background")), m_top(top), m_bottom(top),
      m_style(std::move(style)) {}

void CornerBands::show(std::vector<CornerBand> bands, std::vector<ProfileLimits::Corner> corners,
                       const QCPAxisRect* bottom) {
  m_bands = std::move(bands);
  m_corners = std::move(corners);
  m_bottom = bottom;
}

void CornerBands::select(int corner) {
  m_selected = corner;
}

int CornerBands::labelHeight() const {
  return static_cast<int>(std::ceil((kBandBadgeHeight + kBandAngleHeight + 2 * kBandGap) * m_style.unit));
}

void CornerBands::applyDefaultAntialiasingHint(QCPPainter* painter) const {
  painter->setAntialiasing(true);
}

void CornerBands::draw(QCPPainter* painter) {
  const QCPAxis* time = m_top->axis(QCPAxis::atBottom);
  const double left = m_top->left();
  const double right = m_top->left() + m_top->width();
  for (const Zone zone : {Zone::Away, Zone::Slowing, Zone::Leaving, Zone::Corner}) {
    for (const CornerBand& band : m_bands) {
      const double from = time->coordToPixel(band.from);
      const double to = time->coordToPixel(band.to);
      if (band.zone == zone && to >= left && from <= right) {
        drawBand(painter, band, std::clamp(from, left, right), std::clamp(to, left, right));
      }
    }
  }
  drawLabels(painter);
}

void CornerBands::drawBand(QCPPainter* painter, const CornerBand& band, double from, double to) const {
  const double top = m_top->top();
  const double bottom = m_bottom->top() + m_bottom->height();
  const bool inCorner = band.zone == Zone::Corner;
  const bool away = band.zone == Zone::Away;
  QColor color = inCorner ? m_style.palette.cornerBand : away ? m_style.palette.awayBand : m_style.palette.phaseBand;
  if (band.corner == m_selected && !away) {
    color = shaded(color, m_style.palette.ink);
  }
  painter->fillRect(QRectF(from, top, to - from, bottom - top), color);
  if (inCorner && (to == from || to - from > kNarrowest * m_style.unit)) { // else the edges are all that is seen
    painter->setPen(m_style.pen(m_style.palette.transition, kThinLine));
    painter->drawLine(QLineF(from, top, from, bottom));
    painter->drawLine(QLineF(to, top, to, bottom));
  }
}

void CornerBands::drawLabels(QCPPainter* painter) const {
  const QCPAxis* time = m_top->axis(QCPAxis::atBottom);
  const double unit = m_style.unit;
  const double badgeTop = m_top->top() - labelHeight() + kBandGap / 2 * unit;
  const QFont bold = m_style.font(kSmallTextHeight, true);
  const QFont plain = m_style.font(kSmallTextHeight);
  double badgesTo = -std::numeric_limits<double>::infinity();
  double anglesTo = badgesTo;
  for (const CornerBand& band : m_bands) {
    const double middle = time->coordToPixel((band.from + band.to) / 2);
    if (band.zone != Zone::Corner || middle < m_top->left() || middle > m_top->left() + m_top->width()) {
      continue;
    }
    const QString number = QString::number(band.corner);
    const double width =
        std::max(kBandBadgeHeight * unit, QFontMetricsF(bold).horizontalAdvance(number) + kBandBadgeHeight / 2 * unit);
    if (middle - width / 2 < badgesTo) {
      continue;
    }
    const QRectF badge(middle - width / 2, badgeTop, width, kBandBadgeHeight * unit);
    const bool selected = band.corner == m_selected;
    painter->setPen(m_style.pen(m_style.palette.ink, kLine));
    painter->setBrush(selected ? m_style.palette.ink : m_style.palette.paper);
    painter->drawRoundedRect(badge, badge.height() / 2, badge.height() / 2);
    painter->setPen(selected ? m_style.palette.paper : m_style.palette.ink);
    painter->setFont(bold);
    painter->drawText(badge, Qt::AlignCenter | Qt::TextDontClip, number);
    badgesTo = badge.right() + kBandGap * unit;

    const auto corner = std::find_if(m_corners.begin(), m_corners.end(), [&](const ProfileLimits::Corner& candidate) {
      return candidate.id == band.corner;
    });
    if (corner == m_corners.end()) {
      continue;
    }
    const QString angle = angleText(corner->angle, m_style.locale);
    const double half = QFontMetricsF(plain).horizontalAdvance(angle) / 2;
    if (middle - half >= anglesTo) {
      painter->setPen(m_style.palette.ink);
      painter->setFont(plain);
      painter->drawText(QRectF(middle - half, badge.bottom(), 2 * half, kBandAngleHeight * unit),
                        Qt::AlignCenter | Qt::TextDontClip, angle);
      anglesTo = middle + half + kBandGap * unit;
    }
  }
}

} // namespace arris::ui
