#include "ui/figures/drawing_legend.h"

#include "ui/figures/drawing_painter.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <array>
#include <utility>

namespace arris::ui {
namespace {

QString words(TraceKind kind) {
  switch (kind) {
  case TraceKind::Contour:
    return QCoreApplication::translate("Legend", "Finished contour");
  case TraceKind::Loose:
    return QCoreApplication::translate("Legend", "Not in a contour");
  case TraceKind::Path:
    return QCoreApplication::translate("Legend", "Wheel path");
  case TraceKind::Transition:
    return QCoreApplication::translate("Legend", "Corner transition");
  case TraceKind::Roll:
    return QCoreApplication::translate("Legend", "Roll or arc at a corner");
  case TraceKind::Lead:
    return QCoreApplication::translate("Legend", "Lead-in, lead-out");
  case TraceKind::Rapid:
    return QCoreApplication::translate("Legend", "Rapid above the glass");
  }
  return {};
}

QPointF middle(const QPointF& left, const FigureStyle& style) {
  return left + QPointF(kLegendSample / 2 * style.unit, 0);
}

void paintLine(QPainter& painter, const QPointF& left, const QPen& pen, const FigureStyle& style) {
  painter.setPen(pen);
  painter.drawLine(left, left + QPointF(kLegendSample * style.unit, 0));
}

LegendEntry lineEntry(TraceKind kind) {
  return {words(kind), [kind](QPainter& painter, const QPointF& left, const FigureStyle& style) {
            paintLine(painter, left, penOf(kind, style), style);
          }};
}

LegendEntry startEntry() {
  return {QCoreApplication::translate("Legend", "Start"),
          [](QPainter& painter, const QPointF& left, const FigureStyle& style) {
            paintStart(painter, middle(left, style), QPointF(1, 0), style);
          }};
}

LegendEntry upEntry() {
  return {QCoreApplication::translate("Legend", "Wheel down, up"),
          [](QPainter& painter, const QPointF& left, const FigureStyle& style) {
            paintUp(painter, middle(left, style), style);
          }};
}

LegendEntry stopEntry() {
  return {QCoreApplication::translate("Legend", "Stop in a concave corner"),
          [](QPainter& painter, const QPointF& left, const FigureStyle& style) {
            paintLine(painter, left, penOf(TraceKind::Path, style), style);
            paintStop(painter, middle(left, style), style);
          }};
}

QString words(base::Severity severity) {
  switch (severity) {
  case base::Severity::Error:
    return QCoreApplication::translate("Legend", "Error");
  case base::Severity::Warning:
    return QCoreApplication::translate("Legend", "Warning");
  case base::Severity::Note:
    return QCoreApplication::translate("Legend", "Note, repair");
  }
  return {};
}

LegendEntry signEntry(base::Severity severity) {
  return {words(severity), [severity](QPainter& painter, const QPointF& left, const FigureStyle& style) {
            paintSign(painter, middle(left, style), severity, style);
          }};
}

bool hasPlaceFor(const Drawing& drawing, base::Severity severity) {
  const auto fits = [severity](const base::Problem& problem) {
    return problem.where && base::severityOf(problem) == severity;
  };
  return std::any_of(drawing.problems.begin(), drawing.problems.end(), fits) ||
         std::any_of(drawing.repairs.begin(), drawing.repairs.end(), fits);
}

LegendEntry travelEntry() {
  return {QCoreApplication::translate("Legend", "Travel of the machine"),
          [](QPainter& painter, const QPointF& left, const FigureStyle& style) {
            paintLine(painter, left, travelPen(style), style);
          }};
}

LegendEntry speedEntry() {
  return {QCoreApplication::translate("Legend", "Slower between these"),
          [](QPainter& painter, const QPointF& left, const FigureStyle& style) {
            paintLine(painter, left, penOf(TraceKind::Path, style), style);
            paintSpeedMark(painter, middle(left, style), QPointF(1, 0), style);
          }};
}

} // namespace

std::vector<LegendEntry> legendOf(const Drawing& drawing) {
  std::vector<LegendEntry> entries;
  for (const TraceKind kind : {TraceKind::Contour, TraceKind::Loose, TraceKind::Path, TraceKind::Transition,
                               TraceKind::Roll, TraceKind::Lead, TraceKind::Rapid}) {
    const bool has = std::any_of(drawing.traces.begin(), drawing.traces.end(),
                                 [kind](const Trace& trace) { return trace.kind == kind; });
    if (has) {
      entries.push_back(lineEntry(kind));
    }
  }
  if (!drawing.starts.empty()) {
    entries.push_back(startEntry());
  }
  if (!drawing.ups.empty()) {
    entries.push_back(upEntry());
  }
  if (!drawing.stops.empty()) {
    entries.push_back(stopEntry());
  }
  if (!drawing.speedMarks.empty()) {
    entries.push_back(speedEntry());
  }
  for (const base::Severity severity : {base::Severity::Error, base::Severity::Warning, base::Severity::Note}) {
    if (hasPlaceFor(drawing, severity)) {
      entries.push_back(signEntry(severity));
    }
  }
  if (drawing.travel) {
    entries.push_back(travelEntry());
  }
  return entries;
}

} // namespace arris::ui
