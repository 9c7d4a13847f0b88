#include "ui/views/drawing_view.h"

#include "ui/figures/drawing_legend.h"

#include <QApplication>
#include <QGestureEvent>
#include <QMouseEvent>
#include <QPinchGesture>
#include <QScrollBar>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace arris::ui {
namespace {

constexpr double kPixelsPerUnit = 0.56; // 27 units of text are 15 px
constexpr double kFitMargin = 64;       // px: room for the corners' numbers
constexpr double kZoomStep = 1.5;
constexpr double kLeastScale = 0.01; // px per mm
constexpr double kMostScale = 2000;
constexpr double kTapReach = 26;    // px
constexpr double kMarkRadius = 20;  // px
constexpr double kCornerRoom = 1.8; // of the widest point of a transition
constexpr double kPlaceRoom = 60;   // mm round a marked place
constexpr double kSceneRoom = 20;   // times the drawing's size can be panned

constexpr int kLegendFromWidth = 700; // px
constexpr int kLegendFromHeight = 420;
constexpr double kLegendRow = 36; // units of figures
constexpr double kLegendWidth = 420;

double distance(const QPointF& a, const QPointF& b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

} // namespace

DrawingView::DrawingView(QWidget* parent) : QGraphicsView(parent), m_style(screenStyle(kPixelsPerUnit)) {
  setScene(new QGraphicsScene(this));
  setViewportUpdateMode(FullViewportUpdate);
  setDragMode(ScrollHandDrag);
  setTransformationAnchor(NoAnchor);
  setResizeAnchor(AnchorViewCenter);
  setRenderHint(QPainter::Antialiasing);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  viewport()->setCursor(Qt::ArrowCursor);
  viewport()->grabGesture(Qt::PinchGesture);
  setAccessibleName(tr("Drawing"));
  setEmptyText(tr("Open a pattern (DXF), or drop one here."));
  setMinimumSize(200, 150);
}

void DrawingView::setPlan(PlanPointer plan) {
  if (plan == m_plan) {
    return;
  }
  const bool another = !m_plan || !plan || m_plan->import->file != plan->import->file;
  m_plan = std::move(plan);
  if (another) {
    m_still = {};
    m_selected = 0;
    m_marked.reset();
  }
  if (m_plan && !m_plan->drawing.box.isEmpty()) {
    const geometry::Box& box = m_plan->drawing.box;
    const QRectF shown(toQt(box.min()), toQt(box.max()));
    const double room = kSceneRoom * std::max({shown.width(), shown.height(), 1.0});
    scene()->setSceneRect(shown.adjusted(-room, -room, room, room));
  }
  if (another || m_fitted) {
    fit();
  }
  viewport()->update();
}

void DrawingView::setEmptyText(const QString& text) {
  m_emptyText = text;
}

void DrawingView::selectCorner(int corner) {
  m_selected = corner;
  m_marked.reset();
  viewport()->update();
}

void DrawingView::zoomToCorner(int corner) {
  if (!m_plan) {
    return;
  }
  for (const CornerMark& mark : m_plan->drawing.corners) {
    if (mark.id == corner) {
      const geometry::Vector room = geometry::Vector::Constant(kCornerRoom * std::max(mark.clearance, 1.0));
      showBox(geometry::Box(mark.s - room, mark.s + room), 0);
      m_fitted = false;
    }
  }
}

void DrawingView::markPlace(const geometry::Point& place) {
  m_marked = place;
  viewport()->update();
}

void DrawingView::zoomToPlace(const geometry::Point& place) {
  const geometry::Vector room = geometry::Vector::Constant(kPlaceRoom);
  m_marked = place;
  showBox(geometry::Box(place - room, place + room), 0);
  m_fitted = false;
}

void DrawingView::fit() {
  m_fitted = true;
  if (m_plan && !m_plan->drawing.box.isEmpty()) {
    showBox(m_plan->drawing.box, kFitMargin);
  }
}

void DrawingView::showBox(const geometry::Box& box, double margin) {
  const double width = std::max(viewport()->width() - 2 * margin, 50.0);
  const double height = std::max(viewport()->height() - 2 * margin, 50.0);
  const geometry::Vector size = box.sizes().cwiseMax(1e-3);
  setScale(std::min(width / size.x(), height / size.y()));
  centerOn(toQt(box.center()));
  viewport()->update();
}

void DrawingView::setScale(double pixelsPerMillimetre) {
  const double scale = std::clamp(pixelsPerMillimetre, kLeastScale, kMostScale);
  setTransform(QTransform::fromScale(scale, -scale));
}

double DrawingView::pixelsPerMillimetre() const {
  return transform().m11();
}

void DrawingView::zoomBy(double factor) {
  const QPointF middle = mapToScene(viewport()->rect().center());
  setScale(pixelsPerMillimetre() * factor);
  centerOn(middle);
  m_fitted = false;
  viewport()->update();
}

void DrawingView::zoomIn() {
  zoomBy(kZoomStep);
}

void DrawingView::zoomOut() {
  zoomBy(1 / kZoomStep);
}

QRectF DrawingView::frame() const {
  return QRectF(viewport()->rect());
}

void DrawingView::drawBackground(QPainter* painter, const QRectF& /*rect*/) {
  painter->save();
  painter->resetTransform();
  painter->fillRect(frame(), m_style.palette.paper);
  if (m_plan) {
    const QTransform toView = viewportTransform();
    paintOverStill(*painter);
    if (m_marked) {
      painter->setPen(QPen(m_style.palette.ink, 3));
      painter->setBrush(Qt::NoBrush);
      painter->drawEllipse(toView.map(toQt(*m_marked)), kMarkRadius, kMarkRadius);
    }
  } else {
    painter->setPen(m_style.palette.faint);
    painter->setFont(font());
    painter->drawText(frame(), Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
  }
  painter->restore();
}

// Of what is to be seen: glass, path and the numbers of the corners.
bool DrawingView::isDrawnOn(const QRectF& place) const {
  const geometry::Box& box = m_plan->drawing.box;
  const QRectF drawn = viewportTransform().mapRect(QRectF(toQt(box.min()), toQt(box.max())));
  const std::vector<CornerLabel> now = labels();
  return drawn.intersects(place) ||
         std::any_of(now.begin(), now.end(), [&](const CornerLabel& label) { return label.box.intersects(place); });
}

// In the lower left corner, where the view is large enough to spare the room and nothing is drawn there.
void DrawingView::paintLegend(QPainter& painter) const {
  if (viewport()->width() < kLegendFromWidth || viewport()->height() < kLegendFromHeight) {
    return;
  }
  const std::vector<LegendEntry> entries = legendOf(m_plan->drawing);
  const double row = kLegendRow * m_style.unit;
  const double inset = row / 2;
  const double height = row * static_cast<double>(entries.size());
  QPointF left(inset, frame().bottom() - height);
  const QRectF place(0, left.y() - inset, kLegendWidth * m_style.unit, height + inset);
  if (isDrawnOn(place)) {
    return;
  }
  painter.fillRect(place, m_style.palette.paper);
  for (const LegendEntry& entry : entries) {
    entry.sample(painter, left, m_style);
    painter.setPen(m_style.palette.ink);
    painter.setFont(m_style.font(kSmallTextHeight));
    painter.drawText(QRectF(left.x() + (kLegendSample + 15) * m_style.unit, left.y(), 0, 0),
                     Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, entry.words);
    left.ry() += row;
  }
}

int DrawingView::cornerAt(const QPointF& place) const {
  if (!m_plan) {
    return 0;
  }
  for (const CornerLabel& label : labels()) {
    const double grow = std::max(0.0, kTapReach - label.box.height() / 2);
    if (label.box.adjusted(-grow, -grow, grow, grow).contains(place)) {
      return label.corner;
    }
  }
  int nearest = 0;
  double best = kTapReach;
  for (const CornerMark& mark : m_plan->drawing.corners) {
    const double away = distance(viewportTransform().map(toQt(mark.s)), place);
    if (away < best) {
      best = away;
      nearest = mark.id;
    }
  }
  return nearest;
}

const base::Problem* DrawingView::findingAt(const QPointF& place) const {
  const base::Problem* found = nullptr;
  double best = kTapReach;
  if (!m_plan) {
    return found;
  }
  for (const base::Problems* findings : {&m_plan->drawing.problems, &m_plan->drawing.repairs}) {
    for (const base::Problem& finding : *findings) {
      const double away = finding.where ? distance(viewportTransform().map(toQt(*finding.where)), place) : kTapReach;
      const bool worse = found == nullptr || base::severityOf(finding) < base::severityOf(*found);
      const bool same = found != nullptr && base::severityOf(finding) == base::severityOf(*found);
      if (away < kTapReach && (worse || (same && away < best))) {
        best = away;
        found = &finding;
      }
    }
  }
  return found;
}

QRectF DrawingView::labelOf(int corner) const {
  const std::vector<CornerLabel> now = labels();
  const auto label = std::find_if(now.begin(), now.end(),
                                  [corner](const CornerLabel& candidate) { return candidate.corner == corner; });
  return label != now.end() ? label->box : QRectF();
}

bool DrawingView::isTap(const QMouseEvent& event) const {
  return (event.pos() - m_pressed).manhattanLength() < QApplication::startDragDistance();
}

void DrawingView::mousePressEvent(QMouseEvent* event) {
  m_pressed = event->pos();
  if (event->button() == Qt::LeftButton && isOnWheel(event->position())) {
    m_grip = event->position() - viewportTransform().map(toQt(m_wheel->at));
  } else {
    QGraphicsView::mousePressEvent(event);
  }
}

void DrawingView::mouseMoveEvent(QMouseEvent* event) {
  if (!m_grip) {
    QGraphicsView::mouseMoveEvent(event);
  } else if (m_dragsWheel || !isTap(*event)) {
    m_dragsWheel = true;
    dragWheelTo(event->position() - *m_grip);
  }
}

void DrawingView::mouseReleaseEvent(QMouseEvent* event) {
  const bool dragged = m_dragsWheel;
  const bool gripped = m_grip.has_value();
  m_dragsWheel = false;
  m_grip.reset();
  if (!gripped) {
    QGraphicsView::mouseReleaseEvent(event);
    viewport()->setCursor(Qt::ArrowCursor);
  }
  if (isTap(*event) && !dragged) {
    tap(event->position());
  } else if (!gripped) {
    m_fitted = false;
  }
}

// Of what lies in one place the corner comes first.
void DrawingView::tap(const QPointF& place) {
  if (const int corner = cornerAt(place)) {
    Q_EMIT cornerTapped(corner);
  } else if (const base::Problem* finding = findingAt(place)) {
    Q_EMIT findingTapped(*finding);
  } else {
    Q_EMIT placeTapped(onTable(place), kTapReach / pixelsPerMillimetre());
  }
}

void DrawingView::wheelEvent(QWheelEvent* event) {
  const QPointF under = mapToScene(event->position().toPoint());
  setScale(pixelsPerMillimetre() * std::pow(kZoomStep, event->angleDelta().y() / 240.0));
  const QPointF shift = mapFromScene(under) - event->position();
  horizontalScrollBar()->setValue(horizontalScrollBar()->value() + static_cast<int>(std::lround(shift.x())));
  verticalScrollBar()->setValue(verticalScrollBar()->value() + static_cast<int>(std::lround(shift.y())));
  m_fitted = false;
  event->accept();
}

void DrawingView::keyPressEvent(QKeyEvent* event) {
  if (stepWheel(event->key())) {
    return;
  }
  switch (event->key()) {
  case Qt::Key_Plus:
    zoomIn();
    break;
  case Qt::Key_Minus:
    zoomOut();
    break;
  case Qt::Key_0:
  case Qt::Key_Home:
    fit();
    break;
  default:
    QGraphicsView::keyPressEvent(event); // arrows pan
  }
}

void DrawingView::resizeEvent(QResizeEvent* event) {
  QGraphicsView::resizeEvent(event);
  if (m_fitted) {
    fit();
  }
}

bool DrawingView::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::Gesture) {
    const QGesture* gesture = static_cast<QGestureEvent*>(event)->gesture(Qt::PinchGesture);
    if (const auto* pinch = qobject_cast<const QPinchGesture*>(gesture)) {
      zoomBy(pinch->scaleFactor());
      return true;
    }
  }
  return QGraphicsView::viewportEvent(event);
}

} // namespace arris::ui
