#pragma once

#include "core/toolpath/toolpath.h"

#include <optional>
#include <vector>

namespace arris::toolpath {

/// On which side of the direction of travel the wheel runs: +1 left, −1 right.
[[nodiscard]] double wheelSide(recipe::Direction direction);

/// An edge of the contour in the direction of travel, and the wheel's way along it.
struct Edge {
  geometry::Curve contour;
  geometry::Curve path;
};

/// What joins an edge to the next: a corner with its own piece of wheel path, or nothing where they are tangential.
struct Joint {
  std::optional<Corner> corner; ///< not numbered yet
  std::optional<geometry::Curve> path;
};

/// A contour compensated by the wheel radius: edges[i], joints[i], edges[i+1], …, closed.
struct CompensatedContour {
  int contour = 0;
  std::vector<Edge> edges;
  std::vector<Joint> joints;
};

/// Offsets every edge and bridges every corner. What this wheel cannot do, and what offsets that meet each other would
/// need, goes to `problems`; the joint there stays empty.
[[nodiscard]] CompensatedContour compensate(const pattern::Contour& contour, const recipe::Recipe& recipe,
                                            base::Problems& problems);

/// The corner where an edge of direction `before` meets one of direction `after` in `s`, both unit; convex.
[[nodiscard]] Corner classify(const geometry::Point& s, const geometry::Vector& before, const geometry::Vector& after,
                              const recipe::Recipe& recipe);

} // namespace arris::toolpath
