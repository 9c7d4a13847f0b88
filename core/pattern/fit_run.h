#pragma once

#include "core/pattern/chord_run.h"

#include <stop_token>

namespace arris::pattern {

/// Lines and arcs, tangential to each other, that stand for a run of chords.
struct FittedRun {
  std::vector<geometry::Curve> curves; ///< from the run's first vertex to its last; a closed run may start elsewhere
  double deviation = 0;                ///< largest distance from the chords, mm
  std::vector<std::size_t> failed;     ///< chords that could not be followed within the tolerance
};

/// Fits a run within `tolerance` by few curves: one line, arc or circle if that will do, else its straight parts and
/// arcs between them. Where not even that is within the tolerance, the result says so and is of no use.
/// A stop ends it early.
[[nodiscard]] FittedRun fitRun(const ChordRun& run, double tolerance, const std::stop_token& stop = {});

} // namespace arris::pattern
