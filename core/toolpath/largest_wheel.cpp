#include "core/toolpath/largest_wheel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arris::toolpath {
namespace {

using geometry::Arc;
using geometry::Curve;
using geometry::Evaluation;
using geometry::Point;
using geometry::Vector;

/// What a wheel of radius 1 leaves of the edges at the joint, mm; 0 where the joint is not concave.
double reachOfFillet(const Glass& glass, EdgeId before) {
  return glass.jointAfter(before) == JointKind::Concave ? std::tan(std::abs(glass.turnAfter(before)) / 2) : 0;
}

class Search {
public:
  Search(const Glass& glass, double radius) : m_glass(glass), m_best(radius) {}

  void along(const UntouchedPart& part) {
    const Curve& edge = m_glass.edges()[part.edge];
    const double length = geometry::parameterLength(edge);
    if (const auto* arc = std::get_if<Arc>(&edge); arc && arc->curvature * m_glass.side() > 0) {
      m_best = std::min(m_best, arc->radius());
    }
    // Fillets must leave something of the edge between them.
    const double start = reachOfFillet(m_glass, m_glass.previous(part.edge));
    const double end = reachOfFillet(m_glass, part.edge);
    m_best = start + end > 0 ? std::min(m_best, length / (start + end)) : m_best;
    constexpr int kPlaces = 16;
    for (int i = 0; i <= kPlaces; ++i) {
      const double lambda = part.ground.from + (part.ground.to - part.ground.from) * i / kPlaces;
      at(part.edge, lambda, std::min(start > 0 ? lambda / start : m_best, end > 0 ? (length - lambda) / end : m_best));
    }
  }

  [[nodiscard]] double best() const {
    return m_best;
  }

private:
  // Wheels that touch the place lie inside each other, so halving finds the largest that touches nothing else. Above
  // `most` the place lies in a fillet and does not count.
  void at(EdgeId edge, double lambda, double most) {
    double high = std::min(m_best, most);
    const Evaluation place = geometry::evaluate(m_glass.edges()[edge], lambda);
    const Vector normal = m_glass.side() * geometry::leftOf(place.first);
    if (high <= 0 || fits(edge, place.point, normal, high)) {
      return;
    }
    double low = 0;
    for (int i = 0; i < 40; ++i) {
      const double middle = (low + high) / 2;
      (fits(edge, place.point, normal, middle) ? low : high) = middle;
    }
    m_best = low;
  }

  [[nodiscard]] bool fits(EdgeId edge, const Point& place, const Vector& normal, double radius) const {
    const Point wheel = place + radius * normal;
    const double least = radius * (1 - 1e-9);
    bool free = true;
    m_glass.tree().forNear(geometry::FlatBox(wheel), least, [&](std::size_t other) {
      free = isBeside(edge, static_cast<EdgeId>(other)) ||
             geometry::nearest(m_glass.edges()[other], wheel).distance >= least;
      return free;
    });
    return free;
  }

  // The edge itself, and those that it meets in a concave corner: they make a fillet.
  [[nodiscard]] bool isBeside(EdgeId edge, EdgeId other) const {
    return other == edge ||
           (other == m_glass.next(edge) && m_glass.jointAfter(edge) == JointKind::Concave) ||
           (other == m_glass.previous(edge) && m_glass.jointAfter(other) == JointKind::Concave);
  }

  const Glass& m_glass;
  double m_best;
};

} // namespace

double largestWheel(const Glass& glass, const std::vector<UntouchedPart>& parts, double radius) {
  Search search(glass, radius);
  constexpr std::size_t kMostParts = 200; // of a long way in a chopped contour some parts stand for all
  const std::size_t step = parts.size() / kMostParts + 1;
  for (std::size_t i = 0; i < parts.size(); i += step) {
    search.along(parts[i]);
  }
  return search.best();
}

} // namespace arris::toolpath
