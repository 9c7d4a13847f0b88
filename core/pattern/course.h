#pragma once

#include "core/geometry/curve.h"

#include <span>

namespace arris::pattern {

/// Lines and arcs, each starting where the one before ends.
using Chain = std::span<const geometry::Curve>;

[[nodiscard]] double lengthOf(Chain chain);

/// The point half-way along, measured along the chain.
[[nodiscard]] geometry::Point middleOf(Chain chain);

/// The same chain the other way round.
[[nodiscard]] std::vector<geometry::Curve> reversedChain(Chain chain);

/// Whether both chains run along each other: at every joint and middle of a curve of either, the other is within
/// `tolerance` (mm) at the same part of its length. Cost grows linearly.
[[nodiscard]] bool runAlong(Chain a, Chain b, double tolerance);

} // namespace arris::pattern
