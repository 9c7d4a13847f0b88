#pragma once

#include <QPolygonF>
#include <QRectF>

#include <vector>

namespace arris::ui {

/// The fewest-points polyline that stays within `tolerance` of the given one, point by point in one pass and in order;
/// its ends are kept. Cost grows as n. Source: sleeve fitting (Zhao and Saalfeld), with turning back made visible.
class Thinner {
public:
  Thinner(double tolerance, QPolygonF& into);

  /// The next point of the polyline.
  void add(const QPointF& point);

  /// After the last point: the end is part of the result.
  void finish();

private:
  void startAt(const QPointF& anchor);
  [[nodiscard]] bool fits(const QPointF& point) const;
  void narrowTo(const QPointF& point);

  double m_aside, m_back; // what a point may lie aside of the result, and beyond a tip of it
  QPolygonF& m_result;
  QPointF m_anchor, m_last;
  double m_farthest = 0;           // distance from the anchor that was reached since
  double m_middle = 0, m_half = 0; // the sleeve: directions within m_half of m_middle, rad
  bool m_started = false, m_open = false, m_narrowed = false;
};

[[nodiscard]] QPolygonF thinned(const QPolygonF& polyline, double tolerance);

/// Of a curve over x (ascending): first, least, greatest and last point of every column of the given width, so that
/// what a pen a column wide would draw stays the same however dense the curve is.
[[nodiscard]] QPolygonF columnExtremes(const QPolygonF& curve, double columnWidth);

/// A stretch of a polyline that lies inside a rectangle.
struct Stretch {
  QPolygonF points;
  double startLength = 0; ///< length of the whole polyline up to the first point, so that dashes do not wander
};

/// What of a polyline lies inside `rectangle`. Points that are not numbers are gaps.
[[nodiscard]] std::vector<Stretch> clipped(const QPolygonF& polyline, const QRectF& rectangle);

/// The part of a filled polygon inside `rectangle`. Several that are filled together by the odd-even rule can be cut
/// one by one.
[[nodiscard]] QPolygonF clippedArea(const QPolygonF& polygon, const QRectF& rectangle);

} // namespace arris::ui
