#pragma once

#include "core/job/job.h"

#include <string>

namespace arris::app {

// What a person wants to read after a call, for a terminal. Nobody parses it: that is what the report is for.

/// The corners, how each is treated, and the times of a planned job.
[[nodiscard]] std::string summaryOf(const job::Job& job);

/// What was found in a drawing: units, entities, contours and repairs.
[[nodiscard]] std::string summaryOf(const pattern::Pattern& pattern);

} // namespace arris::app
