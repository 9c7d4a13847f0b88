#pragma once

#include "core/base/problem.h"
#include "core/geometry/curve.h"

#include <vector>

namespace arris::pattern {

/// The pieces that have a length, and one of each that was drawn several times, in either direction. Whichever of the
/// copies stays does not depend on their order. What was taken out goes to `repairs`. Cost grows linearly.
[[nodiscard]] std::vector<geometry::Curve> withoutZeroLength(std::vector<geometry::Curve> pieces,
                                                             base::Problems& repairs);
[[nodiscard]] std::vector<geometry::Curve> withoutDuplicates(const std::vector<geometry::Curve>& pieces,
                                                             base::Problems& repairs);

} // namespace arris::pattern
