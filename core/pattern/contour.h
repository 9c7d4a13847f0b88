#pragma once

#include "core/pattern/pattern.h"

#include <vector>

namespace arris::pattern {

/// A closed chain as a contour, the same whatever way it was drawn: counter-clockwise, from the start with the least Y
/// (then X), collinear and co-circular neighbours made one, joints that the drawing's rounding broke made tangential.
[[nodiscard]] Contour makeContour(std::vector<geometry::Curve> closedChain);

/// One of each contour that was drawn several times, whatever its pieces were; which one does not depend on their
/// order. What was taken out goes to `repairs`.
void takeOutCopies(std::vector<Contour>& contours, base::Problems& repairs);

/// Numbers the contours by place, finds the innermost that each lies in, and turns those that lie inside an odd number
/// of others into cut-outs. Means something only where no two of them cross. Cost grows as n log n.
void sortContours(std::vector<Contour>& contours);

/// Errors of contours: no area, crossing itself, crossing or touching another.
[[nodiscard]] base::Problems checkContours(const std::vector<Contour>& contours);

} // namespace arris::pattern
