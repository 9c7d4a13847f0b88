#pragma once

#include "core/pattern/pattern.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace arris::test {

/// The closed chain of lines round these corners.
[[nodiscard]] std::vector<geometry::Curve> closedLines(const std::vector<geometry::Point>& corners);

/// Contours from lines and arcs that are each a piece of their own; `smooth` 0: as drawn.
[[nodiscard]] pattern::Pattern joined(std::vector<geometry::Curve> singles, double gap, double smooth = 0);

/// The problems of one code.
[[nodiscard]] std::vector<base::Problem> problemsOf(const pattern::Pattern& pattern, base::Code code);

/// Whether two chains are the same curves in the same order, their ends and middles within `tolerance`.
[[nodiscard]] testing::AssertionResult areSame(const std::vector<geometry::Curve>& a,
                                               const std::vector<geometry::Curve>& b, double tolerance);

/// Whether each curve starts where the one before ends, and every joint is tangential within `tangent` (rad) or a true
/// corner.
[[nodiscard]] testing::AssertionResult isWellJoined(const std::vector<geometry::Curve>& closedChain, double tangent);

/// The same pieces in another order, some the other way round.
[[nodiscard]] std::vector<geometry::Curve> shuffled(std::vector<geometry::Curve> pieces, std::uint64_t seed);

/// Largest distance of points along the curves of `a` from `b`, mm.
[[nodiscard]] double farthest(const std::vector<geometry::Curve>& a, const std::vector<geometry::Curve>& b);

} // namespace arris::test
