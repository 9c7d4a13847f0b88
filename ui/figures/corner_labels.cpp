#include "ui/figures/corner_labels.h"

#include "core/base/numbers.h"
#include "ui/figures/one_per_cell.h"
#include "ui/figures/place_signs.h"
#include "ui/figures/polyline.h"
#include "ui/text/quantities.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace arris::ui {
namespace {

// In units of figures.
constexpr double kBadgeHeight = 42;
constexpr double kGap = 10;
constexpr double kObstacleFlatness = 3;
constexpr double kMarkRoom = 22;

// With more corners than this in the frame, numbers stand at their corners or not at all, and without angles.
constexpr std::ptrdiff_t kCrowd = 60;

// What labels must keep clear of.
struct Obstacles {
  std::vector<QPolygonF> lines; // may be covered if nothing else helps
  std::vector<QRectF> boxes;    // never

  [[nodiscard]] bool covered(const QRectF& box) const {
    return std::any_of(boxes.begin(), boxes.end(), [&](const QRectF& other) { return other.intersects(box); });
  }

  [[nodiscard]] int linesThrough(const QRectF& box) const {
    int count = 0;
    for (const QPolygonF& line : lines) {
      if (line.boundingRect().adjusted(-1, -1, 1, 1).intersects(box)) {
        count += static_cast<int>(clipped(line, box).size());
      }
    }
    return count;
  }
};

QRectF around(const QPointF& center, double half) {
  return {center.x() - half, center.y() - half, 2 * half, 2 * half};
}

Obstacles obstaclesOf(const Drawing& drawing, const QTransform& toDevice, const QRectF& frame,
                      const FigureStyle& style) {
  Obstacles result;
  for (const Trace& trace : drawing.traces) {
    if (trace.kind == TraceKind::Rapid) {
      continue;
    }
    for (const Stretch& run : clipped(flattened(trace.curves, toDevice, kObstacleFlatness * style.unit), frame)) {
      // In short pieces, so that most can be passed over by their boxes.
      for (qsizetype i = 0; i + 1 < run.points.size(); i += 8) {
        result.lines.emplace_back(run.points.mid(i, 9));
      }
    }
  }
  const double room = kMarkRoom * style.unit;
  for (const PlaceSign& sign : placeSigns(drawing, toDevice, frame, style)) {
    result.boxes.push_back(around(sign.place, room));
  }
  for (const PathMark& start : drawing.starts) {
    result.boxes.push_back(around(toDevice.map(toQt(start.place)), room));
  }
  return result;
}

CornerLabel labelOf(const CornerMark& mark, const QPointF& anchor, bool crowded, const FigureStyle& style) {
  const double height = kBadgeHeight * style.unit;
  const QFontMetricsF number(style.font(kSmallTextHeight, true));
  const QFontMetricsF text(style.font(kTextHeight));
  CornerLabel label{mark.id, anchor, {}, {}, crowded ? QString() : angleText(mark.angle, style.locale)};
  label.badge =
      QRectF(0, 0, std::max(height, number.horizontalAdvance(QString::number(mark.id)) + 0.5 * height), height);
  label.box = label.badge;
  if (!crowded) {
    label.box.adjust(0, 0, text.horizontalAdvance(label.angle) + 0.25 * height, 0);
  }
  return label;
}

// The badge stands on the side of the corner, so that the line between them does not run through the angle.
void moveTo(CornerLabel& label, const QPointF& center) {
  label.box.moveCenter(center);
  const bool leftOfCorner = center.x() < label.anchor.x() - label.badge.width() / 4;
  label.badge.moveTopLeft(leftOfCorner ? QPointF(label.box.right() - label.badge.width(), label.box.top())
                                       : label.box.topLeft());
}

// The distance from the middle of a box to its edge in a direction.
double reach(const QRectF& box, const QPointF& direction) {
  const double toSide = std::abs(direction.x()) > 0 ? box.width() / 2 / std::abs(direction.x()) : 1e9;
  const double toTop = std::abs(direction.y()) > 0 ? box.height() / 2 / std::abs(direction.y()) : 1e9;
  return std::min(toSide, toTop);
}

// Between corner and wheel path where there is room, else beyond the path, else inside the glass; straight out first,
// then turned to either side. Among a crowd only what is next to the corner.
std::vector<QPointF> candidates(const CornerMark& mark, const CornerLabel& label, const QTransform& toDevice,
                                bool crowded, const FigureStyle& style) {
  const auto steps = [crowded](std::vector<double> all) { return crowded ? std::vector{all.front()} : all; };
  const double scale = std::hypot(toDevice.m11(), toDevice.m12());
  const double free = mark.clearance * scale;
  const double gap = kGap * style.unit;
  const QPointF origin = toDevice.map(QPointF(0, 0));
  const QPointF out = (toDevice.map(toQt(mark.outwards)) - origin) / scale;
  std::vector<QPointF> result;
  const auto turned = [&](double degrees) {
    const double angle = base::radians(degrees);
    return QPointF(out.x() * std::cos(angle) - out.y() * std::sin(angle),
                   out.x() * std::sin(angle) + out.y() * std::cos(angle));
  };
  for (const double degrees : {0.0, 35.0, -35.0}) {
    const QPointF direction = turned(degrees);
    if (free > 2 * reach(label.box, direction) + 4 * gap) {
      result.push_back(label.anchor + free / 2 * direction);
    }
  }
  for (const double further : steps({2.0, 8.0, 14.0})) {
    for (const double degrees : {0.0, 35.0, -35.0, 70.0, -70.0}) {
      const QPointF direction = turned(degrees);
      result.push_back(label.anchor + (free + reach(label.box, direction) + further * gap) * direction);
    }
  }
  for (const double further : steps({3.0, 9.0})) {
    for (const double degrees : {180.0, 150.0, 210.0}) {
      const QPointF direction = turned(degrees);
      result.push_back(label.anchor + (reach(label.box, direction) + further * gap) * direction);
    }
  }
  return result;
}

std::optional<CornerLabel> placed(const CornerMark& mark, CornerLabel label, const Obstacles& obstacles,
                                  const QTransform& toDevice, const QRectF& frame, bool crowded,
                                  const FigureStyle& style) {
  std::optional<CornerLabel> best;
  int fewest = 0;
  for (const QPointF& center : candidates(mark, label, toDevice, crowded, style)) {
    moveTo(label, center);
    if (!frame.contains(label.box) || obstacles.covered(label.box)) {
      continue;
    }
    const int crossed = obstacles.linesThrough(label.box);
    if (!best || crossed < fewest) {
      best = label;
      fewest = crossed;
    }
    if (crossed == 0) {
      break;
    }
  }
  return best;
}

} // namespace

