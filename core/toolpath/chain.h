#pragma once

#include "core/toolpath/corners.h"

namespace arris::toolpath {

/// A place on a compensated contour: an edge and the way along it on the contour, mm.
struct StartPoint {
  std::size_t edge = 0;
  double along = 0;
};

/// The middle of the longest line (else arc) of the wheel path, or the contour point nearest to the recipe's start.
/// Independent of the drawing's order: lengths within 1 µm count as equal, then the least Y, then the least X of the
/// middle decides; a full circle starts at its least Y.
[[nodiscard]] StartPoint chooseStart(const CompensatedContour& contour, const recipe::Recipe& recipe);

/// The contour once round from `start` and on over the overlap, with its corners, which get their numbers here from
/// `corners.size() + 1` on and are appended.
[[nodiscard]] Chain traceContour(const CompensatedContour& contour, const StartPoint& start, double overlap,
                                 std::vector<Corner>& corners);

/// The overlap of the recipe, at most a quarter of the contour (then with a note).
[[nodiscard]] double overlapOn(const CompensatedContour& contour, const recipe::Recipe& recipe,
                               base::Problems& problems);

/// Puts lead-in and lead-out, quarter arcs away from the glass, before and after the chain.
void addLeads(Chain& chain, const recipe::Recipe& recipe);

/// Errors where the wheel comes too near to the glass: goes down or comes up not clear of the blank, or along a lead
/// touches another part of it. `own` is the compensated contour of the chain.
[[nodiscard]] base::Problems checkLeads(const Chain& chain, const CompensatedContour& own, const StartPoint& start,
                                        const std::vector<CompensatedContour>& all, const recipe::Recipe& recipe);

/// Errors where a wheel path comes nearer to any part of any contour than the wheel's radius.
[[nodiscard]] base::Problems checkClearance(const std::vector<CompensatedContour>& contours,
                                            const recipe::Recipe& recipe);

} // namespace arris::toolpath
