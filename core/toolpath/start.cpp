#include "core/base/tolerances.h"
#include "core/toolpath/chain.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arris::toolpath {
namespace {

using geometry::Arc;
using geometry::Curve;
using geometry::Line;
using geometry::Point;

bool isFullCircle(const Curve& curve) {
  const auto* arc = std::get_if<Arc>(&curve);
  return arc && (geometry::endPoint(curve) - arc->start).norm() < base::kSamePlace && std::abs(arc->sweep()) > 1;
}

double leastY(const Curve& circle) {
  const Arc& arc = std::get<Arc>(circle);
  return geometry::nearest(circle, arc.center() - Point(0, arc.radius())).lambda;
}

/// A stretch of wheel path that may hold the start: better ones come first.
struct Candidate {
  bool isLine = false;
  double length = 0;
  Point middle;
  StartPoint start;
};

bool lower(const Point& a, const Point& b) {
  if (std::abs(a.y() - b.y()) > base::kSamePlace) {
    return a.y() < b.y();
  }
  return a.x() < b.x();
}

Candidate candidate(const CompensatedContour& contour, std::size_t edge) {
  const Edge& e = contour.edges[edge];
  const double onPath = isFullCircle(e.path) ? leastY(e.path) : geometry::parameterLength(e.path) / 2;
  const double scale = geometry::parameterLength(e.contour) / geometry::parameterLength(e.path);
  return {std::holds_alternative<Line>(e.path),
          geometry::parameterLength(e.path),
          geometry::pointAt(e.path, onPath),
          {edge, onPath * scale}};
}

StartPoint longestEdge(const CompensatedContour& contour) {
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < contour.edges.size(); ++i) {
    candidates.push_back(candidate(contour, i));
  }
  const bool anyLine = std::any_of(candidates.begin(), candidates.end(), [](const Candidate& c) { return c.isLine; });
  double longest = 0;
  for (const Candidate& c : candidates) {
    longest = c.isLine == anyLine ? std::max(longest, c.length) : longest;
  }
  std::optional<Candidate> best;
  for (const Candidate& c : candidates) {
    const bool eligible = c.isLine == anyLine && c.length >= longest - base::kSamePlace;
    if (eligible && (!best || lower(c.middle, best->middle))) {
      best = c;
    }
  }
  return best ? best->start : StartPoint{};
}

// At a corner the edge after it is taken, from its beginning.
StartPoint nearestTo(const CompensatedContour& contour, const Point& wanted) {
  StartPoint best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < contour.edges.size(); ++i) {
    const Curve& edge = contour.edges[i].contour;
    const geometry::Nearest found = geometry::nearest(edge, wanted);
    if (found.distance < least) {
      least = found.distance;
      const bool atEnd = found.lambda >= geometry::parameterLength(edge) - base::kSamePlace;
      best = atEnd ? StartPoint{(i + 1) % contour.edges.size(), 0} : StartPoint{i, found.lambda};
    }
  }
  best.along = best.along < base::kSamePlace ? 0 : best.along;
  return best;
}

} // namespace

StartPoint chooseStart(const CompensatedContour& contour, const recipe::Recipe& recipe) {
  return recipe.start ? nearestTo(contour, *recipe.start) : longestEdge(contour);
}

} // namespace arris::toolpath
