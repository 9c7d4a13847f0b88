#pragma once

#include "core/toolpath/toolpath.h"

namespace arris::toolpath {

/// The corner where an edge of direction `before` meets one of direction `after` in `s`, both unit; convex.
[[nodiscard]] Corner classify(const geometry::Point& s, const geometry::Vector& before, const geometry::Vector& after,
                              const recipe::Recipe& recipe);

/// The same corner rolled round because other glass is in the way of its transition.
[[nodiscard]] Corner rolledInstead(Corner corner, const recipe::Recipe& recipe);

} // namespace arris::toolpath
