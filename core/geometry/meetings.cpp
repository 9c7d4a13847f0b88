#include "core/geometry/meetings.h"

#include "core/base/numbers.h"

#include <cmath>

namespace arris::geometry {
namespace {

using base::kPi;

// With s = (2/κ) tan(κλ/2) a point of the track is start + (s t + κs²/2 n)/(1 + κ²s²/4): both kinds of meeting are
// quadratic in s, and s becomes λ itself where κ goes to 0.
double lambdaAt(const Track& track, double s) {
  if (track.curvature == 0) {
    return s;
  }
  const double lambda = 2 * std::atan(track.curvature * s / 2) / track.curvature;
  return lambda < 0 ? lambda + 2 * kPi / std::abs(track.curvature) : lambda;
}

// The roots of a s² + 2 b s + c = 0. A root at infinity is the point opposite to the start of an arc.
Meetings solve(const Track& track, double a, double b, double c) {
  const double discriminant = b * b - a * c;
  if (!(discriminant >= 0)) {
    return {};
  }
  const double sum = -(b + std::copysign(std::sqrt(discriminant), b));
  Meetings result;
  const auto add = [&](double numerator, double denominator) {
    if (denominator != 0) {
      result.lambda[result.count++] = lambdaAt(track, numerator / denominator);
    } else if (numerator != 0 && track.curvature != 0) {
      result.lambda[result.count++] = kPi / std::abs(track.curvature);
    }
  };
  if (sum == 0 && (a == 0 || c == 0)) { // b = 0 and a c = 0
    if (a != 0) {
      add(0, a);
    }
    return result;
  }
  add(sum, a);
  add(c, sum);
  return result;
}

} // namespace

Track::Track(const Curve& lineOrArc) {
  if (const auto* line = std::get_if<Line>(&lineOrArc)) {
    start = line->from;
    length = (line->to - line->from).norm();
    tangent = (line->to - line->from) / length;
  } else {
    const auto& arc = std::get<Arc>(lineOrArc);
    start = arc.start;
    tangent = arc.tangent;
    curvature = arc.curvature;
    length = arc.length;
  }
}

Point Track::at(double lambda) const {
  return curvature == 0 ? Point(start + lambda * tangent)
                        : evaluate(Arc{start, tangent, curvature, length}, lambda).point;
}

Meetings meetCircle(const Track& track, const Point& center, double radius) {
  const Vector v = track.start - center;
  const double away = v.norm();
  const double c = (away - radius) * (away + radius);
  const double k = track.curvature;
  return solve(track, 1 + k * v.dot(leftOf(track.tangent)) + c * k * k / 4, v.dot(track.tangent), c);
}

Meetings meetLine(const Track& track, const Point& through, const Vector& normal) {
  const double c = normal.dot(track.start - through);
  const double k = track.curvature;
  return solve(track, k * (normal.dot(leftOf(track.tangent)) / 2 + k * c / 4), normal.dot(track.tangent) / 2, c);
}

} // namespace arris::geometry
