#pragma once

#include "core/pattern/pattern.h"

#include <vector>

namespace arris::test {

/// A single outline as a pattern in millimetres, as the reader would give it.
[[nodiscard]] pattern::Pattern paneOf(std::vector<geometry::Curve> counterClockwise);

/// A polygon, corners counter-clockwise.
[[nodiscard]] pattern::Pattern polygon(const std::vector<geometry::Point>& corners);

/// The 600 mm equilateral triangle with its lower side parallel to X, turned by `degrees`.
[[nodiscard]] pattern::Pattern triangle600(double degrees = 0);

/// A triangle with the angle `degrees` at its first corner (0, 0) between legs of length `leg`; the bisector points
/// along +X.
[[nodiscard]] pattern::Pattern isosceles(double degrees, double leg);

} // namespace arris::test
