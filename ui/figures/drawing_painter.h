#pragma once

#include "ui/figures/drawing.h"
#include "ui/figures/style.h"

#include <QRectF>

class QPainter;

namespace arris::ui {

/// Paints a drawing on any painter: the printed preview and the view of the window. Sizes of text and lines do not
/// change with the scale; what lies outside `frame` is left out (not only hidden: SVG has no clipping).
void paintDrawing(QPainter& painter, const Drawing& drawing, const QTransform& toDevice, const QRectF& frame,
                  const FigureStyle& style);

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
