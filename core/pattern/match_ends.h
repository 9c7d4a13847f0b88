#pragma once

#include "core/base/problem.h"
#include "core/pattern/pieces.h"

#include <cstdint>
#include <stop_token>
#include <vector>

namespace arris::pattern {

/// An end of a piece: 2 × piece for its start, 2 × piece + 1 for its end.
using EndId = std::uint32_t;

inline constexpr EndId kNoEnd = ~EndId{0};

[[nodiscard]] inline EndId otherEnd(EndId end) {
  return end ^ 1U;
}

[[nodiscard]] inline std::size_t pieceOf(EndId end) {
  return end / 2;
}

[[nodiscard]] inline bool isStart(EndId end) {
  return end % 2 == 0;
}

/// Which end is joined to which, and where.
struct Matches {
  std::vector<EndId> partner;          ///< by end; `kNoEnd` where an end stays free
  std::vector<geometry::Point> joints; ///< by end: where it comes to lie, half-way to its partner
  base::Problems repairs;              ///< gaps closed
  base::Problems problems;             ///< ends that stay free, places where pieces branch
};

/// Joins the ends of pieces (none without length, none closed in itself) that are at most `gap` apart, nearest first;
/// ties are decided by coordinates, never by the order of the pieces. Where three or more ends lie in one point, none
/// of them is joined; an end that stays free on a piece or on one of the `closed` chains is told as such. Cost grows as
/// n log n. A stop ends it early.
[[nodiscard]] Matches matchEnds(const Pieces& pieces, const std::vector<std::vector<geometry::Curve>>& closed,
                                double gap, const std::stop_token& stop);

} // namespace arris::pattern
