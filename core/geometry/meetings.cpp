#include "core/geometry/meetings.h"

#include <cmath>

namespace arris::geometry {
namespace {

// The roots of a s² + 2 b s + c = 0, without cancellation. A root at infinity is none.
Track::Meetings solve(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  if (!(discriminant >= 0)) {
    return {};
  }
  const double sum = -(b + std::copysign(std::sqrt(discriminant), b));
  Track::Meetings result;
  if (a != 0) {
    result.s[result.count++] = sum / a;
  }
  if (sum != 0) {
    result.s[result.count++] = c / sum;
  }
  return result;
}

} // namespace

Track::Track(const Curve& lineOrArc) {
  if (const auto* line = std::get_if<Line>(&lineOrArc)) {
    m_length = (line->to - line->from).norm();
    m_middle = (line->from + line->to) / 2;
    m_tangent = (line->to - line->from) / m_length;
    m_end = m_length / 2;
    return;
  }
  const auto& arc = std::get<Arc>(lineOrArc);
  const Evaluation middle = evaluate(arc, arc.length / 2);
  m_length = arc.length;
  m_middle = middle.point;
  m_tangent = middle.first;
  m_curvature = arc.curvature;
  m_end = std::abs(std::tan(arc.sweep() / 4) * 2 / arc.curvature);
}

double Track::lambda(double s) const {
  if (s == m_end) {
    return m_length;
  }
  if (s == -m_end) {
    return 0;
  }
  return m_length / 2 + (m_curvature == 0 ? s : 2 * std::atan(m_curvature * s / 2) / m_curvature);
}

// With v from the centre: |v + (s t + κs²/2 n)/(1 + κ²s²/4)|² = r², multiplied by the denominator.
Track::Meetings Track::meetCircle(const Point& center, double radius) const {
  const Vector v = m_middle - center;
  const double c = v.squaredNorm() - radius * radius;
  return solve(1 + m_curvature * (v.dot(leftOf(m_tangent)) + c * m_curvature / 4), v.dot(m_tangent), c);
}

Track::Meetings Track::meetLine(const Point& through, const Vector& normal) const {
  return meetThrough(through, normal, 0);
}

// Where normal·w = curvature/2 |w|², with w from the point: a circle through it, or a line. |w|² = |v|² + 2 v·d + s²/D
// with v from the point to the middle of the track, d from there to the track and D the denominator of its parameter;
// multiplied by D.
Track::Meetings Track::meetThrough(const Point& through, const Vector& normal, double curvature) const {
  const Vector v = m_middle - through;
  const Vector left = leftOf(m_tangent);
  const double bend = m_curvature / 2;
  const double c = curvature / 2 * v.squaredNorm() - normal.dot(v);
  const double a = curvature / 2 * (2 * bend * v.dot(left) + 1) - bend * normal.dot(left) + bend * bend * c;
  return solve(a, (curvature * v - normal).dot(m_tangent) / 2, c);
}

Track::Meetings Track::meetWhole(const Curve& lineOrArc) const {
  const auto* arc = std::get_if<Arc>(&lineOrArc);
  return arc ? meetBeside(*arc, 0) : meetLine(startPoint(lineOrArc), leftOf(startTangent(lineOrArc)));
}

// Multiplied by 1 − κ·distance, which is 0 in the centre.
Track::Meetings Track::meetBeside(const Arc& arc, double distance) const {
  const Vector left = leftOf(arc.tangent);
  return meetThrough(arc.start + distance * left, (1 - arc.curvature * distance) * left, arc.curvature);
}

} // namespace arris::geometry
