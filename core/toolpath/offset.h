#pragma once

#include "core/toolpath/glass.h"

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

namespace arris::toolpath {

/// The wheel's way along one edge, or its roll round the convex corner at the end of that edge, before anything is cut
/// off. Where the edge curves more tightly than the wheel there is none.
struct Piece {
  geometry::Curve path;
  double length = 0; ///< of the path, mm
  EdgeId edge = 0;
  bool isRoll = false;
  bool joinsNext = false; ///< its end is the start of the piece that follows in its ring
};

/// A part of a piece that keeps its distance from all glass, from λ = `from` to `to`.
struct Span {
  std::uint32_t piece = 0;
  double from = 0;
  double to = 0;
};

/// A closed way of the wheel's centre: the border of the region that it can reach. Each span ends where the next one
/// starts, the last where the first does.
using Loop = std::vector<Span>;

/// All that a wheel of one radius can do with the glass.
struct Offset {
  double radius = 0; ///< mm; larger than asked for by some nanometres where that was needed to tell what touches
  std::vector<Piece> pieces;           ///< in the order of the edges
  std::vector<Loop> loops;             ///< in the order of their first pieces
  std::optional<geometry::Point> open; ///< an end that rounding left without a start that follows: then no loops
};

/// The set of all points at the distance `radius` from the glass, on the wheel's side of it: every edge moved by the
/// radius, arcs round convex corners, and all of it cut where it comes nearer than the radius to any other edge.
/// O(n log n) unless very many edges lie within the radius of each other's way. A stop ends it early.
[[nodiscard]] Offset offsetOf(const Glass& glass, double radius, const std::stop_token& stop = {});

} // namespace arris::toolpath
