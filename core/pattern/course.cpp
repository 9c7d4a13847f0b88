#include "core/pattern/course.h"

#include <algorithm>

namespace arris::pattern {
namespace {

using geometry::Curve;
using geometry::Point;

/// A point that moves forwards along a chain.
class Follower {
public:
  explicit Follower(Chain chain) : m_chain(chain) {}

  /// The point at this length from the start; never less than in the call before.
  Point at(double length) {
    double here = geometry::parameterLength(m_chain[m_curve]);
    while (m_curve + 1 < m_chain.size() && length > m_start + here) {
      m_start += here;
      here = geometry::parameterLength(m_chain[++m_curve]);
    }
    return geometry::pointAt(m_chain[m_curve], std::clamp(length - m_start, 0.0, here));
  }

private:
  Chain m_chain;
  std::size_t m_curve = 0;
  double m_start = 0; ///< length of the chain before the curve
};

bool followsWithin(Chain a, Chain b, double tolerance) {
  const double scale = lengthOf(b) / lengthOf(a);
  Follower follower(b);
  double way = 0;
  for (const Curve& curve : a) {
    const double length = geometry::parameterLength(curve);
    for (const double lambda : {length / 2, length}) {
      if ((geometry::pointAt(curve, lambda) - follower.at((way + lambda) * scale)).norm() > tolerance) {
        return false;
      }
    }
    way += length;
  }
  return true;
}

} // namespace

double lengthOf(Chain chain) {
  double length = 0;
  for (const Curve& curve : chain) {
    length += geometry::parameterLength(curve);
  }
  return length;
}

Point middleOf(Chain chain) {
  return Follower(chain).at(lengthOf(chain) / 2);
}

std::vector<Curve> reversedChain(Chain chain) {
  std::vector<Curve> result(chain.size());
  std::transform(chain.rbegin(), chain.rend(), result.begin(), geometry::reversed);
  return result;
}

bool runAlong(Chain a, Chain b, double tolerance) {
  return followsWithin(a, b, tolerance) && followsWithin(b, a, tolerance);
}

} // namespace arris::pattern
