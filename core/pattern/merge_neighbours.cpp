#include "core/pattern/merge_neighbours.h"

#include "core/base/numbers.h"
#include "core/base/tolerances.h"
#include "core/pattern/join.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace arris::pattern {
namespace {

using base::kPi;
using geometry::Arc;
using geometry::Curve;
using geometry::Line;
using geometry::Point;

/// A merged curve may pass the joints that it swallowed at this distance, mm, all of them together: the rounding of a
/// file with six decimals.
constexpr double kSameCurve = 1e-6;

/// A curve made of several, and how far all their joints moved together, mm.
struct Merged {
  Curve curve;
  double moved = 0;
};

double distanceTo(const Curve& curve, const Point& p) {
  return geometry::nearest(curve, p).distance;
}

std::optional<Merged> mergeLines(const Line& a, const Line& b, double moved) {
  const Line whole{a.from, b.to};
  if ((b.to - b.from).dot(a.to - a.from) <= 0) {
    return std::nullopt;
  }
  moved += distanceTo(whole, a.to);
  return moved <= kSameCurve ? std::optional(Merged{whole, moved}) : std::nullopt;
}

std::optional<Merged> mergeArcs(const Arc& a, const Arc& b, double moved) {
  const double shorter = std::min(a.length, b.length);
  if (a.curvature * b.curvature <= 0 || std::abs(a.curvature - b.curvature) * shorter * shorter > 8 * kSameCurve ||
      std::abs(geometry::turn(geometry::endTangent(a), b.tangent)) > base::kSmoothTurn) {
    return std::nullopt;
  }
  const Point end = geometry::endPoint(b);
  const double sweep = a.sweep() + b.sweep();
  if (std::abs(sweep) > 2 * kPi + kSameCurve) {
    return std::nullopt;
  }
  const Arc longer{a.start, a.tangent, sweep / (a.length + b.length), a.length + b.length};
  const bool closes = std::abs(sweep) > kPi && (end - a.start).norm() <= kSameCurve;
  const Curve whole = closes ? fullCircle(longer) : withEnds(longer, a.start, end);
  const double off = std::max({distanceTo(whole, b.start), distanceTo(whole, geometry::pointAt(a, a.length / 2)),
                               distanceTo(whole, geometry::pointAt(b, b.length / 2))});
  moved += off;
  return moved <= kSameCurve ? std::optional(Merged{whole, moved}) : std::nullopt;
}

std::optional<Merged> merge(const Merged& a, const Merged& b) {
  const double moved = a.moved + b.moved;
  if (std::holds_alternative<Line>(a.curve) && std::holds_alternative<Line>(b.curve)) {
    return mergeLines(std::get<Line>(a.curve), std::get<Line>(b.curve), moved);
  }
  if (std::holds_alternative<Arc>(a.curve) && std::holds_alternative<Arc>(b.curve)) {
    return mergeArcs(std::get<Arc>(a.curve), std::get<Arc>(b.curve), moved);
  }
  return std::nullopt;
}

} // namespace

double mergeNeighbours(std::vector<Curve>& closedChain) {
  std::vector<Merged> runs;
  for (const Curve& curve : closedChain) {
    std::optional<Merged> longer = runs.empty() ? std::nullopt : merge(runs.back(), {curve});
    if (longer) {
      runs.back() = *longer;
    } else {
      runs.push_back({curve});
    }
  }
  if (runs.size() > 1) { // across the start of the chain
    if (const std::optional<Merged> longer = merge(runs.back(), runs.front())) {
      runs.front() = *longer;
      runs.pop_back();
    }
  }
  closedChain.clear();
  double moved = 0;
  for (const Merged& run : runs) {
    closedChain.push_back(run.curve);
    moved = std::max(moved, run.moved);
  }
  return moved;
}

} // namespace arris::pattern
