#pragma once

#include "core/base/problem.h"
#include "core/pattern/curve_tree.h"
#include "core/pattern/effort.h"

namespace arris::pattern {

/// The places where a closed chain of lines and arcs crosses or touches itself, neighbours that turn back on themselves
/// included; the first few are enough, and what is found until the effort is spent. `chain` is the one of the tree.
[[nodiscard]] std::vector<geometry::Point> selfCrossings(const std::vector<geometry::Curve>& chain,
                                                         const CurveTree& tree, Effort& effort);

/// The places where two closed chains cross or come nearer than `kSamePlace`; the first few are enough, and what is
/// found until the effort is spent.
[[nodiscard]] std::vector<geometry::Point> crossingsBetween(const std::vector<geometry::Curve>& a,
                                                            const CurveTree& treeOfA,
                                                            const std::vector<geometry::Curve>& b,
                                                            const CurveTree& treeOfB, Effort& effort);

} // namespace arris::pattern
