#include "core/job/placement.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>

namespace arris::job {
namespace {

using geometry::Point;

// Quarter turns exactly: a pane turned by 90° must not lean by a rounding.
Eigen::Matrix2d rotation(double degrees) {
  const double quarters = degrees / 90;
  if (quarters != std::round(quarters)) {
    return Eigen::Rotation2Dd(base::radians(degrees)).toRotationMatrix();
  }
  Eigen::Matrix2d result = Eigen::Matrix2d::Identity();
  const Eigen::Matrix2d quarter{{0, -1}, {1, 0}};
  const int count = (static_cast<int>(std::fmod(quarters, 4)) + 4) % 4;
  for (int i = 0; i < count; ++i) {
    result = quarter * result;
  }
  return result;
}

geometry::Box outlinesBox(const std::vector<pattern::Contour>& contours, const Eigen::Isometry2d& motion) {
  geometry::Box box;
  for (const pattern::Contour& contour : contours) {
    if (contour.kind != pattern::ContourKind::Outline) {
      continue;
    }
    for (const geometry::Curve& curve : contour.curves) {
      box.extend(geometry::bounds(geometry::transformed(curve, motion)));
    }
  }
  return box.isEmpty() ? geometry::Box(Point(0, 0)) : box;
}

} // namespace

Placement placementOf(const std::vector<pattern::Contour>& contours, const recipe::Recipe& recipe,
                      const recipe::Machine& machine) {
  Placement result;
  result.rotation = base::radians(recipe.rotate);
  result.mirror = recipe.mirror;
  const Eigen::Vector2d mirror(recipe.mirror == recipe::Mirror::X ? -1 : 1,
                               recipe.mirror == recipe::Mirror::Y ? -1 : 1);
  result.motion.linear() = rotation(recipe.rotate) * mirror.asDiagonal();
  const geometry::Box box = outlinesBox(contours, result.motion);
  const Point centred = (machine.travel.head<2>() - box.sizes()) / 2;
  result.place = recipe.place.value_or(centred);
  result.motion.translation() = result.place - box.min();
  result.patternOrigin = result.motion.translation();
  return result;
}

std::vector<pattern::Contour> placed(const std::vector<pattern::Contour>& contours, const Placement& placement) {
  const bool mirrored = placement.motion.linear().determinant() < 0;
  std::vector<pattern::Contour> result = contours;
  for (pattern::Contour& contour : result) {
    for (geometry::Curve& curve : contour.curves) {
      curve = geometry::transformed(curve, placement.motion);
      curve = mirrored ? geometry::reversed(curve) : curve;
    }
    if (mirrored) {
      std::reverse(contour.curves.begin(), contour.curves.end());
    }
  }
  return result;
}

base::Problems placed(base::Problems problems, const Placement& placement) {
  for (base::Problem& problem : problems) {
    if (problem.where) {
      problem.where = placement.motion * *problem.where;
    }
  }
  return problems;
}

} // namespace arris::job
