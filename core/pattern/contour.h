#pragma once

#include "core/pattern/pattern.h"

#include <vector>

namespace arris::pattern {

/// A closed chain as a contour, the same whatever way it was drawn: counter-clockwise, from the start with the least Y
/// (then X), collinear and co-circular neighbours made one, joints that the drawing's rounding broke made tangential.
[[nodiscard]] Contour makeContour(std::vector<geometry::Curve> closedChain);

/// Numbers the contours by place, and turns those that lie inside an odd number of others into cut-outs.
void sortContours(std::vector<Contour>& contours);

/// Errors of single contours: no area, crossing itself; and of having several.
[[nodiscard]] base::Problems checkContours(const std::vector<Contour>& contours);

} // namespace arris::pattern
