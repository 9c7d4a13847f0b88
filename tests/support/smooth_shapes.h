#pragma once

#include "core/geometry/curve.h"

#include <functional>
#include <random>
#include <vector>

namespace arris::test {

/// A rectangle about the origin with fillets, counter-clockwise.
[[nodiscard]] std::vector<geometry::Curve> roundedRectangle(double width, double height, double radius);

/// The joints of a chain (of a closed one, all) and points along its arcs, and along its lines too where `linesToo`, at
/// most `chord` apart, mm.
[[nodiscard]] std::vector<geometry::Point> choppedEvenly(const std::vector<geometry::Curve>& chain, double chord,
                                                         bool linesToo);

/// A smooth closed curve round the origin, counter-clockwise.
struct SmoothShape {
  std::function<geometry::Point(double)> at; ///< of a parameter from 0 to 1
  /// Points along it, evenly by parameter.
  [[nodiscard]] std::vector<geometry::Point> points(int count) const;
};

/// An ellipse, a wavy circle, or a polygon rounded by tangential arcs, 50 to 1000 mm wide.
[[nodiscard]] SmoothShape randomSmoothShape(std::mt19937_64& random);

/// Vertices of chords of uneven lengths whose distance from the curve stays below `sagitta` (mm); coordinates rounded
/// to multiples of `rounding` (mm, 0: not at all).
[[nodiscard]] std::vector<geometry::Point> choppedUnevenly(const SmoothShape& shape, double sagitta, double rounding,
                                                           std::mt19937_64& random);

} // namespace arris::test
