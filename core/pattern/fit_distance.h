#pragma once

#include "core/geometry/biarc.h"

#include <span>

namespace arris::pattern {

/// How far the point lies to the left of a line or of the circle of an arc, mm.
[[nodiscard]] double leftDistance(const geometry::Curve& lineOrArc, const geometry::Point& point);

/// Largest distance between chords from vertex to vertex and the curves that stand for them, mm, to third order of the
/// turn of a chord; some larger distance than `enough` as soon as it is found.
[[nodiscard]] double distanceFromChords(const geometry::Biarc& fitted, std::span<const geometry::Point> vertices,
                                        double enough);

/// The same for an arc between two lines that it touches, of which the chords at either end may follow a part.
[[nodiscard]] double distanceFromChords(const geometry::Line& before, const geometry::Arc& arc,
                                        const geometry::Line& after, std::span<const geometry::Point> vertices);

} // namespace arris::pattern
