#pragma once

#include "core/base/problem.h"
#include "core/pattern/pieces.h"

namespace arris::pattern {

/// The pieces that have a length, without curves that have none, and one of each piece that was drawn several times, in
/// either direction. Whichever of the copies stays does not depend on their order. What was taken out goes to
/// `repairs`. Cost grows linearly.
[[nodiscard]] Pieces withoutZeroLength(Pieces pieces, base::Problems& repairs);
[[nodiscard]] Pieces withoutDuplicates(Pieces pieces, base::Problems& repairs);

} // namespace arris::pattern
