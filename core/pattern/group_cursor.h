#pragma once

#include "core/base/problem.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace arris::pattern {

/// One group of a DXF file: a code and its value, each on a line of its own.
struct Group {
  int code = 0;
  std::string_view value; ///< without blanks at either end
  std::int64_t line = 0;  ///< of the value in the file, from 1
};

/// Walks over the groups of an ASCII DXF text whose lines end in LF or CR LF.
class GroupCursor {
public:
  /// `text` must outlive the cursor and all groups read from it.
  explicit GroupCursor(std::string_view text) : m_text(text) {}

  /// Reads the next group. False at the end of the text, and for good where the text is no group: then `problem` says
  /// why.
  [[nodiscard]] bool next(Group& group);

  /// Bytes read so far: where the next group begins.
  [[nodiscard]] std::size_t offset() const {
    return m_offset;
  }

  /// Lines read so far.
  [[nodiscard]] std::int64_t line() const {
    return m_line;
  }

  [[nodiscard]] const std::optional<base::Problem>& problem() const {
    return m_problem;
  }

private:
  [[nodiscard]] std::string_view takeLine();
  [[nodiscard]] bool fail(base::Problem problem);

  std::string_view m_text;
  std::size_t m_offset = 0;
  std::int64_t m_line = 0;
  std::optional<base::Problem> m_problem;
};

/// The finite number that `text` spells with a decimal point (a leading + is allowed), in every locale.
[[nodiscard]] std::optional<double> finiteNumber(std::string_view text);
[[nodiscard]] std::optional<std::int64_t> wholeNumber(std::string_view text);

/// Text of the file as it can be shown: UTF-8 stays, anything else is taken for Windows' western code page; control
/// characters become "?".
[[nodiscard]] std::string readable(std::string_view bytes);

/// The same, shortened to what fits into a message, and in quotation marks.
[[nodiscard]] std::string quoted(std::string_view bytes);

} // namespace arris::pattern
