#pragma once

#include "ui/figures/drawing.h"
#include "ui/figures/style.h"

#include <QPointF>
#include <QRectF>
#include <QString>

#include <vector>

class QPainter;

namespace arris::ui {

/// The number of a corner with its angle beside it, in device units.
struct CornerLabel {
  int corner = 0;
  QPointF anchor; ///< the corner of the glass
  QRectF badge;   ///< round the number
  QRectF box;     ///< round badge and angle
  QString angle;
};

/// Places for the numbers of the corners: near the corner, clear of each other and, where there is room, of the lines.
/// A corner for which there is no room inside `frame` gets none.
[[nodiscard]] std::vector<CornerLabel> placeCornerLabels(const Drawing& drawing, const QTransform& toDevice,
                                                         const QRectF& frame, const FigureStyle& style);

/// `selected`: the corner whose number stands out; 0 for none.
void paintCornerLabels(QPainter& painter, const std::vector<CornerLabel>& labels, int selected,
                       const FigureStyle& style);

} // namespace arris::ui
