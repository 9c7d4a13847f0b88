#include "core/pattern/contour.h"

#include "core/base/numbers.h"
#include "core/base/tolerances.h"
#include "core/pattern/crossings.h"
#include "core/pattern/curve_tree.h"
#include "core/pattern/merge_neighbours.h"
#include "core/pattern/smooth_joints.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace arris::pattern {
namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;

using base::Code;
using base::kPi;
using base::Problem;
using geometry::Arc;
using geometry::Curve;
using geometry::Point;

void reverseChain(std::vector<Curve>& chain) {
  std::reverse(chain.begin(), chain.end());
  std::transform(chain.begin(), chain.end(), chain.begin(), geometry::reversed);
}

// Starts within `kSamePlace` of the lowest count as equally low: rounding must not decide.
void startAtTheLowest(std::vector<Curve>& chain) {
  if (chain.size() == 1) { // a full circle starts at its lowest point
    const Arc& circle = std::get<Arc>(chain.front());
    chain.front() =
        geometry::arcAbout(circle.center(), circle.radius(), -kPi / 2, std::copysign(2 * kPi, circle.curvature));
    return;
  }
  double least = geometry::startPoint(chain.front()).y();
  for (const Curve& curve : chain) {
    least = std::min(least, geometry::startPoint(curve).y());
  }
  const auto place = [least](const Curve& curve) {
    const Point p = geometry::startPoint(curve);
    const bool lowest = p.y() <= least + base::kSamePlace;
    return std::tuple(!lowest, p.x(), p.y());
  };
  const auto first =
      std::min_element(chain.begin(), chain.end(), [&](const Curve& a, const Curve& b) { return place(a) < place(b); });
  std::rotate(chain.begin(), first, chain.end());
}

std::int64_t rounded(double x) {
  return std::llround(x / base::kSamePlace);
}

/// Whether the contour encloses nothing but a sliver thinner than what the program promises.
bool isSliver(const Contour& contour) {
  return std::abs(geometry::signedArea(contour.curves)) <
         base::kContourAccuracy * geometry::totalLength(contour.curves) / 2;
}

/// In how many of the other contours each lies; its starting point stands for it.
std::vector<int> depths(const std::vector<Contour>& contours) {
  using TreePoint = bg::model::point<double, 2, bg::cs::cartesian>;
  using Entry = std::pair<bg::model::box<TreePoint>, std::size_t>;
  std::vector<CurveTree> trees;
  trees.reserve(contours.size());
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const geometry::Box& box = trees.emplace_back(contours[i].curves).bounds();
    entries.push_back({{{box.min().x(), box.min().y()}, {box.max().x(), box.max().y()}}, i});
  }
  const bgi::rtree<Entry, bgi::quadratic<16>> index(entries);
  std::vector<int> result(contours.size(), 0);
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const Point start = geometry::startPoint(contours[i].curves.front());
    for (auto found = index.qbegin(bgi::intersects(TreePoint(start.x(), start.y()))); found != index.qend(); ++found) {
      result[i] += found->second != i && trees[found->second].surrounds(start) ? 1 : 0;
    }
  }
  return result;
}

void sortByPlace(std::vector<Contour>& contours) {
  const auto place = [](const Contour& contour) {
    const geometry::Box box = geometry::bounds(contour.curves);
    return std::tuple(rounded(box.min().x()), rounded(box.min().y()), rounded(box.max().x()), rounded(box.max().y()));
  };
  std::vector<std::pair<decltype(place(contours.front())), std::size_t>> order;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    order.emplace_back(place(contours[i]), i);
  }
  std::sort(order.begin(), order.end());
  std::vector<Contour> sorted;
  sorted.reserve(contours.size());
  for (const auto& [key, i] : order) {
    sorted.push_back(std::move(contours[i]));
  }
  contours = std::move(sorted);
}

void turnCutOuts(std::vector<Contour>& contours) {
  const std::vector<int> depth = depths(contours);
  for (std::size_t i = 0; i < contours.size(); ++i) {
    if (depth[i] % 2 == 1) {
      contours[i].kind = ContourKind::CutOut;
      reverseChain(contours[i].curves);
      startAtTheLowest(contours[i].curves);
    }
  }
}

} // namespace

Contour makeContour(std::vector<Curve> closedChain) {
  Contour contour;
  contour.curves = std::move(closedChain);
  if (geometry::signedArea(contour.curves) < 0) {
    reverseChain(contour.curves);
  }
  startAtTheLowest(contour.curves);
  const double merged = mergeNeighbours(contour.curves);
  contour.fitDeviation = merged + smoothJoints(contour.curves);
  startAtTheLowest(contour.curves);
  return contour;
}

void sortContours(std::vector<Contour>& contours) {
  if (contours.size() > 1) {
    sortByPlace(contours);
    turnCutOuts(contours);
  }
  for (std::size_t i = 0; i < contours.size(); ++i) {
    contours[i].id = static_cast<int>(i) + 1;
  }
}

base::Problems checkContours(const std::vector<Contour>& contours) {
  base::Problems problems;
  for (const Contour& contour : contours) {
    const bool thereAndBack = contour.curves.size() == 2 && isSliver(contour);
    const std::vector<Point> crossings =
        thereAndBack ? std::vector<Point>() : selfCrossings(contour.curves, CurveTree(contour.curves));
    for (const Point& place : crossings) {
      problems.push_back(Problem(Code::ContourCrossesItself).at(place).ofContour(contour.id));
    }
    if (crossings.empty() && isSliver(contour)) {
      problems.push_back(
          Problem(Code::ContourDegenerate).at(geometry::startPoint(contour.curves.front())).ofContour(contour.id));
    }
  }
  if (contours.size() > 1) {
    problems.push_back(Problem(Code::SeveralContours, {{"count", static_cast<std::int64_t>(contours.size())}})
                           .at(geometry::startPoint(contours[1].curves.front()))
                           .ofContour(contours[1].id));
  }
  return problems;
}

} // namespace arris::pattern
