#pragma once

#include <QPointF>

#include <cmath>
#include <cstdint>
#include <unordered_set>

namespace arris::ui {

/// Lets one thing through for each square of the plane, the first: where very many lie over each other, the others
/// would not be seen.
class OnePerCell {
public:
  /// `size` is the side of the squares, above 0.
  explicit OnePerCell(double size) : m_size(size) {}

  /// Whether nothing else has been in the square of this place.
  bool take(const QPointF& place) {
    const auto column = static_cast<std::int64_t>(std::floor(place.x() / m_size));
    const auto row = static_cast<std::int64_t>(std::floor(place.y() / m_size));
    return m_taken.insert(column * kMostColumns + row).second;
  }

private:
  static constexpr std::int64_t kMostColumns = std::int64_t{1} << 31;

  double m_size;
  std::unordered_set<std::int64_t> m_taken;
};

} // namespace arris::ui
