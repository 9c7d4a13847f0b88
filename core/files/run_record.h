#pragma once

#include "core/files/descriptor.h"
#include "core/files/run_row.h"
#include "core/recipe/recipe.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The record of a run, *.arrisrun: magic bytes, then blocks. Each block is a kind (1 byte), the length of its payload
// and a CRC-32 of kind, length and payload (4 bytes each, least first), and the payload: H header (JSON), R rows (see
// row_coding.h), E event (JSON), Z the end. Blocks of other kinds are passed over. A file that breaks off anywhere is
// readable up to its last whole block.

namespace arris::files {

inline constexpr std::string_view kRecordEnding = ".arrisrun";

/// The most panes that are counted.
inline constexpr int kMostPanes = 1'000'000;

/// What a record says about its run.
struct RecordHeader {
  std::string patternFile; ///< name
  std::string patternHash; ///< `fileHash` of its bytes
  std::string startTime;   ///< ISO 8601
  int pane = 1;            ///< number of the pane, from 1
  recipe::Recipe recipe;
  recipe::Machine machine;
  bool operator==(const RecordHeader&) const = default;
};

/// Something that happened during the run: a changed override, hold, resume, stop, fault, alarm, the end of a pane.
struct RunEvent {
  double time = 0; ///< s, as in the rows
  std::string code;
  std::vector<base::Value> values;
  bool operator==(const RunEvent&) const = default;
};

/// A record that was read.
struct RunRecord {
  RecordHeader header;
  std::vector<RunRow> rows; ///< as recorded: multiples of `kRecordUnit`, time increases
  std::vector<RunEvent> events;
  bool complete = false; ///< it was closed and every block is whole
  base::Problems damage; ///< RecordDamaged for each place where it is not whole; none where it is complete
};

/// Writes a record while the run goes on. Rows are gathered for about a second. A failure of the disk is returned, now
/// and ever after; what is in the file by then stays readable. For the thread that keeps the files.
class RecordWriter {
public:
  /// Creates the file; CannotWrite where it cannot, or exists.
  [[nodiscard]] static base::Expected<RecordWriter> open(const std::filesystem::path& file, const RecordHeader& header);

  /// The next row. NumericalFailure, and the row is left out, where a number is not finite or beyond all reason or the
  /// time does not increase.
  [[nodiscard]] base::Expected<void> add(const RunRow& row);

  /// NumericalFailure where its time is not finite or it is longer than a block.
  [[nodiscard]] base::Expected<void> add(const RunEvent& event);

  /// Everything that was added is handed to the system, so that it outlives this process.
  [[nodiscard]] base::Expected<void> flush();

  /// Marks the record as complete and puts it on the disk. A record that is only destroyed ends with the last flush.
  [[nodiscard]] base::Expected<void> close();

private:
  RecordWriter(std::filesystem::path file, Descriptor descriptor, double period);
  base::Expected<void> write(std::string_view bytes);
  base::Expected<void> fail(int error);

  std::filesystem::path m_file;
  Descriptor m_descriptor;
  std::size_t m_rowsOfBlock; ///< that last about a second
  std::vector<RunRow> m_rows;
  std::string m_events; ///< blocks
  std::optional<std::int64_t> m_lastTime;
  std::int64_t m_size = 0; ///< of the whole blocks in the file, bytes
  std::optional<base::Problem> m_failure;
};

/// Whether a regular file begins as records do.
[[nodiscard]] bool isRecord(const std::filesystem::path& file);

/// A whole record. CannotOpen, CannotRead; RecordMalformed and the errors of JSON where it is none of this version.
[[nodiscard]] base::Expected<RunRecord> readRecord(const std::filesystem::path& file);

/// Who hears of rows and events; either may be empty.
struct RecordListener {
  std::function<void(const RunRow&)> row;
  std::function<void(const RunEvent&)> event;
};

/// The same in little memory: rows and events go to the listener in the order of the file and not into the result.
[[nodiscard]] base::Expected<RunRecord> readRecord(const std::filesystem::path& file, const RecordListener& listener);

/// The header alone, for lists of records.
[[nodiscard]] base::Expected<RecordHeader> readRecordHeader(const std::filesystem::path& file);

/// Streams the profile of the run as CSV. The result is that of reading.
[[nodiscard]] base::Expected<RunRecord> writeProfile(const std::filesystem::path& record, Output& output);

/// The same into a file, whole or not at all: what reading or writing says.
[[nodiscard]] base::Expected<void> writeProfileFile(const std::filesystem::path& record,
                                                    const std::filesystem::path& file);

} // namespace arris::files
