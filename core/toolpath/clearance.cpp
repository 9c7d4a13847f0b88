#include "core/base/tolerances.h"
#include "core/toolpath/chain.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <limits>

namespace arris::toolpath {
namespace {

using base::Code;
using base::Problem;
using base::Problems;
using geometry::Curve;
using geometry::Point;

/// Where the wheel goes down and comes up it stands clear of the blank by this much, mm.
constexpr double kPlungeClearance = 1;

double leastDistance(const std::vector<CompensatedContour>& all, const Point& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const CompensatedContour& contour : all) {
    for (const Edge& edge : contour.edges) {
      least = std::min(least, geometry::nearest(edge.contour, point).distance);
    }
  }
  return least;
}

bool isFragile(const Joint& joint) {
  return joint.corner && joint.corner->treatment == Treatment::Transition;
}

// The edge that a lead enters or leaves: all that is joined to it tangentially or at blunt corners. On the way round a
// contour with short edges the wheel touches several of them at once anyway.
std::vector<bool> entered(const CompensatedContour& contour, std::size_t edge) {
  const std::size_t count = contour.edges.size();
  std::vector<bool> result(count, false);
  for (std::size_t i = edge; !result[i]; i = (i + 1) % count) {
    result[i] = true;
    if (isFragile(contour.joints[i])) {
      break;
    }
  }
  for (std::size_t i = (edge + count - 1) % count; !result[i] && !isFragile(contour.joints[i]);
       i = (i + count - 1) % count) {
    result[i] = true;
  }
  return result;
}

Problem noLead(const char* what, double needed, double distance, const Point& place, int contour) {
  return Problem(Code::NoLead, {{"what", what}, {"needed_mm", needed}, {"distance_mm", distance}})
      .at(place)
      .ofContour(contour);
}

std::size_t nearestEdge(const CompensatedContour& contour, const Point& wheel) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < contour.edges.size(); ++i) {
    const double distance = geometry::nearest(contour.edges[i].contour, wheel).distance;
    if (distance < least) {
      least = distance;
      best = i;
    }
  }
  return best;
}

Problems checkLead(const Curve& lead, const char* what, const CompensatedContour& own, std::size_t edge,
                   const std::vector<CompensatedContour>& all, const recipe::Recipe& recipe) {
  const std::vector<bool> ownEdge = entered(own, edge);
  const double clear = recipe.wheelRadius + recipe.depth;
  for (const CompensatedContour& contour : all) {
    for (std::size_t i = 0; i < contour.edges.size(); ++i) {
      const bool isEntered = contour.contour == own.contour && ownEdge[i];
      const double needed = isEntered ? recipe.wheelRadius - base::kContourAccuracy : clear;
      const double distance = geometry::distance(lead, contour.edges[i].contour, needed);
      if (distance < needed - base::kZeroLength) {
        return {noLead(what, needed, distance, geometry::startPoint(lead), own.contour)};
      }
    }
  }
  return {};
}

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostBox = bg::model::box<BoostPoint>;

BoostBox boostBox(const geometry::Box& box, double margin) {
  return {{box.min().x() - margin, box.min().y() - margin}, {box.max().x() + margin, box.max().y() + margin}};
}

/// An edge among all contours.
struct EdgeRef {
  std::size_t contour = 0;
  std::size_t edge = 0;
};

using Tree =
    bg::index::rtree<std::pair<BoostBox, EdgeRef>, bg::index::quadratic<16>,
                     bg::index::indexable<std::pair<BoostBox, EdgeRef>>, decltype([](const auto& a, const auto& b) {
                       return a.second.contour == b.second.contour && a.second.edge == b.second.edge;
                     })>;

