#include "core/toolpath/chain.h"

#include "core/base/numbers.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace arris::toolpath {
namespace {

using geometry::Arc;
using geometry::Curve;

double groundLength(const WheelLoop& loop) {
  double sum = 0;
  for (const Step& step : loop.steps) {
    sum += step.ground.to - step.ground.from;
  }
  return sum;
}

double pathLength(const WheelLoop& loop) {
  double sum = 0;
  for (const Step& step : loop.steps) {
    sum += geometry::parameterLength(step.path);
  }
  return sum;
}

/// How the overlap is measured: along the glass, or along the path where the wheel touches nothing but corners.
double measured(const WheelLoop& loop) {
  const double ground = groundLength(loop);
  return ground > 0 ? ground : pathLength(loop);
}

/// Walks round a loop and notes the wheel path.
class Tracer {
public:
  explicit Tracer(const WheelLoop& loop)
      : m_loop(loop), m_onGlass(groundLength(loop) > 0), m_ids(loop.corners.size(), 0) {}

  /// The part of a step from λ = `from` to `to` of its path, with the kink at its end where that belongs to it.
  void step(std::size_t index, double from, double to) {
    const Step& step = m_loop.steps[index];
    const bool reachesEnd = to >= geometry::parameterLength(step.path);
    const int stopCorner = reachesEnd && step.stopAtEnd ? idOf(step.stopCorner) : 0;
    if (to - from < base::kZeroLength) {
      stopEarlier(reachesEnd && step.stopAtEnd, stopCorner);
      return;
    }
    PathSegment segment{from <= 0 && reachesEnd ? step.path : geometry::part(step.path, from, to), step.role};
    segment.corner = idOf(step.corner);
    if (step.role == Role::Transition) {
      segment.speedCap = m_loop.corners[static_cast<std::size_t>(step.corner)].transitionSpeed;
    }
    segment.stopAtEnd = reachesEnd && step.stopAtEnd;
    segment.stopCorner = stopCorner;
    m_result.chain.segments.push_back(segment);
    m_result.lastEdge = step.edge;
  }

  /// How much of the overlap a step takes, mm.
  [[nodiscard]] double share(std::size_t index) const {
    const Step& step = m_loop.steps[index];
    return m_onGlass ? step.ground.to - step.ground.from : geometry::parameterLength(step.path);
  }

  Traced take() {
    for (base::Problem problem : m_loop.problems) {
      problem.corner = problem.corner ? std::optional(idOf(*problem.corner)) : std::nullopt;
      m_result.problems.push_back(std::move(problem));
    }
    return std::move(m_result);
  }

private:
  /// The number of a corner, given where it is met first.
  int idOf(int corner) {
    if (corner == kNoCorner) {
      return 0;
    }
    int& id = m_ids[static_cast<std::size_t>(corner)];
    if (id == 0) {
      m_result.corners.push_back(m_loop.corners[static_cast<std::size_t>(corner)]);
      id = m_result.corners.back().id = static_cast<int>(m_result.corners.size());
    }
    return id;
  }

  // The kink behind a step without length comes at the end of the step before.
  void stopEarlier(bool stops, int corner) {
    if (stops && !m_result.chain.segments.empty()) {
      m_result.chain.segments.back().stopAtEnd = true;
      m_result.chain.segments.back().stopCorner = corner;
    }
  }

  const WheelLoop& m_loop;
  bool m_onGlass;
  std::vector<int> m_ids;
  Traced m_result;
};

// Where the free space curves towards the wheel with less than twice the lead's radius, half of that radius fits.
double leadRadius(const Curve& path, double side, double lead) {
  const auto* arc = std::get_if<Arc>(&path);
  const bool hollow = arc && arc->curvature * side > 0;
  return hollow ? std::min(lead, arc->radius() / 2) : lead;
}

} // namespace

Traced traceLoop(const Glass& glass, const WheelLoop& loop, const StartPoint& start, double overlap) {
  const std::size_t count = loop.steps.size();
  const auto lengthOf = [&](std::size_t index) { return geometry::parameterLength(loop.steps[index].path); };
  Tracer tracer(loop);
  tracer.step(start.step, start.along, lengthOf(start.step));
  for (std::size_t i = 1; i < count; ++i) {
    tracer.step((start.step + i) % count, 0, lengthOf((start.step + i) % count));
  }
  // From here over the start point and on, measured from the beginning of the start's step.
  double left = overlap + tracer.share(start.step) * start.along / lengthOf(start.step);
  for (std::size_t i = start.step; left > base::kZeroLength; i = (i + 1) % count) {
    const double share = tracer.share(i);
    tracer.step(i, 0, left < share ? lengthOf(i) * left / share : lengthOf(i));
    left -= share;
  }
  Traced result = tracer.take();
  result.chain.contour = glass.ringOf(loop.steps[start.step].edge).contour;
  result.chain.segments.back().stopAtEnd = false; // leads follow, or the wheel stops anyway
  result.chain.segments.back().stopCorner = 0;
  return result;
}

double overlapOn(const WheelLoop& loop, int contour, const recipe::Recipe& recipe, base::Problems& problems) {
  const double quarter = measured(loop) / 4;
  if (recipe.overlap > quarter) {
    problems.push_back(
        base::Problem(base::Code::OverlapShortened, {{"used_mm", quarter}, {"wanted_mm", recipe.overlap}})
            .ofContour(contour));
  }
  return std::min(recipe.overlap, quarter);
}

Arc leadInTo(const Curve& path, const recipe::Recipe& recipe) {
  const double side = wheelSide(recipe.direction);
  const double radius = leadRadius(path, side, recipe.lead);
  // Seen from the glass, and turned round.
  const Arc backwards{geometry::startPoint(path), -geometry::startTangent(path), -side / radius,
                      radius * base::kPi / 2};
  return std::get<Arc>(geometry::reversed(backwards));
}

void addLeads(Chain& chain, const recipe::Recipe& recipe) {
  const double side = wheelSide(recipe.direction);
  const Curve& last = chain.segments.back().shape;
  const double radius = leadRadius(last, side, recipe.lead);
  const Arc out{geometry::endPoint(last), geometry::endTangent(last), side / radius, radius * base::kPi / 2};
  const Arc in = leadInTo(chain.segments.front().shape, recipe);
  chain.segments.insert(chain.segments.begin(), PathSegment{in, Role::LeadIn});
  chain.segments.push_back(PathSegment{out, Role::LeadOut});
}

} // namespace arris::toolpath
