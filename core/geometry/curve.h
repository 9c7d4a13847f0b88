#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <variant>
#include <vector>

namespace arris::geometry {

using Point = Eigen::Vector2d;  ///< mm
using Vector = Eigen::Vector2d; ///< mm, or without unit for directions
using Box = Eigen::AlignedBox2d;

/// `v` turned by +90° (to the left of the direction of travel).
[[nodiscard]] inline Vector leftOf(const Vector& v) {
  return {-v.y(), v.x()};
}

/// z component of the cross product; positive where `b` points to the left of `a`.
[[nodiscard]] inline double cross(const Vector& a, const Vector& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Angle from `a` to `b`, rad in (−π, π], positive to the left. Exact for the smallest angles too.
[[nodiscard]] double turn(const Vector& a, const Vector& b);

/// Straight line; parameter λ is the arc length from `from`.
struct Line {
  Point from;
  Point to;
};

/// Circular arc, told by how it starts: it stays exact from the smallest radius to an all but straight arc.
/// Parameter λ is the arc length.
struct Arc {
  Point start;
  Vector tangent;       ///< unit direction of travel at the start
  double curvature = 0; ///< 1/mm, positive to the left (counter-clockwise); never 0
  double length = 0;    ///< mm, at most a full circle

  [[nodiscard]] double radius() const {
    return 1 / std::abs(curvature);
  }

  [[nodiscard]] Point center() const {
    return start + leftOf(tangent) / curvature;
  }

  /// Angle swept, rad, positive counter-clockwise.
  [[nodiscard]] double sweep() const {
    return curvature * length;
  }
};

/// The transition path: the quadratic Bézier a, q, c with equal legs ℓ = |aq| = |qc|; parameter λ = 2ℓu, so that
/// the first derivative has length 1 at both ends and the second is constant.
struct Parabola {
  Point a;
  Point q;
  Point c;
};

using Curve = std::variant<Line, Arc, Parabola>;

/// Point, first and second derivative by λ.
struct Evaluation {
  Point point;
  Vector first;
  Vector second;
};

// Each function below takes λ from 0 to `parameterLength`.

[[nodiscard]] double parameterLength(const Curve& curve);
[[nodiscard]] Evaluation evaluate(const Line& line, double lambda);
[[nodiscard]] Evaluation evaluate(const Arc& arc, double lambda);
[[nodiscard]] Evaluation evaluate(const Parabola& parabola, double lambda);
[[nodiscard]] Evaluation evaluate(const Curve& curve, double lambda);
[[nodiscard]] Point pointAt(const Curve& curve, double lambda);
[[nodiscard]] Point startPoint(const Curve& curve);
[[nodiscard]] Point endPoint(const Curve& curve);

/// Unit direction of travel.
[[nodiscard]] Vector startTangent(const Curve& curve);
[[nodiscard]] Vector endTangent(const Curve& curve);

/// True length travelled from 0 to λ, mm; differs from λ on a parabola only.
[[nodiscard]] double arcLength(const Curve& curve, double lambda);
[[nodiscard]] double arcLength(const Curve& curve);

/// The part from λ = `from` to `to`, from < to. Of a parabola too the part is a parabola only when it is the whole:
/// asking for less is a broken contract.
[[nodiscard]] Curve part(const Curve& curve, double from, double to);

/// The same points in the other direction.
[[nodiscard]] Curve reversed(const Curve& curve);

/// Moved to the left of the direction of travel by `distance` (negative: to the right); lines and arcs only. An arc
/// whose radius does not stay positive is a broken contract.
[[nodiscard]] Curve offset(const Curve& curve, double distance);

/// Under a rotation, mirroring and shift (no scaling).
[[nodiscard]] Curve transformed(const Curve& curve, const Eigen::Isometry2d& motion);

[[nodiscard]] Box bounds(const Curve& curve);

/// Nearest point of a line or an arc: its λ and the distance, mm.
struct Nearest {
  double lambda = 0;
  double distance = 0;
};

[[nodiscard]] Nearest nearest(const Curve& lineOrArc, const Point& point);

/// Smallest distance between two curves that do not cross, mm; 0 or nearly 0 where they do. Lines and arcs exactly;
/// with a parabola to within 1 nm above `relevant` (a smaller distance is exact to the same, a larger one may come out
/// as any value above it).
[[nodiscard]] double distance(const Curve& a, const Curve& lineOrArc, double relevant);

/// The arc from `from` to `to` with the given sweep (rad, positive counter-clockwise, up to ±2π, not 0).
[[nodiscard]] Arc arcBetween(const Point& from, const Point& to, double sweep);

/// The arc about `center` from the angle `startAngle` over `sweep`, rad, positive counter-clockwise.
[[nodiscard]] Arc arcAbout(const Point& center, double radius, double startAngle, double sweep);

/// Twice the signed area under the curve seen from the origin; summed over a closed chain and halved it is the area,
/// positive counter-clockwise. mm².
[[nodiscard]] double doubledArea(const Curve& lineOrArc);

/// Area of a closed chain, mm², positive where it runs counter-clockwise.
[[nodiscard]] double signedArea(const std::vector<Curve>& closedChain);

[[nodiscard]] double totalLength(const std::vector<Curve>& chain);
[[nodiscard]] Box bounds(const std::vector<Curve>& chain);

} // namespace arris::geometry
