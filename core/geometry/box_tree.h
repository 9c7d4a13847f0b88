#pragma once

#include "core/geometry/curve.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>
#include <vector>

namespace arris::geometry {

/// A box with nothing but its sides: cheaper to compare than `Box`.
struct FlatBox {
  double left = std::numeric_limits<double>::infinity();
  double low = std::numeric_limits<double>::infinity();
  double right = -std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  FlatBox() = default;

  explicit FlatBox(const Point& p) : left(p.x()), low(p.y()), right(p.x()), high(p.y()) {}

  explicit FlatBox(const Box& box)
      : left(box.min().x()), low(box.min().y()), right(box.max().x()), high(box.max().y()) {}

  void extend(const FlatBox& other) {
    left = std::min(left, other.left);
    low = std::min(low, other.low);
    right = std::max(right, other.right);
    high = std::max(high, other.high);
  }

  void grow(double margin) {
    left -= margin;
    low -= margin;
    right += margin;
    high += margin;
  }
};

/// Squared distance of two boxes; 0 where they overlap.
[[nodiscard]] inline double squaredDistance(const FlatBox& a, const FlatBox& b) {
  const double x = std::max({a.left - b.right, b.left - a.right, 0.0});
  const double y = std::max({a.low - b.high, b.low - a.high, 0.0});
  return x * x + y * y;
}

/// A box that holds a line or an arc, tight but for the rise of a shallow arc; cheaper than `bounds`.
[[nodiscard]] FlatBox flatBounds(const Curve& lineOrArc);

/// A binary tree over boxes in their given order: the curves of a contour lie near their neighbours, so that it needs
/// no sorting.
class BoxTree {
public:
  BoxTree() = default;

  explicit BoxTree(const std::vector<FlatBox>& boxes)
      : m_count(boxes.size()), m_leaves(std::bit_ceil(std::max<std::size_t>(boxes.size(), 1))), m_boxes(2 * m_leaves) {
    std::copy(boxes.begin(), boxes.end(), m_boxes.begin() + static_cast<std::ptrdiff_t>(m_leaves));
    for (std::size_t node = m_leaves - 1; node >= kRoot; --node) {
      m_boxes[node] = m_boxes[2 * node];
      m_boxes[node].extend(m_boxes[2 * node + 1]);
    }
  }

  /// Calls `visit(i)` for every box that comes nearer to `box` than `reach`, in order, until it returns false.
  template <typename Visit> void forNear(const FlatBox& box, double reach, Visit visit) const {
    const double reach2 = reach * reach;
    const std::size_t end = 2 * m_leaves;
    for (std::size_t node = kRoot; node < end;) {
      const bool isNear = squaredDistance(m_boxes[node], box) < reach2;
      if (isNear && node < m_leaves) {
        node *= 2;
        continue;
      }
      if (isNear && !visit(node - m_leaves)) {
        return;
      }
      node = after(node);
      if (node == kRoot) {
        return;
      }
    }
  }

  /// The least `distance(i)` below `limit` over all boxes; `limit` where there is none. `distance(i)` is never less
  /// than the distance of box i from `point`.
  template <typename Distance> [[nodiscard]] double least(const Point& point, double limit, Distance distance) const {
    if (m_count > 0) {
      descend(kRoot, FlatBox(point), limit, distance);
    }
    return limit;
  }

private:
  static constexpr std::size_t kRoot = 1; // the children of node n are 2n and 2n + 1

  /// The node that follows once everything below `node` is done; the root at the end.
  static std::size_t after(std::size_t node) {
    return (node + 1) >> static_cast<unsigned>(std::countr_zero(node + 1));
  }

  template <typename Distance>
  void descend(std::size_t node, const FlatBox& point, double& limit, const Distance& distance) const {
    if (squaredDistance(m_boxes[node], point) >= limit * limit) {
      return;
    }
    if (node >= m_leaves) {
      limit = std::min(limit, distance(node - m_leaves));
      return;
    }
    const bool rightFirst = squaredDistance(m_boxes[2 * node + 1], point) < squaredDistance(m_boxes[2 * node], point);
    descend(2 * node + (rightFirst ? 1 : 0), point, limit, distance);
    descend(2 * node + (rightFirst ? 0 : 1), point, limit, distance);
  }

  std::size_t m_count = 0;
  std::size_t m_leaves = 1; ///< a power of two; leaf i is node m_leaves + i
  std::vector<FlatBox> m_boxes;
};

} // namespace arris::geometry
