#pragma once

#include "core/motion/track.h"
#include "core/recipe/recipe.h"

#include <optional>
#include <span>

namespace arris::program {

/// Whether a way stays inside the travel where the table's zero stands at `origin` (G54, machine coordinates, mm):
/// OutsideTravel with the place where it does not, or nothing.
[[nodiscard]] std::optional<base::Problem> outsideTravel(std::span<const motion::Segment> way,
                                                         const recipe::Machine& machine, const Eigen::Vector3d& origin);

} // namespace arris::program
