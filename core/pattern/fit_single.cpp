#include "core/pattern/fit_single.h"

#include "core/base/numbers.h"

#include <Eigen/LU>

#include <cmath>

namespace arris::pattern {
namespace {

using base::squared;
using geometry::Arc;
using geometry::Point;
using geometry::Vector;

/// Each step of the method of Gauss and Newton doubles the digits at least.
constexpr int kSteps = 6;

/// An arc that turns by less than this is a line, rad.
constexpr double kLeastSweep = 1e-9;

Point centroid(std::span<const Point> points) {
  Point sum = Point::Zero();
  for (const Point& p : points) {
    sum += p;
  }
  return sum / static_cast<double>(points.size());
}

/// Where on the line of centres w·d the circle of radius r₀ + slope·w passes the point, so that it passes there in the
/// given direction when it runs to the left: |p − w d|² = (r₀ + slope w)².
double centreThrough(const Point& p, const Vector& d, double r0, double slope, const Vector& direction) {
  const double a = 1 - squared(slope);
  const double b = p.dot(d) + r0 * slope;
  const double c = p.squaredNorm() - squared(r0);
  const double root = std::sqrt(std::max(0.0, squared(b) - a * c));
  const double w1 = b >= 0 ? (b + root) / a : (b - root) / a;
  const double w2 = c / (a * w1);
  const auto fits = [&](double w) { return geometry::cross((p - w * d).normalized(), direction); };
  return fits(w1) > fits(w2) ? w1 : w2;
}

} // namespace

Arc circleThrough(std::span<const Point> points, bool turnsLeft) {
  Point center = centroid(points);
  double radius = 0;
  for (const Point& p : points) {
    radius += (p - center).norm() / static_cast<double>(points.size());
  }
  for (int step = 0; step < kSteps; ++step) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const Point& p : points) {
      const Vector away = p - center;
      const double distance = away.norm();
      const Eigen::Vector3d row(away.x() / distance, away.y() / distance, 1);
      normal += row * row.transpose();
      right += row * (distance - radius);
    }
    const Eigen::Vector3d change = normal.inverse() * right;
    center += change.head<2>();
    radius += change.z();
  }
  return geometry::arcAbout(center, radius, -base::kPi / 2, turnsLeft ? 2 * base::kPi : -2 * base::kPi);
}

// Seen from a point of the arc the ends are half the sweep away from being opposite each other.
std::optional<Arc> arcThrough(const Point& from, const Point& to, std::span<const Point> between) {
  double sum = 0;
  double weights = 0;
  for (const Point& p : between) {
    const double weight = (p - from).squaredNorm() * (to - p).squaredNorm(); // square of distance by angle
    sum += weight * geometry::turn(p - from, to - p);
    weights += weight;
  }
  const double sweep = 2 * sum / weights;
  if (from == to || !(std::abs(sweep) > kLeastSweep)) {
    return std::nullopt;
  }
  return geometry::arcBetween(from, to, sweep);
}

// n₁·(c − p₁) = n₂·(c − p₂) = r: the centres lie on a line, c = c₀ + w d with d across n₁ − n₂.
std::optional<Fillet> filletThrough(const Point& onFirst, const Vector& first, const Point& onSecond,
                                    const Vector& second, double turn, std::span<const Point> between) {
  const Vector n1 = geometry::leftOf(first);
  const Vector normal = n1 - geometry::leftOf(second);
  if (normal.squaredNorm() < squared(kLeastSweep)) {
    return std::nullopt;
  }
  const Vector d = geometry::leftOf(normal.normalized());
  const Point origin = (onFirst + onSecond) / 2;
  const double onCentres = (n1.dot(onFirst - origin) - geometry::leftOf(second).dot(onSecond - origin));
  const Point base = origin + normal * (onCentres / normal.squaredNorm());
  const auto radiusAt = [&](double w) { return n1.dot(base + w * d - onFirst); };
  const double slope = n1.dot(d);
  double w = centreThrough(between[between.size() / 2] - base, d, radiusAt(0), slope,
                           Eigen::Rotation2Dd(turn / 2) * first * (turn > 0 ? 1 : -1));
  for (int step = 0; step < kSteps; ++step) {
    double sum = 0;
    double weights = 0;
    for (const Point& p : between) {
      const Vector fromCenter = p - (base + w * d);
      const double distance = fromCenter.norm();
      const double change = -fromCenter.dot(d) / distance - std::copysign(slope, slope * radiusAt(w));
      sum -= change * (distance - std::abs(radiusAt(w)));
      weights += squared(change);
    }
    w += weights > 0 ? sum / weights : 0;
  }
  return Fillet{base + w * d, radiusAt(w)};
}

} // namespace arris::pattern
