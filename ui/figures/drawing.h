#pragma once

#include "core/job/job.h"

#include <QPolygonF>
#include <QTransform>

#include <optional>
#include <vector>

namespace arris::ui {

/// What a line of the drawing shows; each has its own colour and its own pattern.
enum class TraceKind { Contour, Loose, Path, Lead, Transition, Roll, Rapid };

/// Curves joined end to end, mm.
struct Trace {
  TraceKind kind = TraceKind::Contour;
  std::vector<geometry::Curve> curves;
};

/// Where a corner gets its number.
struct CornerMark {
  int id = 0;
  geometry::Point s;         ///< the corner of the glass, mm
  geometry::Vector outwards; ///< unit, along the bisector, away from the glass
  double angle = 0;          ///< β, rad
  double clearance = 0;      ///< distance from `s` at which the wheel path passes, mm
};

/// A place on the path with the direction of travel there (unit).
struct PathMark {
  geometry::Point place;
  geometry::Vector direction;
};

/// Everything that a preview shows, in mm of the table (of the drawing where nothing was planned), free of any device.
struct Drawing {
  std::vector<pattern::Contour> contours; ///< closed; the glass lies between outlines and cut-outs
  std::vector<Trace> traces;
  std::vector<CornerMark> corners;
  std::vector<PathMark> speedMarks;   ///< P_d and P_a: braking before a corner begins, accelerating after it ends
  std::vector<PathMark> starts;       ///< where the wheel comes onto each contour
  std::vector<geometry::Point> ups;   ///< where it goes down and comes up again
  std::vector<geometry::Point> stops; ///< where it stops in a concave corner
  double wheelRadius = 0;             ///< mm; 0: no wheel to show
  base::Problems problems;
  base::Problems repairs;              ///< what was repaired in the drawing, all of it notes
  geometry::Box box;                   ///< of all but rapids and travel
  std::optional<geometry::Box> travel; ///< of the wheel's centre
};

[[nodiscard]] Drawing drawingOf(const job::Job& job);

/// With the repairs of the pattern that was planned, and those of its pieces that belong to no contour.
[[nodiscard]] Drawing drawingOf(const job::Job& job, const pattern::Pattern& planned);

/// A pattern as it was imported, nothing planned.
[[nodiscard]] Drawing drawingOf(const pattern::Pattern& pattern);

/// The curves as a polyline in device units that leaves them by at most `tolerance` device units. `toDevice` scales
/// both axes alike.
[[nodiscard]] QPolygonF flattened(const std::vector<geometry::Curve>& curves, const QTransform& toDevice,
                                  double tolerance);

[[nodiscard]] inline QPointF toQt(const geometry::Point& point) {
  return {point.x(), point.y()};
}

} // namespace arris::ui
