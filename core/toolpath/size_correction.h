#pragma once

#include "core/pattern/pattern.h"

namespace arris::toolpath {

/// The finished contours moved outwards by `correction` (mm, negative: inwards), which leaves every pane larger by it
/// and every cut-out smaller. Corners stay sharp: edges are prolonged until they meet. Where that would change the
/// shape (a part vanishes, falls apart or meets another) there is an error with its place, and the contours stay as
/// they are.
[[nodiscard]] std::vector<pattern::Contour> sizeCorrected(const std::vector<pattern::Contour>& contours,
                                                          double correction, base::Problems& problems);

} // namespace arris::toolpath
