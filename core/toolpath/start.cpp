#include "core/base/tolerances.h"
#include "core/toolpath/chain.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>

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

// Rounded, so that rounding does not decide and the order is one.
bool lower(const Point& a, const Point& b) {
  const auto place = [](const Point& p) {
    return std::tuple(std::round(p.y() / base::kSamePlace), std::round(p.x() / base::kSamePlace), p.y(), p.x());
  };
  return place(a) < place(b);
}

Candidate candidate(const WheelLoop& loop, std::size_t index) {
  const Step& step = loop.steps[index];
  const double length = geometry::parameterLength(step.path);
  const double along = isFullCircle(step.path) ? leastY(step.path) : length / 2;
  return {worthOf(step), length, geometry::pointAt(step.path, along), {index, along}};
}

} // namespace

std::vector<StartPoint> startsOn(const WheelLoop& loop) {
  std::vector<Candidate> candidates;
  candidates.reserve(loop.steps.size());
  for (std::size_t i = 0; i < loop.steps.size(); ++i) {
    if (loop.steps[i].role != Role::Transition) {
      candidates.push_back(candidate(loop, i));
    }
  }
  // Lengths within `kSamePlace` of the longest count as equal: those come first, then the next longest, and so on.
  const auto longerFirst = [](const Candidate& a, const Candidate& b) {
    return std::pair(a.worth, a.length) > std::pair(b.worth, b.length);
  };
  std::stable_sort(candidates.begin(), candidates.end(), longerFirst);
  for (auto first = candidates.begin(); first != candidates.end();) {
    const auto end = std::find_if(first, candidates.end(), [first](const Candidate& c) {
      return c.worth != first->worth || c.length < first->length - base::kSamePlace;
    });
    std::sort(first, end, [](const Candidate& a, const Candidate& b) { return lower(a.middle, b.middle); });
    first = end;
  }
  std::vector<StartPoint> starts;
  starts.reserve(candidates.size());
  std::transform(candidates.begin(), candidates.end(), std::back_inserter(starts),
                 [](const Candidate& c) { return c.start; });
  return starts;
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
