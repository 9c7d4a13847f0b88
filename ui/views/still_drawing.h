#pragma once

#include "ui/figures/corner_labels.h"
#include "ui/figures/drawing_painter.h"
#include "ui/presenters/planner.h"

#include <QImage>
#include <QPainter>

#include <memory>
#include <optional>
#include <vector>

namespace arris::ui {

/// The lines of a drawing for one scale; a pan takes them along.
struct ScaledLines {
  FlatDrawing lines;
  QTransform toView; ///< the view when they were flattened
};

/// What a view wants to see of a plan.
struct StillRequest {
  PlanPointer plan;
  int selected = 0; ///< corner whose number stands out
  QTransform toView;
  QRectF frame; ///< of the picture, in the view
  double pixelRatio = 1;
  QPainter::RenderHints hints;
  FigureStyle style;
  int groundTo = 0;                         ///< segments of the track that have been ground
  std::shared_ptr<const ScaledLines> lines; ///< of an earlier picture, if any
};

/// A plan as a picture: all of a drawing that stays as it is while the wheel moves over it.
struct StillDrawing {
  PlanPointer plan; ///< null: nothing is painted yet
  int selected = 0;
  QTransform toView;
  QRectF frame;
  QImage picture;
  std::vector<CornerLabel> labels; ///< in the view
  int groundTo = 0;
  std::shared_ptr<const ScaledLines> lines;
};

/// Whether painting it takes less than a moment, so that nobody needs to wait for it in another thread.
[[nodiscard]] bool isPaintedAtOnce(const Plan& plan);

/// In any thread; what is not painted at once takes long.
[[nodiscard]] StillDrawing paintStill(const StillRequest& request);

/// A segment of the track, up to `lambda` (mm) or to its end, where it goes along the glass.
void paintGround(QPainter& painter, const Plan& plan, const FigureStyle& style, const QTransform& toView, int segment,
                 std::optional<double> lambda = std::nullopt);

} // namespace arris::ui
