#include "core/pattern/curve_tree.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace arris::pattern {
namespace {

using base::kPi;
using geometry::Arc;
using geometry::Curve;
using geometry::Point;

/// λ of the first point at which a curve that only rises or only falls between `from` and `to` reaches the height `y`.
double heightReached(const Curve& curve, double from, double to, double y) {
  const bool rises = geometry::pointAt(curve, from).y() < geometry::pointAt(curve, to).y();
  for (int i = 0; i < 60; ++i) {
    const double middle = (from + to) / 2;
    ((geometry::pointAt(curve, middle).y() < y) == rises ? from : to) = middle;
  }
  return from;
}

// A ray from the point along +X meets a stretch that only rises or falls once or not at all; its lower end belongs to
// it and its upper end does not.
int crossingsOfStretch(const Curve& curve, double from, double to, const Point& point) {
  const Point start = geometry::pointAt(curve, from);
  const Point end = geometry::pointAt(curve, to);
  if ((start.y() <= point.y()) == (end.y() <= point.y())) {
    return 0;
  }
  return geometry::pointAt(curve, heightReached(curve, from, to, point.y())).x() > point.x() ? 1 : 0;
}

int crossingsOfCurve(const Curve& curve, const Point& point) {
  const double length = geometry::parameterLength(curve);
  const auto* arc = std::get_if<Arc>(&curve);
  if (!arc) {
    return crossingsOfStretch(curve, 0, length, point);
  }
  // The direction of travel is parallel to X every half turn.
  const double heading = std::atan2(arc->tangent.y(), arc->tangent.x());
  const double turned = arc->curvature > 0 ? -heading : heading; // from there to the first such place
  double next = (turned - kPi * std::floor(turned / kPi)) * arc->radius();
  int count = 0;
  for (double from = 0; from < length;) {
    const double to = std::min(next, length);
    count += to > from ? crossingsOfStretch(curve, from, to, point) : 0;
    from = to;
    next += kPi * arc->radius();
  }
  return count;
}

} // namespace

CurveTree::CurveTree(const std::vector<Curve>& chain)
    : m_chain(chain), m_leaves(std::bit_ceil(chain.size())), m_boxes(2 * m_leaves) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    m_boxes[m_leaves + i] = geometry::bounds(chain[i]);
  }
  for (std::size_t node = m_leaves - 1; node >= kRoot; --node) {
    m_boxes[node] = m_boxes[2 * node].merged(m_boxes[2 * node + 1]);
  }
}

bool CurveTree::surrounds(const Point& point) const {
  return crossings(kRoot, point) % 2 == 1;
}

int CurveTree::crossings(std::size_t node, const Point& point) const {
  const geometry::Box& box = m_boxes[node];
  if (box.isEmpty() || point.y() < box.min().y() || point.y() > box.max().y() || point.x() > box.max().x()) {
    return 0;
  }
  return isLeaf(node) ? crossingsOfCurve(m_chain[node - m_leaves], point)
                      : crossings(2 * node, point) + crossings(2 * node + 1, point);
}

} // namespace arris::pattern
