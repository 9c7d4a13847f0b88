#pragma once

#include "core/base/problem.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

namespace arris::files {

/// A folder keeps no more records than these, bytes and files.
inline constexpr std::size_t kMostRecords = 100;
inline constexpr std::uintmax_t kMostRecordBytes = 5'000'000'000;

/// A name for the record of a run that starts at `startTime` (ISO 8601), `run-2031-05-06T07-08-09.arrisrun`, with a
/// number behind where that is taken.
[[nodiscard]] std::filesystem::path newRecordFile(const std::filesystem::path& folder, std::string_view startTime);

/// Deletes the oldest records (by the time of their last change) until no more than `most` and `mostBytes` are left;
/// the newest stays however large. Only files with names of `newRecordFile` are touched: a renamed record stays. The
/// first failure, after whatever else could be done: CannotRead of the folder, CannotWrite of a record that does not
/// go.
[[nodiscard]] base::Expected<void> dropOldRecords(const std::filesystem::path& folder, std::size_t most = kMostRecords,
                                                  std::uintmax_t mostBytes = kMostRecordBytes);

} // namespace arris::files
