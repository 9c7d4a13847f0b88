#pragma once

#include "core/job/job.h"

namespace arris::job {

/// Puts the pattern on the table as the recipe says: mirror, rotate about the drawing's origin, shift so that the
/// lower-left corner of the outlines' box lies at the place; by default the box is centred in the travel.
[[nodiscard]] Placement placementOf(const std::vector<pattern::Contour>& contours, const recipe::Recipe& recipe,
                                    const recipe::Machine& machine);

/// The contours moved to the table; outlines still run counter-clockwise and cut-outs clockwise.
[[nodiscard]] std::vector<pattern::Contour> placed(const std::vector<pattern::Contour>& contours,
                                                   const Placement& placement);

/// The problems with their places moved to the table.
[[nodiscard]] base::Problems placed(base::Problems problems, const Placement& placement);

} // namespace arris::job
