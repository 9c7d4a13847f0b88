#include "ui/figures/profile_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

// What the curves are held against, and how much of it is in view.

namespace arris::ui {
namespace {

// Values of the right-hand axis nearer than this share of it would stand on each other.
constexpr double kTickRoom = 0.25;

// The distance is shown over at least this share of the wheel radius.
constexpr double kLeastDistanceRange = 0.02;

// An end of the travel is shown where it is nearer to the way than this share of it.
constexpr double kTravelNear = 0.25;

constexpr double kRoom = 0.12; // above and below what is shown, of its size

constexpr double kLeastPositionRange = 1; // mm, of an axis that stands still

bool isPosition(Panel panel) {
  return panel == Panel::PositionX || panel == Panel::PositionY;
}

bool isSymmetric(Panel panel) {
  return panel != Panel::Speed && panel != Panel::Distance && !isPosition(panel);
}

// What the speed or acceleration of a panel is held against.
std::optional<double> limitFor(Panel panel, const ProfileLimits& limits) {
  switch (panel) {
  case Panel::AccelerationX:
    return limits.accelX;
  case Panel::AccelerationY:
    return limits.accelY;
  case Panel::SpeedX:
  case Panel::SpeedY:
  case Panel::Speed:
    return limits.feed;
  case Panel::Distance:
  case Panel::PositionX:
  case Panel::PositionY:
    break;
  }
  return std::nullopt;
}

struct Extremes {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();

