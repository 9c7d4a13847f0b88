#pragma once

#include "core/geometry/curve.h"

#include <Eigen/Core>

#include <limits>
#include <span>
#include <variant>
#include <vector>

namespace arris::motion {

/// A move straight up or down at one place of the table; λ is the way travelled, mm.
struct Vertical {
  geometry::Point at;
  double from = 0; ///< Z, mm
  double to = 0;
};

/// What a segment of the track is for; names as in the profile's `phase` column where they are the same.
enum class Move { Approach, Plunge, LeadIn, Contour, Transition, Roll, LeadOut, Retract, Traverse };

/// Whether it goes along the glass: leads do not.
[[nodiscard]] constexpr bool isAlongContour(Move move) {
  return move == Move::Contour || move == Move::Transition || move == Move::Roll;
}

/// A piece of the whole program of motion: one primitive with what bounds the speed on it.
struct Segment {
  std::variant<geometry::Line, geometry::Arc, geometry::Parabola, Vertical> shape;
  Move move = Move::Contour;
  double z = 0;    ///< mm, height of a planar primitive
  double feed = 0; ///< mm/s, programmed speed of λ at an override of 100 %; the override scales it
  double speedCap = std::numeric_limits<double>::infinity(); ///< mm/s of λ that no override exceeds (v_trans)
  bool stopAtEnd = false;
  int contour = 0;    ///< from 1; 0 off the contours
  int number = 0;     ///< of the wheel path's primitive over the whole program, from 1; 0 in rapids and plunges
  int corner = 0;     ///< whose transition, roll or arc this is; 0 none
  int stopCorner = 0; ///< the concave corner at which the wheel stops at the end of this; 0 none
};

/// Parameter range, mm.
[[nodiscard]] double parameterLength(const Segment& segment);

/// The way in the plane; a line without length where the move is vertical.
[[nodiscard]] geometry::Curve curveOf(const Segment& segment);

/// Position and derivatives by λ in space.
struct Evaluation {
  Eigen::Vector3d point, first, second;
};

[[nodiscard]] Evaluation evaluate(const Segment& segment, double lambda);

/// True length travelled from 0 to λ.
[[nodiscard]] double arcLength(const Segment& segment, double lambda);

/// True length of a whole way, mm.
[[nodiscard]] double arcLength(std::span<const Segment> way);

} // namespace arris::motion
