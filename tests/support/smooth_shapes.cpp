#include "tests/support/smooth_shapes.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>

namespace arris::test {
namespace {

using base::kPi;
using geometry::Curve;
using geometry::Line;
using geometry::Point;
using geometry::Vector;

double between(std::mt19937_64& random, double least, double most) {
  return least + (most - least) * static_cast<double>(random() >> 11U) * 0x1p-53;
}

SmoothShape ellipse(std::mt19937_64& random) {
  const double a = between(random, 25, 500);
  const double b = a * between(random, 0.3, 1);
  const Eigen::Rotation2Dd turned(between(random, 0, kPi));
  return {[=](double t) { return Point(turned * Vector(a * std::cos(2 * kPi * t), b * std::sin(2 * kPi * t))); }};
}

SmoothShape wavyCircle(std::mt19937_64& random) {
  const double radius = between(random, 50, 400);
  const int waves = 2 + static_cast<int>(random() % 6);
  const double height = between(random, 0.01, 0.5) / (1 + waves * waves);
  const double phase = between(random, 0, 2 * kPi);
  return {[=](double t) {
    const double angle = 2 * kPi * t;
    return Point(radius * (1 + height * std::cos(waves * angle + phase)) * Vector(std::cos(angle), std::sin(angle)));
  }};
}

/// Regular corners rounded by different radii.
SmoothShape roundedPolygon(std::mt19937_64& random) {
  const int count = 3 + static_cast<int>(random() % 6);
  const double size = between(random, 40, 400);
  std::vector<Curve> chain;
  const double turn = 2 * kPi / count;
  const double half = size * std::sin(turn / 2); // of a side
  std::vector<double> cuts;
  for (int i = 0; i < count; ++i) {
    cuts.push_back(half * between(random, 0.1, 0.9));
  }
  for (int i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const auto next = static_cast<std::size_t>((i + 1) % count);
    const Vector corner = size * Vector(std::cos(turn * i), std::sin(turn * i));
    const Vector after = size * Vector(std::cos(turn * (i + 1)), std::sin(turn * (i + 1)));
    const Vector along = (after - corner).normalized();
    const Vector before = Eigen::Rotation2Dd(-turn) * along;
    chain.emplace_back(geometry::arcBetween(corner - cuts[k] * before, corner + cuts[k] * along, turn));
    chain.emplace_back(Line{corner + cuts[k] * along, after - cuts[next] * along});
  }
  const double length = geometry::totalLength(chain);
  return {[chain, length](double t) {
    double way = (t - std::floor(t)) * length;
    std::size_t i = 0;
    while (i + 1 < chain.size() && way > geometry::parameterLength(chain[i])) {
      way -= geometry::parameterLength(chain[i]);
      ++i;
    }
    return geometry::pointAt(chain[i], std::min(way, geometry::parameterLength(chain[i])));
  }};
}

/// Largest distance of the curve between two parameters from its chord.
double sagittaBetween(const SmoothShape& shape, double from, double to) {
  const Curve chord = Line{shape.at(from), shape.at(to)};
  double most = 0;
  for (int i = 1; i < 8; ++i) {
    most = std::max(most, geometry::nearest(chord, shape.at(from + (to - from) * i / 8)).distance);
  }
  return most;
}

} // namespace

std::vector<Curve> roundedRectangle(double width, double height, double radius) {
  const double x = width / 2;
  const double y = height / 2;
  return {Line{{-x + radius, -y}, {x - radius, -y}},
          geometry::arcAbout({x - radius, -y + radius}, radius, -kPi / 2, kPi / 2),
          Line{{x, -y + radius}, {x, y - radius}},
          geometry::arcAbout({x - radius, y - radius}, radius, 0, kPi / 2),
          Line{{x - radius, y}, {-x + radius, y}},
          geometry::arcAbout({-x + radius, y - radius}, radius, kPi / 2, kPi / 2),
          Line{{-x, y - radius}, {-x, -y + radius}},
          geometry::arcAbout({-x + radius, -y + radius}, radius, kPi, kPi / 2)};
}

std::vector<Point> choppedEvenly(const std::vector<Curve>& chain, double chord, bool linesToo) {
  std::vector<Point> points;
  for (const Curve& curve : chain) {
    const double length = geometry::parameterLength(curve);
    const bool isChopped = linesToo || !std::holds_alternative<Line>(curve);
    const int count = isChopped ? std::max(1, static_cast<int>(std::ceil(length / chord))) : 1;
    for (int i = 0; i < count; ++i) {
      points.push_back(geometry::pointAt(curve, length * i / count));
    }
  }
  return points;
}

std::vector<Point> SmoothShape::points(int count) const {
  std::vector<Point> result;
  for (int i = 0; i < count; ++i) {
    result.push_back(at(static_cast<double>(i) / count));
  }
  return result;
}

SmoothShape randomSmoothShape(std::mt19937_64& random) {
  switch (random() % 3) {
  case 0:
    return ellipse(random);
  case 1:
    return wavyCircle(random);
  default:
    return roundedPolygon(random);
  }
}

std::vector<Point> choppedUnevenly(const SmoothShape& shape, double sagitta, double rounding, std::mt19937_64& random) {
  const double density = between(random, 0.1, 1);
  std::vector<Point> points;
  for (double t = 0; t < 1;) {
    const Point p = shape.at(t);
    points.emplace_back(rounding > 0 ? Point((p / rounding).array().round() * rounding) : p);
    double step = 1.0 / 24;
    while (sagittaBetween(shape, t, t + step) > sagitta) {
      step /= 1.1;
    }
    step *= density * between(random, 0.4, 1);
    if (1 - t <= step) {
      break;
    }
    t += std::min(step, (1 - t) / 2); // no tiny chord where the curve closes
  }
  return points;
}

} // namespace arris::test
