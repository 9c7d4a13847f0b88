#pragma once

#include "core/job/job.h"
#include "tests/support/scratch.h"

#include <filesystem>

namespace arris::test {

/// The record of a run of the job, as "run.arrisrun" in the folder.
[[nodiscard]] std::filesystem::path recordOf(const job::Job& job, const Scratch& scratch);

/// The exported profile of the job, as "profile.csv" in the folder.
[[nodiscard]] std::filesystem::path profileOf(const job::Job& job, const Scratch& scratch);

/// A file of its first bytes, as "cut.arrisrun" in the folder.
[[nodiscard]] std::filesystem::path cutAt(double share, const std::filesystem::path& file, const Scratch& scratch);

} // namespace arris::test
