#pragma once

#include "core/files/run_row.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Rows of a run as bytes: column by column, whole multiples of a unit as differences of that order (0 to 3) which makes
// the column shortest, zig-zag, seven bits a byte; zeros are counted.

namespace arris::files {

/// The unit of every number in a record: mm, s, mm/s and mm/s². Positions have nine decimals as in the CSV, speeds from
/// 1 mm/s on at least nine significant digits.
inline constexpr double kRecordUnit = 1e-9;

/// The greatest size of a number in a record, as above; its third differences still fit into 64 bits.
inline constexpr double kMostRecorded = 1e9;

/// A block holds no more rows than these.
inline constexpr std::size_t kMostRowsOfBlock = 4096;

/// The time of a row in units of the record.
[[nodiscard]] std::int64_t recordedTime(const RunRow& row);

/// NumericalFailure with the column's name for a row that cannot be recorded: a number that is not finite or beyond
/// `kMostRecorded`, a negative count, a phase that is none.
[[nodiscard]] base::Expected<void> checkRow(const RunRow& row);

/// Of rows that have been checked, up to `kMostRowsOfBlock`.
[[nodiscard]] std::string encodeRows(std::span<const RunRow> rows);

/// Nothing for bytes that are no such rows with increasing time; takes little memory whatever the bytes.
[[nodiscard]] std::optional<std::vector<RunRow>> decodeRows(std::string_view bytes);

} // namespace arris::files