Tree treeOfEdges(const std::vector<CompensatedContour>& contours) {
  std::vector<std::pair<BoostBox, EdgeRef>> boxes;
  for (std::size_t c = 0; c < contours.size(); ++c) {
    for (std::size_t e = 0; e < contours[c].edges.size(); ++e) {
      boxes.emplace_back(boostBox(geometry::bounds(contours[c].edges[e].contour), 0), EdgeRef{c, e});
    }
  }
  return Tree(boxes);
}

// An edge and its neighbours keep their distance by construction.
bool isNeighbour(const CompensatedContour& contour, std::size_t edge, std::size_t other) {
  const std::size_t count = contour.edges.size();
  return other == edge || other == (edge + 1) % count || edge == (other + 1) % count;
}

bool isConvex(const CompensatedContour& contour, double side) {
  return std::all_of(contour.edges.begin(), contour.edges.end(), [side](const Edge& edge) {
    const auto* arc = std::get_if<geometry::Arc>(&edge.contour);
    return !arc || arc->curvature * side <= 0;
  });
}

void checkPiece(const Curve& path, EdgeRef origin, const std::vector<CompensatedContour>& contours, const Tree& tree,
                double radius, Problems& problems) {
  const double least = radius - base::kContourAccuracy;
  const BoostBox reach = boostBox(geometry::bounds(path), radius);
  for (auto found = tree.qbegin(bg::index::intersects(reach)); found != tree.qend(); ++found) {
    const EdgeRef other = found->second;
    if (other.contour == origin.contour && isNeighbour(contours[origin.contour], origin.edge, other.edge)) {
      continue;
    }
    const Curve& edge = contours[other.contour].edges[other.edge].contour;
    const double distance = geometry::distance(path, edge, least);
    if (distance < least) {
      problems.push_back(Problem(Code::PathMeetsItself, {{"distance_mm", distance}})
                             .at(geometry::pointAt(edge, geometry::parameterLength(edge) / 2))
                             .ofContour(contours[other.contour].contour));
      return;
    }
  }
}

} // namespace

Problems checkLeads(const Chain& chain, const CompensatedContour& own, const StartPoint& start,
                    const std::vector<CompensatedContour>& all, const recipe::Recipe& recipe) {
  const Curve& in = chain.segments.front().shape;
  const Curve& out = chain.segments.back().shape;
  const double clear = recipe.wheelRadius + recipe.depth + kPlungeClearance;
  Problems problems;
  for (const auto& [place, what] :
       {std::pair{geometry::startPoint(in), "go down"}, {geometry::endPoint(out), "come up"}}) {
    const double distance = leastDistance(all, place);
    if (distance < clear - base::kZeroLength) {
      problems.push_back(noLead(what, clear, distance, place, own.contour));
    }
  }
  const Problems leadIn = checkLead(in, "lead in", own, start.edge, all, recipe);
  const std::size_t left = nearestEdge(own, geometry::startPoint(out));
  const Problems leadOut = checkLead(geometry::reversed(out), "lead out", own, left, all, recipe);
  problems.insert(problems.end(), leadIn.begin(), leadIn.end());
  problems.insert(problems.end(), leadOut.begin(), leadOut.end());
  return problems;
}

Problems checkClearance(const std::vector<CompensatedContour>& contours, const recipe::Recipe& recipe) {
  const double side = wheelSide(recipe.direction);
  if (contours.size() == 1 && isConvex(contours.front(), side)) {
    return {}; // the offset of a convex contour cannot meet itself, nor can its transitions
  }
  const Tree tree = treeOfEdges(contours);
  Problems problems;
  for (std::size_t c = 0; c < contours.size(); ++c) {
    for (std::size_t e = 0; e < contours[c].edges.size(); ++e) {
      checkPiece(contours[c].edges[e].path, {c, e}, contours, tree, recipe.wheelRadius, problems);
      if (const std::optional<Curve>& corner = contours[c].joints[e].path) {
        checkPiece(*corner, {c, e}, contours, tree, recipe.wheelRadius, problems);
      }
    }
  }
  return problems;
}

} // namespace arris::toolpath
