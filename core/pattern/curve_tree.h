#pragma once

#include "core/geometry/curve.h"

#include <cstddef>
#include <vector>

namespace arris::pattern {

/// A tree of boxes over the lines and arcs of a closed chain, in the chain's own order: neighbours lie near each other,
/// so it needs no sorting.
class CurveTree {
public:
  /// `chain` must outlive the tree.
  explicit CurveTree(const std::vector<geometry::Curve>& chain);

  /// Calls `visit(i, j)` with i < j for all curves whose boxes come nearer than `margin`, until it returns false.
  template <typename Visit> void forPairs(double margin, Visit visit) const {
    [[maybe_unused]] const bool finished = pairsWithin(kRoot, margin, visit);
  }

  /// Calls `visit(i, j)` for all curves i of this chain and j of the other whose boxes come nearer than `margin`, until
  /// it returns false.
  template <typename Visit> void forPairsWith(const CurveTree& other, double margin, Visit visit) const {
    [[maybe_unused]] const bool finished = pairsAcross(kRoot, other, kRoot, margin, visit);
  }

  /// Whether the chain goes round the point.
  [[nodiscard]] bool surrounds(const geometry::Point& point) const;

  [[nodiscard]] const geometry::Box& bounds() const {
    return m_boxes[kRoot];
  }

private:
  static constexpr std::size_t kRoot = 1; // the children of node n are 2n and 2n + 1

  [[nodiscard]] bool isLeaf(std::size_t node) const {
    return node >= m_leaves;
  }

  static bool apart(const geometry::Box& a, const geometry::Box& b, double margin) {
    return a.isEmpty() || b.isEmpty() || a.squaredExteriorDistance(b) > margin * margin;
  }

  template <typename Visit> bool pairsWithin(std::size_t node, double margin, Visit& visit) const {
    if (isLeaf(node) || m_boxes[node].isEmpty()) {
      return true;
    }
    return pairsWithin(2 * node, margin, visit) && pairsWithin(2 * node + 1, margin, visit) &&
           pairsBetween(2 * node, 2 * node + 1, margin, visit);
  }

  // Both nodes are on the same level, `a` before `b`.
  template <typename Visit> bool pairsBetween(std::size_t a, std::size_t b, double margin, Visit& visit) const {
    if (apart(m_boxes[a], m_boxes[b], margin)) {
      return true;
    }
    if (isLeaf(a)) {
      return visit(a - m_leaves, b - m_leaves);
    }
    return pairsBetween(2 * a, 2 * b, margin, visit) && pairsBetween(2 * a, 2 * b + 1, margin, visit) &&
           pairsBetween(2 * a + 1, 2 * b, margin, visit) && pairsBetween(2 * a + 1, 2 * b + 1, margin, visit);
  }

  // The larger of the two nodes is divided first.
  template <typename Visit>
  bool pairsAcross(std::size_t a, const CurveTree& other, std::size_t b, double margin, Visit& visit) const {
    if (apart(m_boxes[a], other.m_boxes[b], margin)) {
      return true;
    }
    if (isLeaf(a) && other.isLeaf(b)) {
      return visit(a - m_leaves, b - other.m_leaves);
    }
    const bool divideOther =
        isLeaf(a) || (!other.isLeaf(b) && other.m_boxes[b].sizes().sum() > m_boxes[a].sizes().sum());
    return divideOther ? pairsAcross(a, other, 2 * b, margin, visit) && pairsAcross(a, other, 2 * b + 1, margin, visit)
                       : pairsAcross(2 * a, other, b, margin, visit) && pairsAcross(2 * a + 1, other, b, margin, visit);
  }

  [[nodiscard]] int crossings(std::size_t node, const geometry::Point& point) const;

  const std::vector<geometry::Curve>& m_chain;
  std::size_t m_leaves; ///< a power of two; leaf i is node m_leaves + i
  std::vector<geometry::Box> m_boxes;
};

} // namespace arris::pattern
