#pragma once

#include "core/base/problem.h"
#include "core/geometry/arc_fitter.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace arris::geometry {

/// A higher degree than this is not read: evaluating it costs too much, and no CAD system writes it.
inline constexpr int kMostDegree = 25;

/// Non-uniform rational B-spline in the plane. It runs over the knots from number `degree` to number `points.size()`
/// (from 0), so it may be clamped to its end points or not: a closed one ends where it starts either because its end
/// points are the same, or because its first `degree` points are repeated at its end.
struct Spline {
  int degree = 3;
  std::vector<double> knots;   ///< never falling, as many as points + degree + 1
  std::vector<Point> points;   ///< mm
  std::vector<double> weights; ///< positive, one for each point; none: all 1
};

/// Why this is no curve ("" where it is one): words with a decimal point, in English.
[[nodiscard]] std::string flawOf(const Spline& spline);

/// Bézier curve with weights: each point as (w x, w y, w), w > 0.
struct Bezier {
  std::vector<Eigen::Vector3d> points;

  [[nodiscard]] int degree() const {
    return static_cast<int>(points.size()) - 1;
  }
};

/// Point and direction at `t` from 0 to 1; where the derivative vanishes, the direction that the curve has beside it.
[[nodiscard]] Station stationAt(const Bezier& bezier, double t);

/// The curve piece by piece, each smooth within unless it has a cusp. The spline must be without flaw.
[[nodiscard]] std::vector<Bezier> bezierPieces(const Spline& spline);

/// The cubic curve through points with continuous curvature, its parameter the length of the chords. End directions
/// are those of travel; without one the curve ends without curvature. A closed curve runs on to its first point, as
/// smooth there as elsewhere. Points nearer than 1e-9 mm to the one before are passed over; none where that leaves one.
struct Interpolation {
  std::vector<Point> points; ///< mm
  std::optional<Vector> startDirection;
  std::optional<Vector> endDirection;
  bool closed = false;
};

[[nodiscard]] std::vector<Bezier> bezierPieces(const Interpolation& interpolation);

/// Appends the pieces to what the fitter follows. Where two of them meet without a turn they share their direction.
/// False where the fitter gave up.
[[nodiscard]] bool follow(const std::vector<Bezier>& pieces, ArcFitter& fitter);

} // namespace arris::geometry
