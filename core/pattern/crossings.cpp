#include "core/pattern/crossings.h"

#include "core/base/numbers.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace arris::pattern {
namespace {

using base::kPi;
using geometry::Arc;
using geometry::Curve;
using geometry::Point;
using geometry::Vector;

/// More places than these help nobody.
constexpr std::size_t kEnough = 5;

/// Places nearer to each other than this are told once, mm: chains that run along each other touch everywhere.
constexpr double kOnePlace = 1;

/// Curves in one point to within this, mm.
constexpr double kTouch = 1e-7;

/// A joint that turns back by all but this runs along itself, rad.
constexpr double kBack = 1e-6;

/// What `meetingPlace` costs in comparisons.
constexpr std::int64_t kMeetingEffort = 50;

/// Place on `a` nearest to `b`, to some micrometres: for a message.
Point meetingPlace(const Curve& a, const Curve& b) {
  constexpr int kSamples = 64;
  const double length = geometry::parameterLength(a);
  const auto distance = [&](double lambda) { return geometry::nearest(b, geometry::pointAt(a, lambda)).distance; };
  double best = 0;
  for (int i = 1; i <= kSamples; ++i) {
    const double lambda = length * i / kSamples;
    best = distance(lambda) < distance(best) ? lambda : best;
  }
  double step = length / kSamples;
  while (step > base::kSamePlace / 1000) {
    for (const double lambda : {std::max(0.0, best - step), std::min(length, best + step)}) {
      best = distance(lambda) < distance(best) ? lambda : best;
    }
    step /= 2;
  }
  return geometry::pointAt(a, best);
}

/// The point in which two curves that meet in `joint` may meet again: its mirror image about the line through the
/// centres, or the perpendicular from the centre on the line.
Point mirrorImage(const Point& joint, const Curve& a, const Curve& b) {
  const auto* arcA = std::get_if<Arc>(&a);
  const auto* arcB = std::get_if<Arc>(&b);
  if (!arcA && !arcB) {
    return joint;
  }
  const Point center = arcA ? arcA->center() : arcB->center();
  const Vector axis =
      arcA && arcB ? Vector(arcB->center() - center) : geometry::leftOf(geometry::startTangent(arcA ? b : a));
  if (axis.squaredNorm() == 0) {
    return joint;
  }
  const Point foot = center + axis * (axis.dot(joint - center) / axis.squaredNorm());
  return 2 * foot - joint;
}

/// What may be wrong between neighbours, of which the first ends where the second starts.
class Neighbours {
public:
  Neighbours(const Curve& first, const Curve& second, bool onlyTwo)
      : m_first(first), m_second(second), m_joint(geometry::startPoint(second)) {
    m_shared = onlyTwo ? geometry::startPoint(first) : m_joint;
  }

  [[nodiscard]] std::optional<Point> crossing() const {
    const double turn = geometry::turn(geometry::endTangent(m_first), geometry::startTangent(m_second));
    if (std::abs(turn) > kPi - kBack) {
      return m_joint;
    }
    for (const Point& p :
         {mirrorImage(m_joint, m_first, m_second), geometry::startPoint(m_first), geometry::endPoint(m_second)}) {
      if (!isShared(p) && isOn(m_first, p) && isOn(m_second, p)) {
        return p;
      }
    }
    return std::nullopt;
  }

private:
  [[nodiscard]] bool isShared(const Point& p) const {
    return (p - m_joint).norm() < base::kSamePlace || (p - m_shared).norm() < base::kSamePlace;
  }

  static bool isOn(const Curve& curve, const Point& p) {
    return geometry::nearest(curve, p).distance < kTouch;
  }

  const Curve& m_first;
  const Curve& m_second;
  Point m_joint;
  Point m_shared; ///< the other joint of a chain of two
};

} // namespace

std::vector<Point> selfCrossings(const std::vector<Curve>& chain, const CurveTree& tree, Effort& effort) {
  std::vector<Point> places;
  if (chain.size() < 2) {
    return places;
  }
  std::vector<double> start{0}; // way along the chain to the start of each curve
  for (const Curve& curve : chain) {
    start.push_back(start.back() + geometry::arcLength(curve));
  }
  // Two stretches of the chain touch where they come near without being near along the chain.
  const auto touchingBelow = [&](std::size_t i, std::size_t j) {
    const double between = start[j] - start[i + 1];
    const double around = start.back() - start[j + 1] + start[i];
    return std::min({between / 10, around / 10, base::kSamePlace});
  };
  tree.forPairs(base::kSamePlace, [&](std::size_t i, std::size_t j) {
    const bool follows = j == i + 1;
    const bool closes = i == 0 && j + 1 == chain.size();
    std::optional<Point> place;
    if (follows) {
      place = Neighbours(chain[i], chain[j], chain.size() == 2).crossing();
    }
    if (closes && !place) {
      place = Neighbours(chain[j], chain[i], chain.size() == 2).crossing();
    }
    if (!follows && !closes) {
      const double below = touchingBelow(i, j);
      if (geometry::distance(chain[i], chain[j], below) <= below) {
        effort.spend(kMeetingEffort);
        place = meetingPlace(chain[i], chain[j]);
      }
    }
    if (place) {
      places.push_back(*place);
    }
    return effort.spend() && places.size() < kEnough;
  });
  return places;
}

std::vector<Point> crossingsBetween(const std::vector<Curve>& a, const CurveTree& treeOfA, const std::vector<Curve>& b,
                                    const CurveTree& treeOfB, Effort& effort) {
  std::vector<Point> places;
  treeOfA.forPairsWith(treeOfB, base::kSamePlace, [&](std::size_t i, std::size_t j) {
    if (geometry::distance(a[i], b[j], base::kSamePlace) < base::kSamePlace) {
      effort.spend(kMeetingEffort);
      const Point place = meetingPlace(a[i], b[j]);
      const auto isNear = [&](const Point& told) { return (told - place).norm() < kOnePlace; };
      if (std::none_of(places.begin(), places.end(), isNear)) {
        places.push_back(place);
      }
    }
    return effort.spend() && places.size() < kEnough;
  });
  return places;
}

} // namespace arris::pattern
