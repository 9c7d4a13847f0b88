#pragma once

#include "core/geometry/box_tree.h"
#include "core/pattern/pattern.h"
#include "core/recipe/recipe.h"

#include <cstdint>
#include <vector>

namespace arris::toolpath {

/// An edge among those of all contours.
using EdgeId = std::uint32_t;

/// How two edges that follow each other meet, seen from the wheel.
enum class JointKind { Tangential, Convex, Concave };

/// One contour among the edges.
struct Ring {
  int contour = 0; ///< id
  EdgeId first = 0;
  EdgeId count = 0;
};

/// The edges of all contours in one list, each contour in the direction of travel, with a tree of boxes over them: all
/// that a wheel can touch.
class Glass {
public:
  /// Contours as they are stored have the glass on the left; `reversed` turns them round.
  enum class Order { AsStored, Reversed };

  /// `side`: where the wheel runs, +1 left of the direction of travel, −1 right.
  Glass(const std::vector<pattern::Contour>& contours, Order order, double side);

  [[nodiscard]] const std::vector<geometry::Curve>& edges() const {
    return m_edges;
  }

  [[nodiscard]] const std::vector<Ring>& rings() const {
    return m_rings;
  }

  [[nodiscard]] const Ring& ringOf(EdgeId edge) const {
    return m_rings[m_ringOf[edge]];
  }

  [[nodiscard]] double side() const {
    return m_side;
  }

  [[nodiscard]] EdgeId next(EdgeId edge) const {
    const Ring& ring = ringOf(edge);
    return edge + 1 < ring.first + ring.count ? edge + 1 : ring.first;
  }

  [[nodiscard]] EdgeId previous(EdgeId edge) const {
    const Ring& ring = ringOf(edge);
    return edge > ring.first ? edge - 1 : ring.first + ring.count - 1;
  }

  /// Turn at the end of an edge, rad, positive to the left.
  [[nodiscard]] double turnAfter(EdgeId edge) const {
    return m_turns[edge];
  }

  /// The joint at the end of an edge.
  [[nodiscard]] JointKind jointAfter(EdgeId edge) const;

  /// Whether the glass is a single convex pane: then nothing can be in the wheel's way.
  [[nodiscard]] bool isOneConvexPane() const;

  /// Distance of a point from the nearest edge; `limit` where none is nearer than that.
  [[nodiscard]] double distance(const geometry::Point& point, double limit) const;

  [[nodiscard]] const geometry::BoxTree& tree() const {
    return m_tree;
  }

private:
  std::vector<geometry::Curve> m_edges;
  std::vector<Ring> m_rings;
  std::vector<std::uint32_t> m_ringOf; ///< by edge
  std::vector<double> m_turns;         ///< by edge
  double m_side;
  geometry::BoxTree m_tree;
};

/// On which side of the direction of travel the wheel runs: +1 left, −1 right.
[[nodiscard]] double wheelSide(recipe::Direction direction);

/// The glass as the wheel goes round it.
[[nodiscard]] Glass glassOf(const std::vector<pattern::Contour>& placed, recipe::Direction direction);

} // namespace arris::toolpath
