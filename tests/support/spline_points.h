#pragma once

#include "core/geometry/spline.h"

#include <cstdint>

namespace arris::test {

/// The point of a spline by the sum of its basis functions (Cox and de Boor), sharing nothing with the code under test.
[[nodiscard]] geometry::Point basisPoint(const geometry::Spline& spline, double u);

/// A spline of degree 1 to 7 with 3 to 12 points more than that within ±200 mm, every other one rational, some knots
/// repeated, some not clamped to the ends. The same seed gives the same spline.
[[nodiscard]] geometry::Spline randomSpline(std::uint64_t seed);

/// A circle in rational pieces of degree 2, each over 360°/pieces: points in order, knots twice at each joint.
[[nodiscard]] geometry::Spline circleAsSpline(const geometry::Point& center, double radius, int pieces);

/// What a chain is to a curve that is given point by point over [from, to]: the largest distance of points of the curve
/// from the chain, and of points of the chain from the curve. mm
struct Apart {
  double curveFromChain = 0;
  double chainFromCurve = 0;
};

[[nodiscard]] Apart apart(const std::function<geometry::Point(double)>& curve, double from, double to,
                          const std::vector<geometry::Curve>& chain);

/// The largest turn between neighbours of a chain, rad, and the largest gap, mm.
struct Joints {
  double turn = 0;
  double gap = 0;
};

[[nodiscard]] Joints jointsOf(const std::vector<geometry::Curve>& chain);

} // namespace arris::test
