#include "core/pattern/contour.h"

#include "core/base/numbers.h"
#include "core/base/tolerances.h"
#include "core/pattern/course.h"
#include "core/pattern/crossings.h"
#include "core/pattern/curve_tree.h"
#include "core/pattern/fit_chords.h"
#include "core/pattern/merge_neighbours.h"
#include "core/pattern/near_index.h"
#include "core/pattern/smooth_joints.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
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

using TreePoint = bg::model::point<double, 2, bg::cs::cartesian>;
using TreeBox = bg::model::box<TreePoint>;
using BoxIndex = bgi::rtree<std::pair<TreeBox, std::size_t>, bgi::quadratic<16>>;

TreeBox treeBox(const geometry::Box& box) {
  return {{box.min().x(), box.min().y()}, {box.max().x(), box.max().y()}};
}

std::size_t countOfCurves(const std::vector<Contour>& contours) {
  return std::accumulate(contours.begin(), contours.end(), std::size_t{0},
                         [](std::size_t count, const Contour& contour) { return count + contour.curves.size(); });
}

/// A tree over each contour and one over all of them.
struct ContourIndex {
  std::vector<CurveTree> trees;
  BoxIndex boxes;

  explicit ContourIndex(const std::vector<Contour>& contours) {
    trees.reserve(contours.size());
    std::vector<BoxIndex::value_type> entries;
    for (std::size_t i = 0; i < contours.size(); ++i) {
      entries.emplace_back(treeBox(trees.emplace_back(contours[i].curves).bounds()), i);
    }
    boxes = BoxIndex(entries);
  }
};

constexpr std::size_t kNoContour = ~std::size_t{0};

Problem tooDense(const Contour& contour, const Effort& effort) {
  return Problem(Code::ContoursTooDense, {{"most", effort.most()}})
      .at(geometry::startPoint(contour.curves.front()))
      .ofContour(contour.id);
}

/// The innermost of the other contours that each lies in; its starting point stands for it. What does not cross is
/// ordered by area: the smallest that surrounds a point is the innermost. Once the effort is spent none is found.
std::vector<std::size_t> parents(const std::vector<Contour>& contours, Effort& effort) {
  const ContourIndex index(contours);
  std::vector<double> area(contours.size());
  std::transform(contours.begin(), contours.end(), area.begin(),
                 [](const Contour& contour) { return std::abs(geometry::signedArea(contour.curves)); });
  std::vector<std::size_t> result(contours.size(), kNoContour);
  for (std::size_t i = 0; i < contours.size() && !effort.isSpent(); ++i) {
    const Point start = geometry::startPoint(contours[i].curves.front());
    std::vector<std::size_t> around;
    for (auto found = index.boxes.qbegin(bgi::intersects(TreePoint(start.x(), start.y())));
         found != index.boxes.qend() && effort.spend(); ++found) {
      if (found->second != i && area[found->second] > area[i]) {
        around.push_back(found->second);
      }
    }
    std::sort(around.begin(), around.end(), [&](std::size_t a, std::size_t b) { return area[a] < area[b]; });
    const auto innermost = std::find_if(around.begin(), around.end(),
                                        [&](std::size_t other) { return index.trees[other].surrounds(start); });
    result[i] = innermost == around.end() ? kNoContour : *innermost;
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

/// In how many others each lies.
std::vector<int> depths(const std::vector<std::size_t>& parent) {
  std::vector<int> depth(parent.size(), -1);
  std::vector<std::size_t> path;
  for (std::size_t i = 0; i < parent.size(); ++i) {
    std::size_t k = i;
    for (; k != kNoContour && depth[k] < 0; k = parent[k]) {
      path.push_back(k);
    }
    for (int next = k == kNoContour ? 0 : depth[k] + 1; !path.empty(); ++next) {
      depth[path.back()] = next;
      path.pop_back();
    }
  }
  return depth;
}

// Notes about contours that are no more there go with them.
void renumber(std::vector<Contour>& contours, base::Problems& notes) {
  std::map<int, int> numbers;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const int number = static_cast<int>(i) + 1;
    numbers[contours[i].id] = number;
    contours[i].id = number;
  }
  const auto isGone = [&](const Problem& note) { return !numbers.contains(*note.contour); };
  notes.erase(std::remove_if(notes.begin(), notes.end(), isGone), notes.end());
  for (Problem& note : notes) {
    note.contour = numbers.at(*note.contour);
  }
}

void nest(std::vector<Contour>& contours, base::Problems& problems, const std::stop_token& stop) {
  Effort effort(contours.size(), stop);
  const std::vector<std::size_t> parent = parents(contours, effort);
  if (effort.isSpent()) {
    problems.push_back(tooDense(contours.front(), effort));
    return;
  }
  const std::vector<int> depth = depths(parent);
  for (std::size_t i = 0; i < contours.size(); ++i) {
    contours[i].parent = parent[i] == kNoContour ? 0 : contours[parent[i]].id;
    if (depth[i] % 2 == 1) {
      contours[i].kind = ContourKind::CutOut;
      reverseChain(contours[i].curves);
      startAtTheLowest(contours[i].curves);
    }
  }
}

NearIndex::Numbers boxNumbers(const Contour& contour) {
  const geometry::Box box = geometry::bounds(contour.curves);
  return {box.min().x(), box.min().y(), box.max().x(), box.max().y()};
}

// Both run counter-clockwise; they may start anywhere.
bool areCopies(const Contour& a, const Contour& b) {
  const double length = geometry::totalLength(a.curves);
  const double tolerance = std::min(base::kSamePlace, length / 10);
  if (std::abs(length - geometry::totalLength(b.curves)) > length / 100) {
    return false;
  }
  const Point start = geometry::startPoint(a.curves.front());
  const auto distance = [&](const Curve& curve) { return geometry::nearest(curve, start).distance; };
  const auto nearest = std::min_element(b.curves.begin(), b.curves.end(),
                                        [&](const Curve& c, const Curve& d) { return distance(c) < distance(d); });
  const double lambda = geometry::nearest(*nearest, start).lambda;
  std::vector<Curve> fromThere;
  if (lambda < geometry::parameterLength(*nearest)) {
    fromThere.push_back(geometry::part(*nearest, lambda, geometry::parameterLength(*nearest)));
  }
  fromThere.insert(fromThere.end(), std::next(nearest), b.curves.end());
  fromThere.insert(fromThere.end(), b.curves.begin(), nearest);
  if (lambda > 0) {
    fromThere.push_back(geometry::part(*nearest, 0, lambda));
  }
  return runAlong(a.curves, fromThere, tolerance);
}

// Of two copies the one of fewer curves stays, then the lower.
bool standsBefore(const Contour& a, const Contour& b) {
  const auto key = [](const Contour& contour) {
    const Point p = middleOf(contour.curves);
    return std::tuple(contour.curves.size(), p.y(), p.x());
  };
  return key(a) < key(b);
}

void checkAlone(const Contour& contour, const CurveTree& tree, Effort& effort, base::Problems& problems) {
  const bool thereAndBack = contour.curves.size() == 2 && isSliver(contour);
  const std::vector<Point> crossings =
      thereAndBack ? std::vector<Point>() : selfCrossings(contour.curves, tree, effort);
  for (const Point& place : crossings) {
    problems.push_back(Problem(Code::ContourCrossesItself).at(place).ofContour(contour.id));
  }
  if (crossings.empty() && isSliver(contour)) {
    problems.push_back(
        Problem(Code::ContourDegenerate).at(geometry::startPoint(contour.curves.front())).ofContour(contour.id));
  }
}

// Against those after it, so that each pair is looked at once.
void checkAgainstOthers(const std::vector<Contour>& contours, std::size_t i, const ContourIndex& index, Effort& effort,
                        base::Problems& problems) {
  geometry::Box box = index.trees[i].bounds();
  box.min().array() -= base::kSamePlace;
  box.max().array() += base::kSamePlace;
  const auto isLater = [i](const BoxIndex::value_type& entry) { return entry.second > i; };
  std::vector<std::size_t> others;
  for (auto found = index.boxes.qbegin(bgi::intersects(treeBox(box)) && bgi::satisfies(isLater));
       found != index.boxes.qend() && effort.spend(); ++found) {
    others.push_back(found->second);
  }
  std::sort(others.begin(), others.end());
  for (const std::size_t k : others) {
    for (const Point& place :
         crossingsBetween(contours[i].curves, index.trees[i], contours[k].curves, index.trees[k], effort)) {
      problems.push_back(Problem(Code::ContoursCross,
                                 {{"first", std::int64_t{contours[i].id}}, {"second", std::int64_t{contours[k].id}}})
                             .at(place)
                             .ofContour(contours[i].id));
    }
  }
}

} // namespace

