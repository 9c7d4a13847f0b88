#pragma once

#include "core/job/job.h"

namespace arris::job {

/// Runs the forward pass over the whole track at an override of 100 % and tells what each piece is for. A stop ends it
/// early.
[[nodiscard]] std::vector<PlannedPiece> planPieces(const std::vector<motion::Segment>& track,
                                                   const std::vector<motion::Interval>& intervals,
                                                   const motion::AxisLimits& limits, const std::stop_token& stop = {});

/// What the pieces make of each corner, from the first time that the wheel passes it.
[[nodiscard]] std::vector<CornerResult> cornerResults(const std::vector<motion::Segment>& track,
                                                      const std::vector<PlannedPiece>& pieces, std::size_t corners);

} // namespace arris::job
