#include "core/program/travel.h"

#include <algorithm>

namespace arris::program {
namespace {

/// What rounding may put outside the travel, mm.
constexpr double kInsideTravel = 1e-6;

Eigen::AlignedBox3d boxOf(const motion::Segment& segment) {
  Eigen::AlignedBox3d box;
  if (const auto* vertical = std::get_if<motion::Vertical>(&segment.shape)) {
    box.extend(Eigen::Vector3d(vertical->at.x(), vertical->at.y(), vertical->from));
    box.extend(Eigen::Vector3d(vertical->at.x(), vertical->at.y(), vertical->to));
  } else {
    const geometry::Box plane = geometry::bounds(motion::curveOf(segment));
    box.extend(Eigen::Vector3d(plane.min().x(), plane.min().y(), segment.z));
    box.extend(Eigen::Vector3d(plane.max().x(), plane.max().y(), segment.z));
  }
  return box;
}

} // namespace

std::optional<base::Problem> outsideTravel(std::span<const motion::Segment> way, const recipe::Machine& machine,
                                           const Eigen::Vector3d& origin) {
  for (const motion::Segment& segment : way) {
    const Eigen::AlignedBox3d box = boxOf(segment);
    const double excess = std::max((-box.min() - origin).maxCoeff(), (box.max() + origin - machine.travel).maxCoeff());
    if (excess > kInsideTravel) {
      return base::Problem(base::Code::OutsideTravel,
                           {{"what", std::string("the way with this origin")}, {"excess_mm", excess}})
          .at(box.center().head<2>());
    }
  }
  return std::nullopt;
}

} // namespace arris::program