Contour makeContour(int id, std::vector<Curve> closedChain, double smooth, base::Problems& notes,
                    const std::stop_token& stop) {
  Contour contour;
  contour.id = id;
  contour.curves = std::move(closedChain);
  if (geometry::signedArea(contour.curves) < 0) {
    reverseChain(contour.curves);
  }
  startAtTheLowest(contour.curves);
  contour.fitDeviation = mergeNeighbours(contour.curves);
  ChordFit fit;
  if (smooth > 0) {
    startAtTheLowest(contour.curves);
    fit = fitChords(contour.curves, smooth, stop);
    for (Problem& note : fit.notes) {
      notes.push_back(std::move(note).ofContour(id));
    }
  }
  contour.fitDeviation += std::max(fit.deviation, smoothJoints(contour.curves)); // at different joints
  startAtTheLowest(contour.curves);
  return contour;
}

void takeOutCopies(std::vector<Contour>& contours, base::Problems& repairs, const std::stop_token& stop) {
  if (contours.size() < 2) {
    return;
  }
  NearIndex index(contours.size());
  std::vector<Contour> kept;
  for (Contour& contour : contours) {
    if (stop.stop_requested()) {
      return;
    }
    const NearIndex::Numbers numbers = boxNumbers(contour);
    const std::optional<std::size_t> copy =
        index.find(numbers, [&](std::size_t other) { return areCopies(kept[other], contour); });
    if (!copy) {
      index.add(numbers);
      kept.push_back(std::move(contour));
      continue;
    }
    if (standsBefore(contour, kept[*copy])) {
      std::swap(contour, kept[*copy]);
    }
    repairs.push_back(Problem(Code::DuplicateRemoved, {{"size_mm", geometry::totalLength(contour.curves)}})
                          .at(middleOf(contour.curves)));
  }
  contours = std::move(kept);
}

void sortContours(std::vector<Contour>& contours, base::Problems& notes, const std::stop_token& stop) {
  sortByPlace(contours);
  renumber(contours, notes);
  if (contours.size() > 1) {
    nest(contours, notes, stop);
  }
}

base::Problems checkContours(const std::vector<Contour>& contours, const std::stop_token& stop) {
  base::Problems problems;
  const ContourIndex index(contours);
  Effort effort(countOfCurves(contours), stop);
  for (std::size_t i = 0; i < contours.size() && !effort.isSpent(); ++i) {
    checkAlone(contours[i], index.trees[i], effort, problems);
    checkAgainstOthers(contours, i, index, effort, problems);
    if (effort.isSpent()) {
      problems.push_back(tooDense(contours[i], effort));
    }
  }
  return problems;
}

} // namespace arris::pattern
