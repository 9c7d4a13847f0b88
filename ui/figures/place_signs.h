#pragma once

#include "ui/figures/drawing.h"
#include "ui/figures/style.h"

#include <QPointF>
#include <QRectF>

#include <vector>

class QPainter;

namespace arris::ui {

/// A sign at a place of the drawing where something was found or repaired.
struct PlaceSign {
  QPointF place;                               ///< device units
  base::Severity worst = base::Severity::Note; ///< of all that it stands for
  int count = 1;                               ///< findings that lie so near that one sign stands for them
};

/// Signs for the problems and repairs of a drawing whose places lie inside `frame`, the worst first. Findings too near
/// to each other share a sign, and so many more the more of them there are: hundreds never hide the drawing. Grows as
/// n.
[[nodiscard]] std::vector<PlaceSign> placeSigns(const Drawing& drawing, const QTransform& toDevice, const QRectF& frame,
                                                const FigureStyle& style);

/// The worst on top; a number beside a sign says how many findings it stands for.
void paintSigns(QPainter& painter, const std::vector<PlaceSign>& signs, const FigureStyle& style);

} // namespace arris::ui
