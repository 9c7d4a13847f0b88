#pragma once

#include "core/toolpath/wheel_loop.h"

#include <vector>

namespace arris::toolpath {

/// A place on a loop: a step and the way along its path, mm.
struct StartPoint {
  std::size_t step = 0;
  double along = 0;
};

/// Where the wheel may start, best first: the middle of the longest line along the contour, then of the next longest,
/// then of arcs along it, then of what leads round corners. Independent of the drawing's order: lengths within 1 µm
/// count as equal, then the least Y, then the least X of the middle decides; a full circle starts at its least Y.
[[nodiscard]] std::vector<StartPoint> startsOn(const WheelLoop& loop);

/// A place on a contour and how far it is from a given point.
struct NearestOnLoop {
  StartPoint start;
  double distance = 0; ///< of the ground contour from the point, mm
};

/// The place of the loop where it grinds the contour point nearest to `wanted`; at a corner, the beginning of the edge
/// after it.
[[nodiscard]] NearestOnLoop nearestOnLoop(const Glass& glass, const WheelLoop& loop, const geometry::Point& wanted);

/// The loop once round from `start` and on over the overlap (mm along the glass). Corners are numbered from 1 in the
/// order in which they are met and returned in that order.
struct Traced {
  Chain chain;
  std::vector<Corner> corners;
  base::Problems problems; ///< the loop's, with the corners' numbers
  EdgeId lastEdge = 0;     ///< the edge on which the overlap ends
};

[[nodiscard]] Traced traceLoop(const Glass& glass, const WheelLoop& loop, const StartPoint& start, double overlap);

/// The overlap of the recipe, at most a quarter of the glass along the loop (then with a note).
[[nodiscard]] double overlapOn(const WheelLoop& loop, int contour, const recipe::Recipe& recipe,
                               base::Problems& problems);

/// The lead-in onto the start of `path`: a quarter arc away from the glass, tangential there.
[[nodiscard]] geometry::Arc leadInTo(const geometry::Curve& path, const recipe::Recipe& recipe);

/// Puts lead-in and lead-out, quarter arcs away from the glass, before and after the chain.
void addLeads(Chain& chain, const recipe::Recipe& recipe);

/// Errors where the wheel comes too near to the glass: goes down or comes up not clear of the blank, or along a lead
/// touches another part of it. The chain starts on the edge `first` and ends on the edge `last`.
[[nodiscard]] base::Problems checkLeads(const Chain& chain, EdgeId first, EdgeId last, const Glass& glass,
                                        const recipe::Recipe& recipe);

/// The same for a lead-in alone, onto the edge `edge`.
[[nodiscard]] base::Problems checkLeadIn(const geometry::Arc& lead, EdgeId edge, const Glass& glass,
                                         const recipe::Recipe& recipe);

/// The order of machining as indices: a chain comes after all chains along the cut-outs that lie in its contour; of
/// those that may come next, the one that starts nearest to where the wheel is. The wheel begins at `park`. O(n log n).
[[nodiscard]] std::vector<std::size_t> orderOfChains(const std::vector<Chain>& chains,
                                                     const std::vector<pattern::Contour>& contours,
                                                     const geometry::Point& park);

} // namespace arris::toolpath
