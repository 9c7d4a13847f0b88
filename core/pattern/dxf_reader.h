#pragma once

#include "core/base/caps.h"
#include "core/pattern/dxf_selection.h"
#include "core/pattern/pieces.h"

#include <stop_token>

namespace arris::pattern {

/// All splines, ellipses and unevenly scaled arcs of a drawing together may take this many steps of fitting.
inline constexpr std::int64_t kMostFittingSteps = 2'000'000 / base::kCapDivisor;

/// Lines and arcs of entities, and what is wrong with entities that are no such.
struct ReadEntities {
  Pieces pieces;          ///< mm; one without length stays one (a line or an arc of length 0)
  base::Problems repairs; ///< parts without length within a polyline, which are left out
  base::Problems problems;
};

/// Reads entities that have passed the gate, the plain ones with dxflib; independent of every locale. What one entity
/// draws without a break is one piece. Splines, ellipses, and arcs that are scaled unevenly become lines and arcs
/// within `geometry::kFitTolerance`.
/// A stop ends it early.
[[nodiscard]] ReadEntities readEntities(const Selection& selection, const std::stop_token& stop = {});

} // namespace arris::pattern
