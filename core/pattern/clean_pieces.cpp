#include "core/pattern/clean_pieces.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <tuple>

namespace arris::pattern {
namespace {

using base::Code;
using base::Problem;
using geometry::Curve;
using geometry::Point;
using geometry::Vector;

/// A line or an arc is told by its ends and its middle.
struct Shape {
  Point start;
  Point middle;
  Point end;
  double length = 0;
};

Shape shapeOf(const Curve& piece) {
  const double length = geometry::parameterLength(piece);
  return {geometry::startPoint(piece), geometry::pointAt(piece, length / 2), geometry::endPoint(piece), length};
}

// Short chords next to each other are near without being copies: never more than a tenth of the length counts as equal.
double sameWithin(const Shape& shape) {
  return std::min(base::kSamePlace, shape.length / 10);
}

bool near(const Point& a, const Point& b, double tolerance) {
  return (a - b).squaredNorm() <= tolerance * tolerance;
}

bool areCopies(const Shape& a, const Shape& b) {
  const double tolerance = std::min(sameWithin(a), sameWithin(b));
  return near(a.middle, b.middle, tolerance) && ((near(a.start, b.start, tolerance) && near(a.end, b.end, tolerance)) ||
                                                 (near(a.start, b.end, tolerance) && near(a.end, b.start, tolerance)));
}

/// A total order of shapes that does not know their direction.
bool standsBefore(const Shape& a, const Shape& b) {
  const auto key = [](const Shape& s) {
    std::tuple lower(s.start.y(), s.start.x());
    std::tuple upper(s.end.y(), s.end.x());
    if (upper < lower) {
      std::swap(lower, upper);
    }
    return std::tuple(lower, upper, s.middle.y(), s.middle.x());
  };
  return key(a) < key(b);
}

/// Finds copies among shapes by a hash over four numbers that do not know the direction: the middle, and how far the
/// ends are apart along X and Y. A copy's numbers differ by up to `kSamePlace`, so it may lie in a neighbouring cell.
class CopyIndex {
public:
  explicit CopyIndex(std::size_t shapes) : m_buckets(bucketCount(shapes), kNone) {
    m_shapes.reserve(shapes);
    m_next.reserve(shapes);
  }

  /// The number of a shape kept before that is a copy of this one.
  [[nodiscard]] std::optional<std::size_t> find(const Shape& shape) const {
    std::array<std::array<std::int64_t, 2>, 4> range{};
    const std::array<double, 4> n = numbers(shape);
    for (std::size_t i = 0; i < n.size(); ++i) {
      range[i] = {cell(n[i] - base::kSamePlace), cell(n[i] + base::kSamePlace)};
    }
    for (unsigned choice = 0; choice < 16; ++choice) {
      std::array<std::int64_t, 4> cells{};
      bool repeated = false;
      for (std::size_t i = 0; i < cells.size(); ++i) {
        const bool upper = ((choice >> i) & 1U) != 0;
        repeated = repeated || (upper && range[i][0] == range[i][1]);
        cells[i] = range[i][upper ? 1 : 0];
      }
      if (repeated) {
        continue;
      }
      for (std::uint32_t k = m_buckets[bucket(cells)]; k != kNone; k = m_next[k]) {
        if (areCopies(m_shapes[k], shape)) {
          return k;
        }
      }
    }
    return std::nullopt;
  }

  void add(const Shape& shape) {
    std::array<std::int64_t, 4> cells{};
    const std::array<double, 4> n = numbers(shape);
    std::transform(n.begin(), n.end(), cells.begin(), cell);
    std::uint32_t& head = m_buckets[bucket(cells)];
    m_next.push_back(head);
    head = static_cast<std::uint32_t>(m_shapes.size());
    m_shapes.push_back(shape);
  }

  [[nodiscard]] Shape& operator[](std::size_t number) {
    return m_shapes[number];
  }

private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  static std::size_t bucketCount(std::size_t shapes) {
    std::size_t count = 16;
    while (count < 2 * shapes) {
      count *= 2;
    }
    return count;
  }

  static std::array<double, 4> numbers(const Shape& s) {
    return {s.middle.x(), s.middle.y(), std::abs(s.end.x() - s.start.x()), std::abs(s.end.y() - s.start.y())};
  }

  static std::int64_t cell(double x) {
    constexpr double kCell = 64 * base::kSamePlace;
    return static_cast<std::int64_t>(std::floor(x / kCell));
  }

  [[nodiscard]] std::size_t bucket(const std::array<std::int64_t, 4>& cells) const {
    std::uint64_t hash = 0;
    for (const std::int64_t c : cells) {
      hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15U;
      hash ^= hash >> 32U;
    }
    return hash & (m_buckets.size() - 1);
  }

  std::vector<std::uint32_t> m_buckets; ///< first shape of each
  std::vector<std::uint32_t> m_next;    ///< next shape in the same bucket
  std::vector<Shape> m_shapes;
};

} // namespace

std::vector<Curve> withoutZeroLength(std::vector<Curve> pieces, base::Problems& repairs) {
  const auto isShort = [&repairs](const Curve& piece) {
    const double length = geometry::parameterLength(piece);
    if (length >= base::kZeroLength) {
      return false;
    }
    repairs.push_back(Problem(Code::ZeroLengthRemoved, {{"size_mm", length}}).at(geometry::startPoint(piece)));
    return true;
  };
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(), isShort), pieces.end());
  return pieces;
}

std::vector<Curve> withoutDuplicates(const std::vector<Curve>& pieces, base::Problems& repairs) {
  CopyIndex index(pieces.size());
  std::vector<Curve> kept;
  kept.reserve(pieces.size());
  for (const Curve& piece : pieces) {
    const Shape shape = shapeOf(piece);
    const std::optional<std::size_t> copy = index.find(shape);
    if (!copy) {
      index.add(shape);
      kept.push_back(piece);
      continue;
    }
    repairs.push_back(Problem(Code::DuplicateRemoved, {{"size_mm", shape.length}}).at(shape.middle));
    if (standsBefore(shape, index[*copy])) {
      kept[*copy] = piece;
      index[*copy] = shape;
    }
  }
  return kept;
}

} // namespace arris::pattern
