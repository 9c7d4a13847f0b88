#pragma once

#include "core/job/job.h"

namespace arris::job {

/// Heights of the wheel (the middle of its working profile) above the table, mm.
struct Heights {
  double grinding = 0;
  double clearance = 0; ///< lower face `clearance` above the glass
  double top = 0;       ///< top of the travel
};

[[nodiscard]] Heights heightsOf(const recipe::Recipe& recipe, const recipe::Machine& machine);

/// Errors where the wheel would come too near to the table or leave the travel in Z.
[[nodiscard]] base::Problems checkHeights(const recipe::Recipe& recipe, const recipe::Machine& machine);

/// An error where the wheel, parked, would touch the table or the glass.
[[nodiscard]] base::Problems checkPark(const std::vector<pattern::Contour>& contours, const recipe::Recipe& recipe,
                                       const recipe::Machine& machine);

/// Errors where the path leaves the travel in X and Y; names the corner whose transition does.
[[nodiscard]] base::Problems checkTravel(const toolpath::Toolpath& toolpath, const recipe::Machine& machine);

/// The whole program: from the park position up, across, down, round every contour, up, and back.
[[nodiscard]] std::vector<motion::Segment> makeTrack(const toolpath::Toolpath& toolpath, const recipe::Recipe& recipe,
                                                     const recipe::Machine& machine);

} // namespace arris::job
