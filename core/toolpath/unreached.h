#pragma once

#include "core/toolpath/wheel_loop.h"

#include <vector>

namespace arris::toolpath {

/// What the wheel leaves untouched.
struct Unreached {
  std::vector<double> unground; ///< by contour in their given order, mm
  base::Problems problems;      ///< each stretch that is more than the fillet at a single concave corner
};

/// Finds every stretch of contour that is left more than 1 µm from the wheel in all loops; with the largest wheel that
/// would leave nothing but fillets there. Errors, or warnings where the recipe accepts them. What lies along loops left
/// out stays unground too; that has been told.
[[nodiscard]] Unreached findUnreached(const Glass& glass, const std::vector<WheelLoop>& loops,
                                      const std::vector<WheelLoop>& leftOut, const recipe::Recipe& recipe);

} // namespace arris::toolpath