std::vector<CornerLabel> placeCornerLabels(const Drawing& drawing, const QTransform& toDevice, const QRectF& frame,
                                           const FigureStyle& style) {
  Obstacles obstacles = obstaclesOf(drawing, toDevice, frame, style);
  const auto shown = std::count_if(drawing.corners.begin(), drawing.corners.end(),
                                   [&](const CornerMark& mark) { return frame.contains(toDevice.map(toQt(mark.s))); });
  const bool crowded = shown > kCrowd;
  std::vector<CornerLabel> result;
  OnePerCell places(kBadgeHeight / 2 * style.unit);
  for (const CornerMark& mark : drawing.corners) {
    const QPointF anchor = toDevice.map(toQt(mark.s));
    if (crowded && (!frame.contains(anchor) || !places.take(anchor))) {
      continue;
    }
    const auto label = placed(mark, labelOf(mark, anchor, crowded, style), obstacles, toDevice, frame, crowded, style);
    if (label) {
      const double gap = kGap / 2 * style.unit;
      obstacles.boxes.push_back(label->box.adjusted(-gap, -gap, gap, gap));
      result.push_back(*label);
    }
  }
  return result;
}

void paintCornerLabels(QPainter& painter, const std::vector<CornerLabel>& labels, int selected,
                       const FigureStyle& style) {
  const Palette& palette = style.palette;
  painter.setPen(style.pen(palette.faint, kThinLine));
  for (const CornerLabel& label : labels) {
    painter.drawLine(label.anchor, label.badge.center());
  }
  for (const CornerLabel& label : labels) {
    const bool isSelected = label.corner == selected;
    const double radius = label.badge.height() / 2;
    painter.setPen(style.pen(palette.ink, kLine));
    painter.setBrush(isSelected ? palette.ink : palette.paper);
    painter.drawRoundedRect(label.badge, radius, radius);
    painter.setPen(isSelected ? palette.paper : palette.ink);
    painter.setFont(style.font(kSmallTextHeight, true));
    painter.drawText(label.badge, Qt::AlignCenter | Qt::TextDontClip, QString::number(label.corner));
    painter.setPen(palette.ink);
    painter.setFont(style.font(kTextHeight, isSelected));
    const bool badgeFirst = label.badge.left() <= label.box.left();
    painter.drawText(label.box.adjusted(badgeFirst ? label.badge.width() + 0.25 * radius : 0, 0,
                                        badgeFirst ? 0 : -label.badge.width() - 0.25 * radius, 0),
                     static_cast<int>(badgeFirst ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter |
                         Qt::TextDontClip,
                     label.angle);
  }
}

} // namespace arris::ui
