#pragma once

#include "core/files/run_row.h"
#include "core/job/job.h"

#include <vector>

namespace arris::test {

/// A run of a planned job as axes would measure it that lag by 2 ms and whose encoders are uncertain by ±0.2 µm.
[[nodiscard]] std::vector<files::RunRow> runOf(const job::Job& job);

} // namespace arris::test
