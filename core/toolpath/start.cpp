#include "core/base/tolerances.h"
#include "core/toolpath/chain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

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

/// What a stretch of wheel path is worth as the place of the start: lines along the contour, then arcs along it, then
/// whatever there is where the wheel touches nothing but corners.
enum class Worth { Corner, Arc, Line };

struct Candidate {
  Worth worth = Worth::Corner;
  double length = 0;
  Point middle;
  StartPoint start;
};

Worth worthOf(const Step& step) {
  if (step.role != Role::Contour) {
    return Worth::Corner;
  }
  return std::holds_alternative<Line>(step.path) ? Worth::Line : Worth::Arc;
}

bool lower(const Point& a, const Point& b) {
  if (std::abs(a.y() - b.y()) > base::kSamePlace) {
    return a.y() < b.y();
  }
  return a.x() < b.x();
}

Candidate candidate(const WheelLoop& loop, std::size_t index) {
  const Step& step = loop.steps[index];
  const double length = geometry::parameterLength(step.path);
  const double along = isFullCircle(step.path) ? leastY(step.path) : length / 2;
  return {worthOf(step), step.role == Role::Transition ? 0 : length, geometry::pointAt(step.path, along),
          {index, along}};
}

} // namespace

StartPoint chooseStart(const WheelLoop& loop) {
  std::vector<Candidate> candidates;
  candidates.reserve(loop.steps.size());
  Worth worth = Worth::Corner;
  for (std::size_t i = 0; i < loop.steps.size(); ++i) {
    candidates.push_back(candidate(loop, i));
    worth = std::max(worth, candidates.back().worth);
  }
  double longest = 0;
  for (const Candidate& c : candidates) {
    longest = c.worth == worth ? std::max(longest, c.length) : longest;
  }
  std::optional<Candidate> best;
  for (const Candidate& c : candidates) {
    const bool eligible = c.worth == worth && c.length >= longest - base::kSamePlace;
    if (eligible && (!best || lower(c.middle, best->middle))) {
      best = c;
    }
  }
  return best ? best->start : StartPoint{};
}

NearestOnLoop nearestOnLoop(const Glass& glass, const WheelLoop& loop, const Point& wanted) {
  NearestOnLoop best{{}, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < loop.steps.size(); ++i) {
    const Step& step = loop.steps[i];
    if (step.role != Role::Contour || step.ground.to - step.ground.from < base::kZeroLength) {
      continue;
    }
    const Curve ground = geometry::part(glass.edges()[step.edge], step.ground.from, step.ground.to);
    const geometry::Nearest found = geometry::nearest(ground, wanted);
    if (found.distance >= best.distance) {
      continue;
    }
    const double length = step.ground.to - step.ground.from;
    const double along = found.lambda * geometry::parameterLength(step.path) / length;
    const std::size_t following = (i + 1) % loop.steps.size();
    const bool atEnd = found.lambda >= length - base::kSamePlace && loop.steps.size() > 1;
    const bool cornerFollows = atEnd && loop.steps[following].role != Role::Contour;
    const std::size_t after = cornerFollows ? (i + 2) % loop.steps.size() : following;
    best.start = atEnd ? StartPoint{after, 0} : StartPoint{i, found.lambda < base::kSamePlace ? 0 : along};
    best.distance = found.distance;
  }
  return best;
}

} // namespace arris::toolpath
