#include "core/pattern/fit_distance.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>

namespace arris::pattern {
namespace {

using geometry::Arc;
using geometry::Biarc;
using geometry::Curve;
using geometry::Line;
using geometry::Point;
using geometry::Vector;

double curvatureOfFit(const Curve& curve) {
  const auto* arc = std::get_if<Arc>(&curve);
  return arc ? arc->curvature : 0;
}

double sweepOf(const Curve& curve) {
  const auto* arc = std::get_if<Arc>(&curve);
  return arc ? std::abs(arc->sweep()) : 0;
}

/// The direction at the joint of two arcs parts what lies beside them as long as neither turns by more than this, rad.
constexpr double kWide = 3;

/// Distances of points along the way from two curves that touch each other.
class TwoCurves {
public:
  explicit TwoCurves(const Biarc& fitted) : m_fitted(fitted) {
    if (fitted.second) {
      m_joint = geometry::startPoint(*fitted.second);
      m_tangent = geometry::startTangent(*fitted.second);
      m_isWide = std::max(sweepOf(fitted.first), sweepOf(*fitted.second)) > kWide;
    }
  }

  [[nodiscard]] double left(const Point& p) const {
    if (!m_isWide) {
      return leftDistance(curveAt(p), p);
    }
    const double first = leftDistance(m_fitted.first, p);
    const double second = leftDistance(*m_fitted.second, p);
    return std::abs(first) < std::abs(second) ? first : second;
  }

  /// The greatest curvature beside the chord.
  [[nodiscard]] double curvature(const Point& from, const Point& to) const {
    const double a = curvatureOfFit(curveAt(from));
    const double b = curvatureOfFit(curveAt(to));
    return std::abs(a) > std::abs(b) ? a : b;
  }

private:
  [[nodiscard]] const Curve& curveAt(const Point& p) const {
    return m_fitted.second && m_tangent.dot(p - m_joint) > 0 ? *m_fitted.second : m_fitted.first;
  }

  const Biarc& m_fitted;
  Point m_joint = Point::Zero();
  Vector m_tangent = Vector::Zero();
  bool m_isWide = false;
};

/// Largest distance along a chord: at its ends, or where it runs parallel to the curve between them.
double farthestOnChord(double atStart, double atEnd, double curvature, double squaredLength) {
  const double bulge = curvature * squaredLength / 8;
  const double rise = atEnd - atStart;
  double most = std::max(std::abs(atStart), std::abs(atEnd));
  if (std::abs(rise) < 4 * std::abs(bulge)) {
    most = std::max(most, std::abs((atStart + atEnd) / 2 + bulge + rise * rise / (16 * bulge)));
  }
  return most;
}

/// Between the places where an arc touches two lines it counts, and the lines before and behind.
class RoundedCorner {
public:
  RoundedCorner(const Line& before, const Arc& arc, const Line& after)
      : m_before(before), m_arc(arc), m_after(after), m_touchIn(before.to), m_touchOut(after.from),
        m_in(geometry::startTangent(before)), m_out(geometry::startTangent(after)) {}

  /// `isInFirstHalf` tells the lines apart, which may run beside each other.
  [[nodiscard]] double distance(const Point& p, bool isInFirstHalf) const {
    if (isOnLine(p, isInFirstHalf)) {
      return std::abs(leftDistance(isInFirstHalf ? m_before : m_after, p));
    }
    return std::abs(leftDistance(m_arc, p));
  }

  [[nodiscard]] bool isOnLine(const Point& p, bool isInFirstHalf) const {
    return isInFirstHalf ? m_in.dot(p - m_touchIn) < 0 : m_out.dot(p - m_touchOut) > 0;
  }

private:
  Curve m_before;
  Curve m_arc;
  Curve m_after;
  Point m_touchIn;
  Point m_touchOut;
  Vector m_in;
  Vector m_out;
};

} // namespace

double leftDistance(const Curve& lineOrArc, const Point& point) {
  if (const auto* line = std::get_if<Line>(&lineOrArc)) {
    return geometry::cross((line->to - line->from).normalized(), point - line->from);
  }
  const Arc& arc = std::get<Arc>(lineOrArc);
  const Vector from = point - arc.start;
  const double x = from.dot(arc.tangent);
  const double y = from.dot(geometry::leftOf(arc.tangent));
  const double k = arc.curvature;
  return (2 * y - k * (x * x + y * y)) / (std::sqrt(base::squared(k * x) + base::squared(1 - k * y)) + 1);
}

double distanceFromChords(const Biarc& fitted, std::span<const Point> vertices, double enough) {
  const TwoCurves curves(fitted);
  double before = curves.left(vertices.front());
  double most = std::abs(before);
  for (std::size_t i = 1; i < vertices.size() && most <= enough; ++i) {
    const double here = curves.left(vertices[i]);
    const double squaredLength = (vertices[i] - vertices[i - 1]).squaredNorm();
    most = std::max(most, farthestOnChord(before, here, curves.curvature(vertices[i - 1], vertices[i]), squaredLength));
    before = here;
  }
  return most;
}

double distanceFromChords(const Line& before, const Arc& arc, const Line& after, std::span<const Point> vertices) {
  constexpr int kSamples = 128;
  const RoundedCorner corner(before, arc, after);
  const Biarc alone{arc, std::nullopt};
  double most = 0;
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    const bool first = 2 * i < vertices.size();
    const std::span<const Point> chord = vertices.subspan(i - 1, 2);
    if (!corner.isOnLine(chord[0], first) && !corner.isOnLine(chord[1], first)) {
      most = std::max(most, distanceFromChords(alone, chord, HUGE_VAL));
      continue;
    }
    for (int k = 0; k <= kSamples; ++k) {
      const double share = static_cast<double>(k) / kSamples;
      most = std::max(most, corner.distance((1 - share) * chord[0] + share * chord[1], first));
    }
  }
  return most;
}

} // namespace arris::pattern
