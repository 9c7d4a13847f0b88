#include "core/toolpath/unreached.h"

#include "core/base/tolerances.h"
#include "core/toolpath/largest_wheel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace arris::toolpath {
namespace {

using base::Code;
using base::Problem;
using geometry::Curve;
using geometry::Point;

/// A part of an edge that the wheel touches, or the corner at its end, and where the wheel is at both ends of that.
struct Touched {
  EdgeId edge = 0;
  Stretch ground;
  Point wheelFrom;
  Point wheelTo;
  bool leftOut = false; ///< it could be touched, and is not
};

double lengthOf(const Glass& glass, EdgeId edge) {
  return geometry::parameterLength(glass.edges()[edge]);
}

void addTouched(std::vector<Touched>& touched, const Glass& glass, const std::vector<WheelLoop>& loops, bool leftOut) {
  for (const WheelLoop& loop : loops) {
    for (const Step& step : loop.steps) {
      const bool isCorner = step.role != Role::Contour;
      if (isCorner && glass.jointAfter(step.edge) != JointKind::Convex) {
        continue; // the arc in a concave corner
      }
      const double end = lengthOf(glass, step.edge);
      touched.push_back({step.edge, isCorner ? Stretch{end, end} : step.ground, geometry::startPoint(step.path),
                         geometry::endPoint(step.path), leftOut});
    }
  }
}

/// All that is touched or could be, along the rings.
std::vector<Touched> touchedParts(const Glass& glass, const std::vector<WheelLoop>& loops,
                                  const std::vector<WheelLoop>& leftOut) {
  std::vector<Touched> touched;
  addTouched(touched, glass, loops, false);
  addTouched(touched, glass, leftOut, true);
  const auto place = [](const Touched& t) { return std::tuple(t.edge, t.ground.from); };
  std::stable_sort(touched.begin(), touched.end(),
                   [&](const Touched& a, const Touched& b) { return place(a) < place(b); });
  return touched;
}

/// What lies between two touched places, along the ring.
class Gap {
public:
  /// `acrossStart`: the ring's first touched part comes after its last.
  Gap(const Glass& glass, const Touched& before, const Touched& after, bool acrossStart)
      : m_before(before), m_after(after) {
    if (before.edge == after.edge && !acrossStart) {
      add(glass, before.edge, before.ground.to, after.ground.from);
      return;
    }
    add(glass, before.edge, before.ground.to, lengthOf(glass, before.edge));
    for (EdgeId edge = glass.next(before.edge); edge != after.edge; edge = glass.next(edge)) {
      add(glass, edge, 0, lengthOf(glass, edge));
    }
    add(glass, after.edge, 0, after.ground.from);
  }

  [[nodiscard]] const std::vector<UntouchedPart>& parts() const {
    return m_parts;
  }

  [[nodiscard]] double length() const {
    double sum = 0;
    for (const UntouchedPart& part : m_parts) {
      sum += part.ground.to - part.ground.from;
    }
    return sum;
  }

  /// Whether it is what a wheel leaves at a single concave corner, where it touches both sides at once.
  [[nodiscard]] bool isFillet(const std::map<EdgeId, EdgeId>& fillets) const {
    const auto fillet = fillets.find(m_before.edge);
    return fillet != fillets.end() && fillet->second == m_after.edge &&
           (m_before.wheelTo - m_after.wheelFrom).norm() < 1;
  }

  /// Largest distance of the untouched parts from the wheel at either end, mm, and where that is.
  [[nodiscard]] std::pair<double, Point> farthest(const Glass& glass) const {
    std::pair<double, Point> result{0, m_before.wheelTo};
    for (const UntouchedPart& part : m_parts) {
      const Curve curve = geometry::part(glass.edges()[part.edge], part.ground.from, part.ground.to);
      constexpr int kPlaces = 16;
      for (int i = 0; i <= kPlaces; ++i) {
        const Point point = geometry::pointAt(curve, geometry::parameterLength(curve) * i / kPlaces);
        const double distance = std::min((point - m_before.wheelTo).norm(), (point - m_after.wheelFrom).norm());
        if (distance > result.first) {
          result = {distance, point};
        }
      }
    }
    return result;
  }

private:
  void add(const Glass& glass, EdgeId edge, double from, double to) {
    if (to - from > base::kZeroLength || (from <= 0 && to >= lengthOf(glass, edge))) {
      m_parts.push_back({edge, {from, to}});
    }
  }

