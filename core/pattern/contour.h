#pragma once

#include "core/pattern/pattern.h"

#include <stop_token>
#include <vector>

namespace arris::pattern {

/// A closed chain as a contour, the same whatever way it was drawn: counter-clockwise, from the start with the least Y
/// (then X), collinear and co-circular neighbours made one, chords of curves fitted within `smooth` (mm; 0: not at
/// all), joints that the drawing's rounding broke made tangential. Chords that are too coarse go to `notes`, without
/// the contour's number. As of the functions below, a stop ends it early.
[[nodiscard]] Contour makeContour(int id, std::vector<geometry::Curve> closedChain, double smooth,
                                  base::Problems& notes, const std::stop_token& stop = {});

/// One of each contour that was drawn several times, whatever its pieces were; which one does not depend on their
/// order. What was taken out goes to `repairs`.
void takeOutCopies(std::vector<Contour>& contours, base::Problems& repairs, const std::stop_token& stop = {});

/// Numbers the contours by place (in `notes` too), finds the innermost that each lies in, and turns those that lie
/// inside an odd number of others into cut-outs. Nesting means something only where no two of them cross. Cost grows as
/// n log n; where too many lie within each other for that, this is an error in `notes`.
void sortContours(std::vector<Contour>& contours, base::Problems& notes, const std::stop_token& stop = {});

/// Errors of contours: no area, crossing itself, crossing or touching another, too many over each other to tell.
[[nodiscard]] base::Problems checkContours(const std::vector<Contour>& contours, const std::stop_token& stop = {});

} // namespace arris::pattern
