#include "ui/figures/drawing_painter.h"

#include "core/base/numbers.h"
#include "ui/figures/one_per_cell.h"
#include "ui/figures/place_signs.h"
#include "ui/figures/polyline.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace arris::ui {
namespace {

// In units of figures.
constexpr double kArrowSpacing = 420;
constexpr double kArrowLength = 24;
constexpr double kArrowHalfWidth = 9;
constexpr double kSpeedMarkHalf = 14;
constexpr double kUpRadius = 8;
constexpr double kStopHalf = 6;
constexpr double kSignSize = 17;
constexpr double kFlatness = 0.5;

QPointF unitAlong(const QPointF& way) {
  const double length = std::hypot(way.x(), way.y());
  return length > 0 ? way / length : QPointF(1, 0);
}

QPolygonF arrowHead(const QPointF& tip, const QPointF& along, double unit) {
  const QPointF across(-along.y(), along.x());
  const QPointF back = tip - kArrowLength * unit * along;
  return {tip, back + kArrowHalfWidth * unit * across, back - kArrowHalfWidth * unit * across};
}

QPointF mapDirection(const QTransform& toDevice, const geometry::Vector& direction) {
  return unitAlong(toDevice.map(toQt(direction)) - toDevice.map(QPointF(0, 0)));
}

int order(TraceKind kind) { // what lies on top of what
  constexpr std::array kOrder{TraceKind::Rapid, TraceKind::Contour, TraceKind::Loose,     TraceKind::Path,
                              TraceKind::Lead,  TraceKind::Roll,    TraceKind::Transition};
  return static_cast<int>(std::find(kOrder.begin(), kOrder.end(), kind) - kOrder.begin());
}

class DrawingPainter {
public:
  DrawingPainter(QPainter& painter, const Drawing& drawing, const FlatDrawing& lines, const QPointF& moved,
                 const QTransform& toDevice, const QRectF& frame, const FigureStyle& style)
      : m_painter(painter), m_drawing(drawing), m_lines(lines), m_moved(moved), m_toDevice(toDevice), m_frame(frame),
        m_style(style) {}

  void paintGlass();
  void paintTravel();
  void paintTraces();
  void paintMarks();
  void paintFindings();

private:
  void paintTrace(TraceKind kind, const QPolygonF& line);
  void paintArrows(const QPolygonF& path);
  [[nodiscard]] QRectF lineFrame(double margin) const;
  void shift(int sign);
  void paintWheel(const PathMark& start);
  [[nodiscard]] bool hidesStart(const QPointF& place) const;

  QPainter& m_painter;
  const Drawing& m_drawing;
  const FlatDrawing& m_lines;
  QPointF m_moved; // of the lines since they were flattened
  QTransform m_toDevice;
  QRectF m_frame;
  const FigureStyle& m_style;
};

// The frame where the lines lie, and a margin round it.
QRectF DrawingPainter::lineFrame(double margin) const {
  return m_frame.translated(-m_moved).adjusted(-margin, -margin, margin, margin);
}

// Not at all where nothing moved: it would show in what an SVG file says.
void DrawingPainter::shift(int sign) {
  if (!m_moved.isNull()) {
    m_painter.translate(sign * m_moved);
  }
}

void DrawingPainter::paintGlass() {
  QPainterPath glass;
  glass.setFillRule(Qt::OddEvenFill);
  for (const QPolygonF& outline : m_lines.contours) {
    glass.addPolygon(clippedArea(outline, lineFrame(1)));
    glass.closeSubpath();
  }
  shift(1);
  m_painter.fillPath(glass, m_style.palette.glass);
  shift(-1);
}

void DrawingPainter::paintTravel() {
  if (!m_drawing.travel) {
    return;
  }
  const QPolygonF edge(m_toDevice.mapRect(QRectF(toQt(m_drawing.travel->min()), toQt(m_drawing.travel->max()))));
  m_painter.setPen(travelPen(m_style));
  for (const Stretch& run : clipped(edge, m_frame)) {
    m_painter.drawPolyline(run.points);
  }
}

void DrawingPainter::paintTraces() {
  const auto kindOf = [this](std::size_t trace) { return m_drawing.traces[trace].kind; };
  std::vector<std::size_t> sorted(m_drawing.traces.size());
  std::iota(sorted.begin(), sorted.end(), std::size_t{0});
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](std::size_t a, std::size_t b) { return order(kindOf(a)) < order(kindOf(b)); });
  shift(1);
  for (const std::size_t trace : sorted) {
    paintTrace(kindOf(trace), m_lines.traces[trace]);
  }
  shift(-1);
}