  Touched m_before;
  Touched m_after;
  std::vector<UntouchedPart> m_parts;
};

class Finder {
public:
  Finder(const Glass& glass, const std::vector<WheelLoop>& loops, const std::vector<WheelLoop>& leftOut,
         const recipe::Recipe& recipe)
      : m_glass(glass), m_recipe(recipe), m_touched(touchedParts(glass, loops, leftOut)) {
    noteFillets(loops);
    noteFillets(leftOut);
  }

  Unreached find() {
    auto from = m_touched.begin();
    for (const Ring& ring : m_glass.rings()) {
      const auto to =
          std::find_if(from, m_touched.end(), [&](const Touched& t) { return t.edge >= ring.first + ring.count; });
      m_result.unground.push_back(from == to ? wholeRing(ring) : alongRing(from, to));
      from = to;
    }
    return std::move(m_result);
  }

private:
  using Iterator = std::vector<Touched>::const_iterator;

  void noteFillets(const std::vector<WheelLoop>& loops) {
    for (const WheelLoop& loop : loops) {
      for (const Fillet& fillet : loop.fillets) {
        m_fillets[fillet.before] = fillet.after;
      }
    }
  }

  double alongRing(Iterator from, Iterator to) {
    double unground = 0;
    for (auto t = from; t != to; ++t) {
      const auto next = t + 1 == to ? from : t + 1;
      unground += t->leftOut ? t->ground.to - t->ground.from : 0;
      const bool closesOnItself = next == t && t->ground.to - t->ground.from >= lengthOf(m_glass, t->edge);
      if (closesOnItself) {
        continue;
      }
      const Gap gap(m_glass, *t, *next, t + 1 == to);
      if (gap.parts().empty()) {
        continue;
      }
      const auto [distance, place] = gap.farthest(m_glass);
      if (distance <= m_recipe.wheelRadius + base::kContourAccuracy) {
        continue;
      }
      unground += gap.length();
      if (!gap.isFillet(m_fillets)) {
        tell(gap.parts(), gap.length(), distance - m_recipe.wheelRadius, place);
      }
    }
    return unground;
  }

  double wholeRing(const Ring& ring) {
    std::vector<UntouchedPart> parts;
    double length = 0;
    for (EdgeId edge = ring.first; edge < ring.first + ring.count; ++edge) {
      parts.push_back({edge, {0, lengthOf(m_glass, edge)}});
      length += parts.back().ground.to;
    }
    tell(parts, length, std::nullopt, geometry::startPoint(m_glass.edges()[ring.first]));
    return length;
  }

  void tell(const std::vector<UntouchedPart>& parts, double length, std::optional<double> left, const Point& place) {
    const Code code = m_recipe.acceptUnreached ? (left ? Code::UnreachedAccepted : Code::ContourLeftOut)
                                               : (left ? Code::Unreached : Code::ContourNotEntered);
    Problem problem(code, {{"wheel_mm", m_recipe.wheelRadius}, {"length_mm", length}});
    if (left) {
      problem.values.push_back({"left_mm", *left});
    }
    if (m_told[code]++ < base::kMostOfOneCode) { // more are not listed anyway
      problem.largestWheel = largestWheel(m_glass, parts, m_recipe.wheelRadius);
      problem.values.push_back({"largest_mm", *problem.largestWheel});
    }
    m_result.problems.push_back(std::move(problem).at(place).ofContour(m_glass.ringOf(parts.front().edge).contour));
  }

  const Glass& m_glass;
  const recipe::Recipe& m_recipe;
  std::vector<Touched> m_touched;
  std::map<EdgeId, EdgeId> m_fillets; ///< edges touched before and after a fillet
  std::map<Code, std::int64_t> m_told;
  Unreached m_result;
};

} // namespace

Unreached findUnreached(const Glass& glass, const std::vector<WheelLoop>& loops, const std::vector<WheelLoop>& leftOut,
                        const recipe::Recipe& recipe) {
  return Finder(glass, loops, leftOut, recipe).find();
}

} // namespace arris::toolpath
