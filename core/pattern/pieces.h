#pragma once

#include "core/geometry/curve.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace arris::pattern {

/// The pieces of a drawing, mm, in the order of the file. Each is a chain of one or more lines and arcs, every one
/// starting where the one before ends (to rounding): what a single entity drew without a break, so that nothing can be
/// joined into the middle of it. All in one block of memory: most pieces are single lines.
class Pieces {
public:
  Pieces() = default;

  /// Each curve a piece of its own.
  explicit Pieces(std::vector<geometry::Curve> singles) : m_curves(std::move(singles)) {
    for (std::size_t i = 1; i <= m_curves.size(); ++i) {
      m_ends.push_back(static_cast<std::uint32_t>(i));
    }
  }

  /// A piece of one curve.
  void add(const geometry::Curve& curve) {
    m_curves.push_back(curve);
    m_ends.push_back(static_cast<std::uint32_t>(m_curves.size()));
  }

  /// A piece of several curves; none where the chain is empty.
  void add(std::span<const geometry::Curve> chain) {
    if (!chain.empty()) {
      m_curves.insert(m_curves.end(), chain.begin(), chain.end());
      m_ends.push_back(static_cast<std::uint32_t>(m_curves.size()));
    }
  }

  [[nodiscard]] std::size_t size() const {
    return m_ends.size();
  }

  [[nodiscard]] bool empty() const {
    return m_ends.empty();
  }

  /// The curves of one piece; never empty.
  [[nodiscard]] std::span<const geometry::Curve> operator[](std::size_t piece) const {
    const std::size_t begin = piece == 0 ? 0 : m_ends[piece - 1];
    return {m_curves.data() + begin, m_ends[piece] - begin};
  }

private:
  std::vector<geometry::Curve> m_curves;
  std::vector<std::uint32_t> m_ends; ///< index behind the last curve of each piece
};

} // namespace arris::pattern
