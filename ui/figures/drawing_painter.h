#pragma once

#include "ui/figures/drawing.h"
#include "ui/figures/style.h"

#include <QPolygonF>
#include <QRectF>

#include <vector>

class QPainter;

namespace arris::ui {

/// Paints a drawing on any painter: the printed preview and the view of the window. Sizes of text and lines do not
/// change with the scale; what lies outside `frame` is left out (not only hidden: SVG has no clipping).
void paintDrawing(QPainter& painter, const Drawing& drawing, const QTransform& toDevice, const QRectF& frame,
                  const FigureStyle& style);

/// The lines of a drawing in the units of a device, flattened: what takes longest of painting, and stays as it is while
/// the drawing is only moved.
struct FlatDrawing {
  std::vector<QPolygonF> contours; ///< by contour
  std::vector<QPolygonF> traces;   ///< by trace
};

[[nodiscard]] FlatDrawing flattened(const Drawing& drawing, const QTransform& toDevice, const FigureStyle& style);

/// The same with lines that were flattened for where `moved` leads back from `toDevice`: so far has the drawing moved
/// since.
void paintDrawing(QPainter& painter, const Drawing& drawing, const FlatDrawing& lines, const QPointF& moved,
                  const QTransform& toDevice, const QRectF& frame, const FigureStyle& style);

/// The pen of each kind of line; the legend uses it too.
[[nodiscard]] QPen penOf(TraceKind kind, const FigureStyle& style);

/// The pen of the box that the wheel's centre can reach.
[[nodiscard]] QPen travelPen(const FigureStyle& style);

// The signs of the drawing, alone, for the legend.

/// A triangle with ! for errors and warnings, a circle with i for notes: the shape tells them apart too.
void paintSign(QPainter& painter, const QPointF& center, base::Severity severity, const FigureStyle& style);

/// Where the wheel comes onto the contour; `along` is the unit direction of travel.
void paintStart(QPainter& painter, const QPointF& place, const QPointF& along, const FigureStyle& style);

/// Where the wheel goes down or comes up.
void paintUp(QPainter& painter, const QPointF& place, const FigureStyle& style);

/// Where the wheel stops in a concave corner.
void paintStop(QPainter& painter, const QPointF& place, const FigureStyle& style);

/// Where braking before a corner begins or accelerating after it ends.
void paintSpeedMark(QPainter& painter, const QPointF& place, const QPointF& along, const FigureStyle& style);

} // namespace arris::ui
