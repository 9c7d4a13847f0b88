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

/// The concave corner at which the smooth way from an edge ends, if it ends at one.
struct ConcaveEnd {
  double way = 0;   ///< from the end of the edge to the corner, mm
  double reach = 0; ///< what a wheel of radius 1 leaves of straight edges there, mm; 0 where there is no such corner
};

/// `joint(e)` is the edge before the joint that comes after e on the way, `next(e)` the edge after that.
template <typename Joint, typename Next>
ConcaveEnd concaveEnd(const Glass& glass, EdgeId edge, Joint joint, Next next) {
  constexpr int kMostEdges = 1000;
  ConcaveEnd end;
  for (int i = 0; i < kMostEdges; ++i) {
    const JointKind kind = glass.jointAfter(joint(edge));
    if (kind != JointKind::Tangential) {
      end.reach = kind == JointKind::Concave ? std::tan(std::abs(glass.turnAfter(joint(edge))) / 2) : 0;
      return end;
    }
    edge = next(edge);
    end.way += geometry::parameterLength(glass.edges()[edge]);
  }
  return {};
}

/// Nearer to a concave corner than this share of what the wheel leaves there, nothing is asked of the wheel: curved
/// edges make the fillet a little larger.
constexpr double kSurelyInFillet = 0.9;

class Search {
public:
  Search(const Glass& glass, double radius) : m_glass(glass), m_best(radius) {}

  void along(const UntouchedPart& part) {
    const Curve& edge = m_glass.edges()[part.edge];
    const double length = geometry::parameterLength(edge);
    if (const auto* arc = std::get_if<Arc>(&edge); arc && arc->curvature * m_glass.side() > 0) {
      m_best = std::min(m_best, arc->radius());
    }
    const auto itself = [](EdgeId e) { return e; };
    const auto next = [this](EdgeId e) { return m_glass.next(e); };
    const auto previous = [this](EdgeId e) { return m_glass.previous(e); };
    const ConcaveEnd start = concaveEnd(m_glass, part.edge, previous, previous);
    const ConcaveEnd end = concaveEnd(m_glass, part.edge, itself, next);
    if (start.reach + end.reach > 0) { // fillets must leave something between them
      m_best = std::min(m_best, (start.way + length + end.way) / (start.reach + end.reach));
    }
    constexpr int kPlaces = 16;
    for (int i = 0; i <= kPlaces; ++i) {
      const double lambda = part.ground.from + (part.ground.to - part.ground.from) * i / kPlaces;
      const auto outsideFillet = [this](const ConcaveEnd& corner, double way) {
        return corner.reach > 0 ? kSurelyInFillet * (corner.way + way) / corner.reach : m_best;
      };
      at(part.edge, lambda, std::min(outsideFillet(start, lambda), outsideFillet(end, length - lambda)));
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
    const double least = radius * (1 - 1e-6);
    bool free = true;
    m_glass.tree().forNear(geometry::FlatBox(wheel), least, [&](std::size_t other) {
      free = other == edge || geometry::nearest(m_glass.edges()[other], wheel).distance >= least;
      return free;
    });
    return free;
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
