#include "tests/support/contours.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>

namespace arris::test {

using geometry::Curve;
using geometry::Point;

std::vector<Curve> closedLines(const std::vector<Point>& corners) {
  std::vector<Curve> lines;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    lines.emplace_back(geometry::Line{corners[i], corners[(i + 1) % corners.size()]});
  }
  return lines;
}

pattern::Pattern joined(std::vector<Curve> singles, double gap, double smooth) {
  return pattern::joinPieces(pattern::Pieces(std::move(singles)), gap, smooth);
}

std::vector<base::Problem> problemsOf(const pattern::Pattern& pattern, base::Code code) {
  std::vector<base::Problem> found;
  std::copy_if(pattern.problems.begin(), pattern.problems.end(), std::back_inserter(found),
               [code](const base::Problem& p) { return p.code == code; });
  return found;
}

testing::AssertionResult areSame(const std::vector<Curve>& a, const std::vector<Curve>& b, double tolerance) {
  if (a.size() != b.size()) {
    return testing::AssertionFailure() << a.size() << " and " << b.size() << " curves";
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double lengthA = geometry::parameterLength(a[i]);
    const double lengthB = geometry::parameterLength(b[i]);
    for (const double share : {0.0, 0.5, 1.0}) {
      const double apart = (geometry::pointAt(a[i], share * lengthA) - geometry::pointAt(b[i], share * lengthB)).norm();
      if (a[i].index() != b[i].index() || apart > tolerance) {
        return testing::AssertionFailure() << "curve " << i << " differs by " << apart;
      }
    }
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult isWellJoined(const std::vector<Curve>& closedChain, double tangent) {
  for (std::size_t i = 0; i < closedChain.size(); ++i) {
    const Curve& before = closedChain[i];
    const Curve& after = closedChain[(i + 1) % closedChain.size()];
    const Point joint = geometry::startPoint(after);
    const double gap = (geometry::endPoint(before) - joint).norm();
    if (gap > 1e-12 * (1 + joint.norm())) {
      return testing::AssertionFailure() << "gap of " << gap << " after curve " << i;
    }
    const double turn = std::abs(geometry::turn(geometry::endTangent(before), geometry::startTangent(after)));
    if (turn > tangent && turn < base::kSmoothTurn) {
      return testing::AssertionFailure() << "turn of " << turn << " after curve " << i;
    }
  }
  return testing::AssertionSuccess();
}

std::vector<Curve> shuffled(std::vector<Curve> pieces, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::shuffle(pieces.begin(), pieces.end(), random);
  for (Curve& piece : pieces) {
    if (random() % 2 == 0) {
      piece = geometry::reversed(piece);
    }
  }
  return pieces;
}

double farthest(const std::vector<Curve>& a, const std::vector<Curve>& b) {
  constexpr int kSamples = 20;
  double most = 0;
  for (const Curve& curve : a) {
    for (int i = 0; i <= kSamples; ++i) {
      const Point p = geometry::pointAt(curve, geometry::parameterLength(curve) * i / kSamples);
      double nearest = std::numeric_limits<double>::infinity();
      for (const Curve& other : b) {
        nearest = std::min(nearest, geometry::nearest(other, p).distance);
      }
      most = std::max(most, nearest);
    }
  }
  return most;
}

} // namespace arris::test
