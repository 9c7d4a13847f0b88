#pragma once

#include "core/toolpath/blocked.h"
#include "core/toolpath/glass.h"

#include <vector>

namespace arris::toolpath {

/// A part of an edge that no wheel path touches, λ on the edge, mm.
struct UntouchedPart {
  EdgeId edge = 0;
  Stretch ground;
};

/// The radius of the largest wheel, mm, below `radius`, that touches all of these parts but the fillets at single
/// concave corners: found at places along them, so it may be some percent too large where the glass is very uneven.
[[nodiscard]] double largestWheel(const Glass& glass, const std::vector<UntouchedPart>& parts, double radius);

} // namespace arris::toolpath
