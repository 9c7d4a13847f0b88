#include "core/pattern/clean_pieces.h"

#include "core/base/tolerances.h"
#include "core/pattern/course.h"
#include "core/pattern/join.h"
#include "core/pattern/near_index.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace arris::pattern {
namespace {

using base::Code;
using base::Problem;
using geometry::Curve;
using geometry::Point;
using geometry::Vector;

/// A line or an arc is told by its ends and its middle; of chains only those that are alike in these are compared.
struct Shape {
  Point start;
  Point middle;
  Point end;
  double length = 0;
};

Shape shapeOf(Chain piece) {
  const double length = lengthOf(piece);
  const Point middle = piece.size() == 1 ? geometry::pointAt(piece.front(), length / 2) : middleOf(piece);
  return {geometry::startPoint(piece.front()), middle, geometry::endPoint(piece.back()), length};
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

NearIndex::Numbers numbersOf(const Shape& s) {
  return {s.middle.x(), s.middle.y(), std::abs(s.end.x() - s.start.x()), std::abs(s.end.y() - s.start.y())};
}

bool sameDirection(const Shape& a, const Shape& b) {
  return (a.start - b.start).squaredNorm() <= (a.start - b.end).squaredNorm();
}

/// Pieces seen so far, one of each.
class Originals {
public:
  explicit Originals(const Pieces& pieces) : m_pieces(pieces), m_index(pieces.size()) {
    m_kept.reserve(pieces.size());
    m_shapes.reserve(pieces.size());
  }

  /// Whether the piece is new; of two copies the one that stands before stays.
  bool add(std::size_t piece, const Shape& shape) {
    const NearIndex::Numbers numbers = numbersOf(shape);
    const std::optional<std::size_t> copy =
        m_index.find(numbers, [&](std::size_t kept) { return isCopy(kept, piece, shape); });
    if (!copy) {
      m_index.add(numbers);
      m_kept.push_back(piece);
      m_shapes.push_back(shape);
      return true;
    }
    if (standsBefore(shape, m_shapes[*copy])) {
      m_kept[*copy] = piece;
      m_shapes[*copy] = shape;
    }
    return false;
  }

  [[nodiscard]] Pieces pieces() const {
    Pieces result;
    for (const std::size_t piece : m_kept) {
      result.add(m_pieces[piece]);
    }
    return result;
  }

private:
  [[nodiscard]] bool isCopy(std::size_t kept, std::size_t piece, const Shape& shape) const {
    const Shape& other = m_shapes[kept];
    if (!areCopies(other, shape)) {
      return false;
    }
    const Chain a = m_pieces[m_kept[kept]];
    const Chain b = m_pieces[piece];
    if (a.size() == 1 && b.size() == 1) {
      return true;
    }
    const double tolerance = std::min(sameWithin(other), sameWithin(shape));
    return sameDirection(other, shape) ? runAlong(a, b, tolerance) : runAlong(a, reversedChain(b), tolerance);
  }

  const Pieces& m_pieces;
  NearIndex m_index;
  std::vector<std::size_t> m_kept; ///< number of the piece
  std::vector<Shape> m_shapes;     ///< of those kept
};

bool isShort(const Curve& curve) {
  return geometry::parameterLength(curve) < base::kZeroLength;
}

std::vector<Curve> withoutShort(Chain chain, base::Problems& repairs) {
  std::vector<Curve> kept;
  for (const Curve& curve : chain) {
    if (isShort(curve)) {
      repairs.push_back(Problem(Code::ZeroLengthRemoved, {{"size_mm", geometry::parameterLength(curve)}})
                            .at(geometry::startPoint(curve)));
    } else if (kept.empty()) {
      kept.push_back(curve);
    } else {
      kept.push_back(withEnds(curve, geometry::endPoint(kept.back()), geometry::endPoint(curve)));
    }
  }
  return kept;
}

} // namespace

Pieces withoutZeroLength(Pieces pieces, base::Problems& repairs) {
  const auto hasShort = [&pieces](std::size_t piece) {
    return std::any_of(pieces[piece].begin(), pieces[piece].end(), isShort);
  };
  std::size_t first = 0;
  while (first < pieces.size() && !hasShort(first)) {
    ++first;
  }
  if (first == pieces.size()) {
    return pieces;
  }
  Pieces kept;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i >= first && hasShort(i)) {
      kept.add(withoutShort(pieces[i], repairs));
    } else {
      kept.add(pieces[i]);
    }
  }
  return kept;
}

Pieces withoutDuplicates(Pieces pieces, base::Problems& repairs) {
  Originals originals(pieces);
  bool all = true;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Shape shape = shapeOf(pieces[i]);
    if (!originals.add(i, shape)) {
      all = false;
      repairs.push_back(Problem(Code::DuplicateRemoved, {{"size_mm", shape.length}}).at(shape.middle));
    }
  }
  return all ? std::move(pieces) : originals.pieces();
}

} // namespace arris::pattern
