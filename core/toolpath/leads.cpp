#include "core/base/numbers.h"
#include "core/base/tolerances.h"
#include "core/toolpath/chain.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <set>

namespace arris::toolpath {
namespace {

using base::Code;
using base::Problem;
using base::Problems;
using geometry::Curve;
using geometry::Point;

/// Where the wheel goes down and comes up it stands clear of the blank by this much, mm.
constexpr double kPlungeClearance = 1;

/// An edge that turns by less than this from the one before it counts as the same edge for a lead, rad: a corner that
/// is blunt, or as blunt in the other direction.
constexpr double kSameEdge = base::kPi - kBluntAngle;

bool isSameEdge(const Glass& glass, EdgeId before, const recipe::Recipe& recipe) {
  const double turn = std::abs(glass.turnAfter(before));
  if (glass.jointAfter(before) != JointKind::Convex) {
    return turn <= kSameEdge;
  }
  return turn <= kSameEdge && !cornerFigures(base::kPi - turn, recipe).relief;
}

// The edge that a lead enters or leaves: all that is joined to it tangentially or at blunt corners. On the way along a
// contour with short edges the wheel touches several of them at once anyway.
std::set<EdgeId> entered(const Glass& glass, EdgeId edge, double reach, const recipe::Recipe& recipe) {
  std::set<EdgeId> result{edge};
  const auto walk = [&](auto following, auto joint) {
    double way = 0;
    for (EdgeId e = edge; way < reach && isSameEdge(glass, joint(e), recipe) && result.insert(following(e)).second;) {
      e = following(e);
      way += geometry::parameterLength(glass.edges()[e]);
    }
  };
  walk([&](EdgeId e) { return glass.next(e); }, [&](EdgeId e) { return e; });
  walk([&](EdgeId e) { return glass.previous(e); }, [&](EdgeId e) { return glass.previous(e); });
  return result;
}

Problem noLead(const char* what, double needed, double distance, const Point& place, int contour) {
  return Problem(Code::NoLead, {{"what", what}, {"needed_mm", needed}, {"distance_mm", distance}})
      .at(place)
      .ofContour(contour);
}

// Whether along the lead the wheel keeps its distance; `edge` is the one that the lead meets.
std::optional<Problem> checkLead(const Curve& lead, const char* what, EdgeId edge, const Glass& glass,
                                 const recipe::Recipe& recipe) {
  const double clear = recipe.wheelRadius + recipe.depth;
  const double length = geometry::parameterLength(lead);
  const std::set<EdgeId> own = entered(glass, edge, 4 * (clear + length), recipe);
  std::optional<Problem> problem;
  glass.tree().forNear(geometry::flatBounds(lead), clear, [&](std::size_t index) {
    const double needed =
        own.contains(static_cast<EdgeId>(index)) ? recipe.wheelRadius - base::kContourAccuracy : clear;
    const double distance = geometry::distance(lead, glass.edges()[index], needed);
    if (distance < needed - base::kZeroLength) {
      problem = noLead(what, needed, distance, geometry::startPoint(lead), glass.ringOf(edge).contour);
    }
    return !problem;
  });
  return problem;
}

std::optional<Problem> checkPlunge(const Point& place, const char* what, EdgeId edge, const Glass& glass,
                                   const recipe::Recipe& recipe) {
  const double clear = recipe.wheelRadius + recipe.depth + kPlungeClearance;
  const double distance = glass.distance(place, clear);
  if (distance < clear - base::kZeroLength) {
    return noLead(what, clear, distance, place, glass.ringOf(edge).contour);
  }
  return std::nullopt;
}

Problems allOf(std::initializer_list<std::optional<Problem>> found) {
  Problems problems;
  for (const std::optional<Problem>& problem : found) {
    if (problem) {
      problems.push_back(*problem);
    }
  }
  return problems;
}

} // namespace

Problems checkLeads(const Chain& chain, EdgeId first, EdgeId last, const Glass& glass, const recipe::Recipe& recipe) {
  const Curve& in = chain.segments.front().shape;
  const Curve& out = chain.segments.back().shape;
  return allOf({checkPlunge(geometry::startPoint(in), "go down", first, glass, recipe),
                checkPlunge(geometry::endPoint(out), "come up", last, glass, recipe),
                checkLead(in, "lead in", first, glass, recipe),
                checkLead(geometry::reversed(out), "lead out", last, glass, recipe)});
}

Problems checkLeadIn(const geometry::Arc& lead, EdgeId edge, const Glass& glass, const recipe::Recipe& recipe) {
  return allOf(
      {checkPlunge(lead.start, "go down", edge, glass, recipe), checkLead(lead, "lead in", edge, glass, recipe)});
}

} // namespace arris::toolpath