void DrawingPainter::paintTrace(TraceKind kind, const QPolygonF& line) {
  QPen pen = penOf(kind, m_style);
  m_painter.setBrush(Qt::NoBrush);
  for (const Stretch& run : clipped(line, lineFrame(pen.widthF()))) {
    if (pen.style() == Qt::CustomDashLine) {
      double period = 0;
      for (const double dash : pen.dashPattern()) {
        period += dash;
      }
      pen.setDashOffset(std::fmod(run.startLength / pen.widthF(), period));
    }
    m_painter.setPen(pen);
    m_painter.drawPolyline(run.points);
  }
  if (kind == TraceKind::Path) {
    paintArrows(line);
  }
}

void DrawingPainter::paintArrows(const QPolygonF& path) {
  const double spacing = kArrowSpacing * m_style.unit;
  m_painter.setPen(Qt::NoPen);
  m_painter.setBrush(m_style.palette.path);
  for (const Stretch& run : clipped(path, lineFrame(0))) {
    double travelled = run.startLength;
    double next = (std::ceil(travelled / spacing - 0.5) + 0.5) * spacing;
    for (qsizetype i = 1; i < run.points.size(); ++i) {
      const QPointF way = run.points[i] - run.points[i - 1];
      const double length = std::hypot(way.x(), way.y());
      for (; next < travelled + length; next += spacing) {
        const QPointF tip = run.points[i - 1] + (next - travelled) / length * way;
        m_painter.drawPolygon(arrowHead(tip, unitAlong(way), m_style.unit));
      }
      travelled += length;
    }
  }
}

void DrawingPainter::paintWheel(const PathMark& start) {
  const double radius = m_drawing.wheelRadius * std::hypot(m_toDevice.m11(), m_toDevice.m12());
  const QPointF center = m_toDevice.map(toQt(start.place));
  QPen pen = m_style.pen(m_style.palette.faint, kThinLine);
  QPolygonF rim;
  const int points = std::clamp(static_cast<int>(radius), 60, 2000);
  for (int i = 0; i <= points; ++i) {
    const double angle = 2 * base::kPi * i / points;
    rim.append(center + radius * QPointF(std::cos(angle), std::sin(angle)));
  }
  m_painter.setPen(pen);
  m_painter.setBrush(Qt::NoBrush);
  for (const Stretch& run : clipped(rim, m_frame)) {
    m_painter.drawPolyline(run.points);
  }
}

void DrawingPainter::paintMarks() {
  OnePerCell places(kSpeedMarkHalf / 4 * m_style.unit);
  for (const PathMark& mark : m_drawing.speedMarks) {
    const QPointF place = m_toDevice.map(toQt(mark.place));
    if (m_frame.contains(place) && places.take(place)) {
      paintSpeedMark(m_painter, place, mapDirection(m_toDevice, mark.direction), m_style);
    }
  }
  for (const PathMark& start : m_drawing.starts) {
    paintWheel(start);
    const QPointF place = m_toDevice.map(toQt(start.place));
    if (m_frame.contains(place)) {
      paintStart(m_painter, place, mapDirection(m_toDevice, start.direction), m_style);
    }
  }
  for (const geometry::Point& up : m_drawing.ups) {
    const QPointF place = m_toDevice.map(toQt(up));
    if (m_frame.contains(place) && !hidesStart(place)) {
      paintUp(m_painter, place, m_style);
    }
  }
  OnePerCell stops(kStopHalf / 2 * m_style.unit);
  for (const geometry::Point& stop : m_drawing.stops) {
    const QPointF place = m_toDevice.map(toQt(stop));
    if (m_frame.contains(place) && stops.take(place)) {
      paintStop(m_painter, place, m_style);
    }
  }
}

// Drawn small, the leads would vanish under their signs.
bool DrawingPainter::hidesStart(const QPointF& place) const {
  return std::any_of(m_drawing.starts.begin(), m_drawing.starts.end(), [&](const PathMark& start) {
    const QPointF way = m_toDevice.map(toQt(start.place)) - place;
    return std::hypot(way.x(), way.y()) < 2 * kArrowLength * m_style.unit;
  });
}

void DrawingPainter::paintFindings() {
  paintSigns(m_painter, placeSigns(m_drawing, m_toDevice, m_frame, m_style), m_style);
}

} // namespace

