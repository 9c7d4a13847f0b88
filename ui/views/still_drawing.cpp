#include "ui/views/still_drawing.h"

#include "core/base/window_thread.h"
#include "ui/figures/polyline.h"

#include <algorithm>

namespace arris::ui {
namespace {

constexpr std::size_t kCurvesAtOnce = 4000;
constexpr double kGroundLine = 5; // px
constexpr double kGroundTolerance = 0.3;
constexpr int kGroundPoints = 100; // of the segment that the wheel is on

std::shared_ptr<const ScaledLines> linesFor(const StillRequest& request) {
  const QTransform& now = request.toView;
  if (request.lines && request.lines->toView.m11() == now.m11() && request.lines->toView.m22() == now.m22()) {
    return request.lines;
  }
  return std::make_shared<const ScaledLines>(ScaledLines{flattened(request.plan->drawing, now, request.style), now});
}

} // namespace

bool isPaintedAtOnce(const Plan& plan) {
  std::size_t curves = plan.job.track.size();
  for (const Trace& trace : plan.drawing.traces) {
    curves += trace.curves.size();
  }
  return curves <= kCurvesAtOnce;
}

StillDrawing paintStill(const StillRequest& request) {
  if (!isPaintedAtOnce(*request.plan)) {
    base::takesLong("paintStill");
  }
  StillDrawing still{request.plan, request.selected, request.toView, request.frame, {}, {}, 0, linesFor(request)};
  still.picture = QImage((request.frame.size() * request.pixelRatio).toSize(), QImage::Format_RGB32);
  still.picture.setDevicePixelRatio(request.pixelRatio);
  still.picture.fill(request.style.palette.paper);
  QPainter painter(&still.picture);
  painter.setRenderHints(request.hints);
  painter.translate(-request.frame.topLeft());
  const Drawing& drawing = request.plan->drawing;
  const QTransform& then = still.lines->toView;
  const QPointF moved(request.toView.dx() - then.dx(), request.toView.dy() - then.dy());
  paintDrawing(painter, drawing, still.lines->lines, moved, request.toView, request.frame, request.style);
  still.labels = placeCornerLabels(drawing, request.toView, request.frame, request.style);
  paintCornerLabels(painter, still.labels, request.selected, request.style);
  for (; still.groundTo < request.groundTo; ++still.groundTo) {
    paintGround(painter, *request.plan, request.style, request.toView, still.groundTo);
  }
  return still;
}

void paintGround(QPainter& painter, const Plan& plan, const FigureStyle& style, const QTransform& toView, int segment,
                 std::optional<double> lambda) {
  const motion::Segment& way = plan.job.track[static_cast<std::size_t>(segment)];
  if (!motion::isAlongContour(way.move)) {
    return;
  }
  QPolygonF ground;
  if (lambda) {
    const double end = std::clamp(*lambda, 0.0, motion::parameterLength(way));
    for (int i = 0; i <= kGroundPoints; ++i) {
      ground << toView.map(toQt(motion::evaluate(way, end * i / kGroundPoints).point.head<2>()));
    }
  } else {
    ground = flattened({motion::curveOf(way)}, toView, kGroundTolerance);
  }
  painter.setPen(QPen(style.palette.lead, kGroundLine, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPolyline(ground);
}

} // namespace arris::ui
