#pragma once

#include "core/geometry/arc_fitter.h"

namespace arris::geometry {

/// A circular arc under an affine map (mm): part of an ellipse.
struct EllipticArc {
  Arc arc;
  Eigen::AffineCompact2d map;
};

/// Whether circles stay circles under the linear map, to the last digits.
[[nodiscard]] bool keepsCircles(const Eigen::Matrix2d& linear);

/// The picture of a point of the arc, λ its length from the start before the map.
[[nodiscard]] Station stationAt(const EllipticArc& ellipticArc, double lambda);

/// The arc that it is where the map keeps circles.
[[nodiscard]] std::optional<Arc> asCircular(const EllipticArc& ellipticArc);

/// Appends the arc to what the fitter follows. False where the fitter gave up.
[[nodiscard]] bool follow(const EllipticArc& ellipticArc, ArcFitter& fitter);

} // namespace arris::geometry