QPen penOf(TraceKind kind, const FigureStyle& style) {
  const Palette& palette = style.palette;
  const auto dashed = [&](QPen pen, const QList<qreal>& pattern) {
    pen.setDashPattern(pattern);
    return pen;
  };
  switch (kind) {
  case TraceKind::Contour:
    return style.pen(palette.contour, 3);
  case TraceKind::Loose:
    return style.pen(palette.loose, kThickLine);
  case TraceKind::Path:
    return dashed(style.pen(palette.path, kLine), {8, 4});
  case TraceKind::Lead:
    return dashed(style.pen(palette.lead, 3), {7, 3, 1.5, 3});
  case TraceKind::Transition:
    return style.pen(palette.transition, kThickLine);
  case TraceKind::Roll:
    return dashed(style.pen(palette.roll, kThickLine), {1.5, 1});
  case TraceKind::Rapid:
    return dashed(style.pen(palette.rapid, kThinLine), {2, 4});
  }
  return {};
}

QPen travelPen(const FigureStyle& style) {
  QPen pen = style.pen(style.palette.faint, kLine);
  pen.setDashPattern({12, 3, 2, 3, 2, 3});
  return pen;
}

void paintSign(QPainter& painter, const QPointF& center, base::Severity severity, const FigureStyle& style) {
  const double size = kSignSize * style.unit;
  const bool note = severity == base::Severity::Note;
  const QColor color = severity == base::Severity::Error     ? style.palette.error
                       : severity == base::Severity::Warning ? style.palette.warning
                                                             : style.palette.faint;
  painter.save();
  painter.setPen(style.pen(style.palette.paper, 2));
  painter.setBrush(color);
  if (note) {
    painter.drawEllipse(center, size, size);
  } else {
    painter.drawPolygon(QPolygonF{center + QPointF(0, -1.15 * size), center + QPointF(1.15 * size, 0.85 * size),
                                  center + QPointF(-1.15 * size, 0.85 * size)});
  }
  painter.setPen(style.palette.paper);
  painter.setFont(style.font(kSmallTextHeight, true));
  const QPointF shift(0, note ? 0 : 0.12 * size);
  painter.drawText(QRectF(center + shift - QPointF(2 * size, 2 * size), QSizeF(4 * size, 4 * size)), Qt::AlignCenter,
                   note ? QStringLiteral("i") : QStringLiteral("!"));
  painter.restore();
}

void paintStart(QPainter& painter, const QPointF& place, const QPointF& along, const FigureStyle& style) {
  painter.setPen(style.pen(style.palette.lead, kLine));
  painter.setBrush(style.palette.paper);
  painter.drawPolygon(arrowHead(place + 0.65 * kArrowLength * style.unit * along, along, 1.3 * style.unit));
}

void paintUp(QPainter& painter, const QPointF& place, const FigureStyle& style) {
  painter.setPen(style.pen(style.palette.lead, kLine));
  painter.setBrush(style.palette.paper);
  painter.drawEllipse(place, kUpRadius * style.unit, kUpRadius * style.unit);
}

void paintStop(QPainter& painter, const QPointF& place, const FigureStyle& style) {
  const double half = kStopHalf * style.unit;
  painter.setPen(style.pen(style.palette.path, kLine));
  painter.setBrush(style.palette.paper);
  painter.drawRect(QRectF(place.x() - half, place.y() - half, 2 * half, 2 * half));
}

void paintSpeedMark(QPainter& painter, const QPointF& place, const QPointF& along, const FigureStyle& style) {
  const QPointF across(-along.y() * kSpeedMarkHalf * style.unit, along.x() * kSpeedMarkHalf * style.unit);
  painter.setPen(style.pen(style.palette.path, kLine));
  painter.drawLine(place - across, place + across);
}

FlatDrawing flattened(const Drawing& drawing, const QTransform& toDevice, const FigureStyle& style) {
  FlatDrawing lines;
  const double tolerance = kFlatness * style.unit;
  for (const pattern::Contour& contour : drawing.contours) {
    lines.contours.push_back(flattened(contour.curves, toDevice, tolerance));
  }
  for (const Trace& trace : drawing.traces) {
    lines.traces.push_back(flattened(trace.curves, toDevice, tolerance));
  }
  return lines;
}

void paintDrawing(QPainter& painter, const Drawing& drawing, const QTransform& toDevice, const QRectF& frame,
                  const FigureStyle& style) {
  paintDrawing(painter, drawing, flattened(drawing, toDevice, style), {}, toDevice, frame, style);
}

void paintDrawing(QPainter& painter, const Drawing& drawing, const FlatDrawing& lines, const QPointF& moved,
                  const QTransform& toDevice, const QRectF& frame, const FigureStyle& style) {
  DrawingPainter parts(painter, drawing, lines, moved, toDevice, frame, style);
  parts.paintGlass();
  parts.paintTravel();
  parts.paintTraces();
  parts.paintMarks();
  parts.paintFindings();
}

} // namespace arris::ui
