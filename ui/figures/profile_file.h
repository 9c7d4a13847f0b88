#pragma once

#include "core/base/problem.h"
#include "ui/figures/profile.h"

#include <filesystem>
#include <functional>

namespace arris::ui {

/// The most rows that a profile is read with: more than five hours at 1 ms, and less than would exhaust the memory.
inline constexpr std::size_t kMostRowsOfProfile = 20'000'000;

/// What was read from the file of a profile.
struct ProfileReading {
  base::Expected<ProfileCurves> curves; ///< under the name of the file
  base::Problems damage;                ///< of a record that is not whole: the curves are of what can be read
};

/// The curves of a profile (CSV) or of the record of a run, told apart by how they begin. CannotOpen, CannotRead (also
/// where it is too long), CsvMalformed or RecordMalformed where the file is neither or has no rows. What is no longer
/// `wanted` meanwhile is read without its rows.
[[nodiscard]] ProfileReading readProfileFile(
    const std::filesystem::path& file, const std::function<bool()>& wanted = [] { return true; });

} // namespace arris::ui