  void include(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

// What a curve of straight pieces goes through within these times.
void includeWithin(Extremes& values, const QCPGraphDataContainer& curve, const QCPRange& times) {
  const auto end = curve.findEnd(times.upper);
  for (auto point = curve.findBegin(times.lower); point != end; ++point) {
    if (times.contains(point->key)) {
      values.include(point->value);
    }
    const auto next = point + 1;
    if (next == end || next->key <= point->key) {
      continue;
    }
    for (const double edge : {times.lower, times.upper}) {
      if (point->key < edge && edge < next->key) {
        const double part = (edge - point->key) / (next->key - point->key);
        values.include(point->value + part * (next->value - point->value));
      }
    }
  }
}

// A value of the right-hand axis with the words beside it.
void addTick(QCPAxis* axis, double value, const QString& words) {
  axis->ticker().dynamicCast<QCPAxisTickerText>()->addTick(value, words);
}

} // namespace

// All of the curves, with what they are held against. Of positions only what is in view: see below.
void ProfilePlot::setRange(const PanelParts& panel, const std::vector<ProfileCurves>& profiles,
                           const ProfileLimits& limits) const {
  const Panel kind = panel.kind;
  Extremes values;
  for (const ProfileCurves& curves : profiles) {
    const auto [low, high] = curves.range[static_cast<std::size_t>(kind)];
    if (kind != Panel::Distance || high > 0) {
      values.include(low);
      values.include(high);
    }
  }
  if (kind == Panel::Distance) {
    values.include(limits.wheelRadius.value_or(0));
    for (const ProfileLimits::Corner& corner : limits.corners) {
      values.include(corner.reliefRadius.value_or(limits.wheelRadius.value_or(0)));
    }
  } else {
    const double limit = limitFor(kind, limits).value_or(0);
    values.include(0);
    values.include(limit);
    values.include(isSymmetric(kind) ? -limit : 0);
  }
  if (values.least > values.most) {
    values.least = values.most = 0;
  }
  if (isSymmetric(kind)) {
    values.most = std::max(values.most, -values.least);
    values.least = -values.most;
  }
  if (kind == Panel::Distance) {
    values.most = std::max(values.most, values.least * (1 + kLeastDistanceRange));
  }
  const double room = values.most > values.least ? kRoom * (values.most - values.least) : 1;
  const double below = kind == Panel::Speed ? 0 : room;
  for (const auto side : {QCPAxis::atLeft, QCPAxis::atRight}) {
    panel.rect->axis(side)->setRange(shown(values.least - below), shown(values.most + room));
  }
}

// The way through a corner is small on the table: positions take the room for what is in view, and for an end of the
// travel where it is near.
void ProfilePlot::fitPositions() {
  const QCPRange times = m_panels.front().rect->axis(QCPAxis::atBottom)->range();
  for (const PanelParts& panel : m_panels) {
    if (!isPosition(panel.kind)) {
      continue;
    }
    Extremes values;
    for (const QCPGraph* curve : panel.curves) {
      includeWithin(values, *curve->data(), times);
    }
    const double size = values.most - values.least;
    for (const double end : {0.0, shown(panel.travel.value_or(0))}) {
      if (std::min(std::abs(end - values.least), std::abs(end - values.most)) < kTravelNear * size) {
        values.include(end);
      }
    }
    if (values.least <= values.most) {
      const double shownSize = values.most - values.least;
      const double room = std::max(kRoom * shownSize, (shown(kLeastPositionRange) - shownSize) / 2);
      for (const auto side : {QCPAxis::atLeft, QCPAxis::atRight}) {
        panel.rect->axis(side)->setRange(values.least - room, values.most + room);
      }
    }
  }
}

void ProfilePlot::addLimits(PanelParts& panel, const ProfileLimits& limits) {
  if (panel.kind == Panel::Distance) {
    addReliefLimits(panel, limits);
    return;
  }
  if (isPosition(panel.kind)) {
    addTravelLimits(panel);
    return;
  }
  const bool acceleration = panel.kind == Panel::AccelerationX || panel.kind == Panel::AccelerationY;
  const std::optional<double> limit = limitFor(panel.kind, limits);
  if (!limit) {
    return;
  }
  const QString words = acceleration ? tr("limit %1") : tr("feed %1");
  addLimitLine(panel, *limit, words.arg(m_style.lengthText(*limit, 2)));
  if (isSymmetric(panel.kind)) {
    addLimitLine(panel, -*limit, words.arg(m_style.lengthText(-*limit, 2)));
  }
}

void ProfilePlot::addTravelLimits(PanelParts& panel) {
  if (panel.travel) {
    for (const double at : {0.0, *panel.travel}) {
      addLimitLine(panel, at, tr("travel %1").arg(m_style.lengthText(at, 1)));
    }
  }
}

void ProfilePlot::addLimitLine(PanelParts& panel, double value, const QString& words) {
  QCPGraph* line = addGraph(panel.rect->axis(QCPAxis::atBottom), panel.rect->axis(QCPAxis::atLeft));
  line->setPen(limitPen(m_style));
  const double far = 1e7; // s: beyond any profile
  line->data()->set({{-far, shown(value)}, {far, shown(value)}}, true);
  panel.graphs.push_back(line);
  addTick(panel.rect->axis(QCPAxis::atRight), shown(value), words);
}

// R all along, and R + d of each corner over its band; their values stand together where they are too near.
void ProfilePlot::addReliefLimits(PanelParts& panel, const ProfileLimits& limits) {
  if (!limits.wheelRadius) {
    return;
  }
  const double radius = *limits.wheelRadius;
  const QString atRadius = QStringLiteral("R %1").arg(m_style.lengthText(radius, 3));
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
      const double value = shown(*corner->reliefRadius);
      relief->addData({band.from, band.to, band.to}, {value, value, kLineBreak}, true);
      least = std::min(least, *corner->reliefRadius);
      most = std::max(most, *corner->reliefRadius);
    }
  }
  if (most == 0) {
    return;
  }
  const QString lower = m_style.lengthText(least, 2);
  const QString upper = m_style.lengthText(most, 2);
  const QString atRelief = QStringLiteral("R + d %1").arg(lower == upper ? lower : lower + QStringLiteral("–") + upper);
  QCPAxis* right = panel.rect->axis(QCPAxis::atRight);
  if (shown(least - radius) > kTickRoom * right->range().size()) {
    addTick(right, shown(least), atRelief);
  } else {
    addTick(right, shown(radius), atRelief + QLatin1Char('\n') + atRadius);
  }
}

} // namespace arris::ui
