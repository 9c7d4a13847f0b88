#pragma once

#include "core/program/input_point.h"
#include "ui/figures/style.h"
#include "ui/presenters/planner.h"
#include "ui/views/still_drawing.h"

#include <QGraphicsView>
#include <QPainter>

#include <vector>

namespace arris::ui {

/// The wheel while the machine works.
struct LiveWheel {
  geometry::Point at;     ///< its centre, mm on the table
  program::JobPlace done; ///< what lies before it on the job's way has been passed; none where the segment is −1
};

/// The drawing of a plan: drag to pan, wheel or pinch to zoom, tap a corner or a problem, drag the wheel. All of it
/// goes by keys and by single taps on the buttons beside it too.
class DrawingView : public QGraphicsView {
  Q_OBJECT

public:
  explicit DrawingView(QWidget* parent = nullptr);

  /// Shows a plan; another pattern is fitted into the view, the same one stays where it is.
  void setPlan(PlanPointer plan);
  void setEmptyText(const QString& text); ///< that stands there without a plan

  /// The wheel where it is, with what it has ground so far marked; nothing hides both.
  void setWheel(const std::optional<LiveWheel>& wheel);

  /// Pans where the wheel has left the view.
  void bringWheelIntoView();

  /// Whether the wheel can be dragged by finger, mouse and keys; not unless told so.
  void setWheelMovable(bool movable);

  void selectCorner(int corner);
  /// Brings a corner close enough to see its transition.
  void zoomToCorner(int corner);
  /// Marks a place of the drawing, without moving to it.
  void markPlace(const geometry::Point& place);
  /// Brings a place of the drawing into the middle and marks it.
  void zoomToPlace(const geometry::Point& place);

  /// The corner whose label or tip is near a place of the view; 0 where there is none.
  [[nodiscard]] int cornerAt(const QPointF& place) const;
  /// What was found or repaired near a place of the view, the worst of it; null where there is nothing.
  [[nodiscard]] const base::Problem* findingAt(const QPointF& place) const;
  /// Where a corner's number stands in the view; an invalid rectangle where it is not shown.
  [[nodiscard]] QRectF labelOf(int corner) const;

  /// All that is wanted is painted; a large drawing comes a moment after it was set or zoomed.
  [[nodiscard]] bool isUpToDate() const;

public Q_SLOTS:
  void fit();

  void zoomIn();
  void zoomOut();

Q_SIGNALS:
  void cornerTapped(int corner);
  /// The sign of a finding, beside every corner.
  void findingTapped(const arris::base::Problem& finding);
  /// A place of the table beside all of these; as far from it as `reach` (mm) a finger still means it.
  void placeTapped(const arris::geometry::Point& place, double reach);
  /// The wheel is dragged towards a place of the table.
  void wheelDragged(const arris::geometry::Point& place, double reach);
  /// By key: 1 on, −1 back.
  void wheelStepped(int step);

protected:
  void drawBackground(QPainter* painter, const QRectF& rect) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool viewportEvent(QEvent* event) override;

private:
  void zoomBy(double factor);
  void setScale(double pixelsPerMillimetre);
  void showBox(const geometry::Box& box, double margin);
  [[nodiscard]] std::vector<CornerLabel> labels() const; ///< where they are now
  [[nodiscard]] QRectF stillFrame() const;
  [[nodiscard]] QPointF movedSinceStill() const;
  [[nodiscard]] bool hasScaleOfStill() const;
  [[nodiscard]] int groundSegments() const;
  [[nodiscard]] bool isStillOutdated() const;
  [[nodiscard]] bool isStillShort() const;
  void renewStill(QPainter::RenderHints hints);
  void take(const StillDrawing& still);
  void paintOverStill(QPainter& painter);
  void paintWheel(QPainter& painter) const;
  [[nodiscard]] bool isOnWheel(const QPointF& place) const;
  void dragWheelTo(const QPointF& place);
  bool stepWheel(int key);
  [[nodiscard]] bool isTap(const QMouseEvent& event) const;
  void tap(const QPointF& place);
  [[nodiscard]] geometry::Point onTable(const QPointF& place) const;
  void paintLegend(QPainter& painter) const;
  [[nodiscard]] bool isDrawnOn(const QRectF& place) const;
  [[nodiscard]] double pixelsPerMillimetre() const;
  [[nodiscard]] QRectF frame() const;

  PlanPointer m_plan;
  FigureStyle m_style;
  int m_selected = 0;
  std::optional<geometry::Point> m_marked;
  std::optional<LiveWheel> m_wheel;
  bool m_wheelMovable = false;
  std::optional<QPointF> m_grip; // where the hand holds the wheel, px from its centre
  bool m_dragsWheel = false;     // the hand has moved since
  StillDrawing m_still;          // all that a pan takes along, with what has been ground
  bool m_isPainting = false;     // a newer one, in another thread
  QString m_emptyText;
  bool m_fitted = true; // the view follows the size of the window until somebody zooms or pans
  QPoint m_pressed;
};

} // namespace arris::ui
