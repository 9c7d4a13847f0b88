#pragma once

#include "ui/figures/drawing.h"
#include "ui/figures/style.h"

#include <QString>

#include <functional>
#include <vector>

class QPainter;

namespace arris::ui {

/// A line of the legend: what a sign of the drawing means, and the sign itself.
struct LegendEntry {
  QString words;
  /// Paints the sign from `left` on, `kLegendSample` units long, on the height of `left`.
  std::function<void(QPainter& painter, const QPointF& left, const FigureStyle& style)> sample;
};

inline constexpr double kLegendSample = 95; ///< units of figures

/// Of what the drawing has, and of nothing else.
[[nodiscard]] std::vector<LegendEntry> legendOf(const Drawing& drawing);

} // namespace arris::ui
