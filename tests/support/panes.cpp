#include "tests/support/panes.h"

#include "core/base/numbers.h"
#include "tests/support/contours.h"

#include <cmath>

namespace arris::test {

using geometry::Curve;
using geometry::Line;
using geometry::Point;

pattern::Pattern paneOf(std::vector<Curve> counterClockwise) {
  pattern::Contour contour;
  contour.id = 1;
  contour.curves = std::move(counterClockwise);
  pattern::Pattern result;
  result.contours.push_back(std::move(contour));
  return result;
}

pattern::Pattern polygon(const std::vector<Point>& corners) {
  return paneOf(closedLines(corners));
}

pattern::Pattern triangle600(double degrees) {
  std::vector<Point> corners;
  for (const int k : {0, 1, 2}) {
    const double angle = base::radians(degrees - 150 + 120 * k); // the first corner is the lower left one
    corners.emplace_back(600 / std::sqrt(3.0) * Point(std::cos(angle), std::sin(angle)));
  }
  return polygon(corners);
}

pattern::Pattern isosceles(double degrees, double leg) {
  const double half = base::radians(degrees / 2);
  const Point up(leg * std::cos(half), leg * std::sin(half));
  return polygon({{0, 0}, {up.x(), -up.y()}, up});
}

} // namespace arris::test
