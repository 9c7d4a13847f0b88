#include "core/toolpath/glass.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace arris::toolpath {

using geometry::Arc;
using geometry::Curve;
using geometry::Point;

Glass::Glass(const std::vector<pattern::Contour>& contours, Order order, double side) : m_side(side) {
  std::vector<geometry::FlatBox> boxes;
  for (const pattern::Contour& contour : contours) {
    const auto first = static_cast<EdgeId>(m_edges.size());
    m_rings.push_back({contour.id, first, static_cast<EdgeId>(contour.curves.size())});
    if (order == Order::AsStored) {
      m_edges.insert(m_edges.end(), contour.curves.begin(), contour.curves.end());
    } else {
      std::transform(contour.curves.rbegin(), contour.curves.rend(), std::back_inserter(m_edges), geometry::reversed);
    }
    m_ringOf.resize(m_edges.size(), static_cast<std::uint32_t>(m_rings.size() - 1));
  }
  boxes.reserve(m_edges.size());
  m_turns.reserve(m_edges.size());
  for (EdgeId edge = 0; edge < m_edges.size(); ++edge) {
    boxes.push_back(geometry::flatBounds(m_edges[edge]));
    m_turns.push_back(geometry::turn(geometry::endTangent(m_edges[edge]), geometry::startTangent(m_edges[next(edge)])));
  }
  m_tree = geometry::BoxTree(boxes);
}

JointKind Glass::jointAfter(EdgeId edge) const {
  const double turn = m_turns[edge] * m_side;
  if (std::abs(turn) <= base::kTangentTurn) {
    return JointKind::Tangential;
  }
  return turn < 0 ? JointKind::Convex : JointKind::Concave;
}

bool Glass::isOneConvexPane() const {
  if (m_rings.size() != 1) {
    return false;
  }
  for (EdgeId edge = 0; edge < m_edges.size(); ++edge) {
    const auto* arc = std::get_if<Arc>(&m_edges[edge]);
    if (jointAfter(edge) == JointKind::Concave || (arc && arc->curvature * m_side > 0)) {
      return false;
    }
  }
  return true;
}

double Glass::distance(const Point& point, double limit) const {
  return m_tree.least(point, limit, [&](std::size_t edge) { return geometry::nearest(m_edges[edge], point).distance; });
}

double wheelSide(recipe::Direction direction) {
  return direction == recipe::Direction::Clockwise ? 1 : -1;
}

Glass glassOf(const std::vector<pattern::Contour>& placed, recipe::Direction direction) {
  const bool clockwise = direction == recipe::Direction::Clockwise;
  return {placed, clockwise ? Glass::Order::Reversed : Glass::Order::AsStored, wheelSide(direction)};
}

} // namespace arris::toolpath
