#pragma once

#include "core/base/problem.h"
#include "core/pattern/pieces.h"

#include <stop_token>
#include <vector>

namespace arris::pattern {

/// Pieces joined end to end, each curve starting exactly where the one before ends (arcs to rounding).
struct Chains {
  std::vector<std::vector<geometry::Curve>> closed;
  std::vector<geometry::Curve> loose; ///< the curves of the chains that stay open
  base::Problems repairs;
  base::Problems problems;
};

/// Closed chains from pieces in any order and direction: lines and arcs without length are taken out, doubles too, ends
/// up to `gap` apart are moved to their middle (an arc keeps its sweep), which moves the first and the last curve of a
/// piece only. A piece that is closed is a chain by itself. The result does not depend on the order of the pieces but
/// for where chains start and which way they run. A stop ends it early.
[[nodiscard]] Chains chainPieces(Pieces pieces, double gap, const std::stop_token& stop = {});

/// The same curve with its ends moved by a little: a line to between them, an arc with its sweep kept, or its radius
/// where it is nearly a full circle.
[[nodiscard]] geometry::Curve withEnds(const geometry::Curve& lineOrArc, const geometry::Point& from,
                                       const geometry::Point& to);

/// The circle of which the arc is a part, once round from where it starts.
[[nodiscard]] geometry::Arc fullCircle(const geometry::Arc& arc);

} // namespace arris::pattern
