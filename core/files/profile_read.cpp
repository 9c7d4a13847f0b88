#include "core/base/numbers.h"
#include "core/base/window_thread.h"
#include "core/files/profile_columns.h"
#include "core/files/profile_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace arris::files {
namespace {

using base::Code;
using base::Expected;
using base::Problem;
using base::Unexpected;

using Fields = std::vector<std::string_view>;

/// Where each column of the contract stands in the file.
using Order = std::array<std::size_t, kProfileColumns.size()>;

// A text of the file in a message.
std::string clipped(std::string_view text) {
  constexpr std::size_t kLongest = 30;
  std::string result(text.substr(0, kLongest));
  std::replace_if(
      result.begin(), result.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text.size() > kLongest ? result + "..." : result;
}

void split(std::string_view line, Fields& fields) {
  fields.clear();
  for (std::size_t at = 0; at != std::string_view::npos;) {
    const std::size_t comma = line.find(',', at);
    fields.push_back(line.substr(at, comma - at));
    at = comma == std::string_view::npos ? comma : comma + 1;
  }
}

/// Reads line by line; whatever is wrong is kept as the reason of the first failure.
class ProfileReader {
public:
  ProfileReader(std::string_view text, std::string_view file) : m_rest(text), m_file(file) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF"; // as spreadsheets write it
    if (m_rest.starts_with(kByteOrderMark)) {
      m_rest.remove_prefix(kByteOrderMark.size());
    }
  }

  Expected<std::vector<ProfileRow>> read() {
    std::vector<ProfileRow> rows;
    if (!nextLine() || !readHeader()) {
      return failure("the file is empty");
    }
    while (m_reason.empty() && nextLine()) {
      rows.push_back(readRow());
      if (rows.size() > 1 && !(rows.back().time > rows[rows.size() - 2].time)) {
        fail("the time does not increase");
      }
    }
    if (!m_reason.empty() || rows.empty()) {
      return failure("it has no rows");
    }
    return rows;
  }

private:
  void fail(std::string reason) {
    if (m_reason.empty()) {
      m_reason = std::move(reason);
    }
  }

  [[nodiscard]] Unexpected failure(const char* otherwise) const {
    return Unexpected(Problem(Code::CsvMalformed,
                              {{"file", std::string(m_file)}, {"reason", m_reason.empty() ? otherwise : m_reason}})
                          .onLine(std::max<std::int64_t>(m_line, 1)));
  }

  bool nextLine() {
    if (m_rest.empty()) {
      return false;
    }
    const std::size_t end = m_rest.find('\n');
    std::string_view line = m_rest.substr(0, end);
    m_rest.remove_prefix(end == std::string_view::npos ? m_rest.size() : end + 1);
    if (line.ends_with('\r')) { // a spreadsheet has saved it
      line.remove_suffix(1);
    }
    ++m_line;
    split(line, m_fields);
    return true;
  }

  bool readHeader() {
    for (std::size_t i = 0; i < kProfileColumns.size(); ++i) {
      const auto found = std::find(m_fields.begin(), m_fields.end(), kProfileColumns[i]);
      if (found == m_fields.end()) {
        fail(fmt::format("the column {} is missing", kProfileColumns[i]));
      } else if (std::find(found + 1, m_fields.end(), kProfileColumns[i]) != m_fields.end()) {
        fail(fmt::format("the column {} stands twice", kProfileColumns[i]));
      }
      m_order[i] = static_cast<std::size_t>(found - m_fields.begin());
    }
    m_columns = m_fields.size();
    return m_reason.empty();
  }

  ProfileRow readRow() {
    ProfileRow row;
    if (m_fields.size() != m_columns) {
      fail(fmt::format("{} fields instead of {}", m_fields.size(), m_columns));
      return row;
    }
    row.time = number(column::kTime);
    row.position = vector(column::kPosition);
    row.velocity = vector(column::kVelocity);
    row.acceleration = vector(column::kAcceleration);
    row.speed = number(column::kSpeed);
    row.path = number(column::kPath);
    row.contour = count(column::kContour);
    row.segment = count(column::kSegment);
    row.phase = phase();
    row.corner = count(column::kCorner);
    if (row.corner != 0) {
      row.distance = number(column::kDistance);
    } else if (!field(column::kDistance).empty()) {
      fail("distance_mm must be empty where corner is 0");
    }
    return row;
  }

  [[nodiscard]] std::string_view field(std::size_t columnIndex) const {
    return m_fields[m_order[columnIndex]];
  }

  double number(std::size_t columnIndex) {
    const auto value = base::parseNumber<double>(field(columnIndex));
    if (!value || !std::isfinite(*value)) {
      fail(fmt::format("{} must be a finite number, not \"{}\"", kProfileColumns[columnIndex],
                       clipped(field(columnIndex))));
    }
    return value.value_or(0);
  }

  Eigen::Vector3d vector(std::size_t first) {
    const double x = number(first);
    const double y = number(first + 1);
    return {x, y, number(first + 2)};
  }

  int count(std::size_t columnIndex) {
    const auto value = base::parseNumber<int>(field(columnIndex));
    if (!value || *value < 0) {
      fail(fmt::format("{} must be a whole number from 0 on, not \"{}\"", kProfileColumns[columnIndex],
                       clipped(field(columnIndex))));
    }
    return value.value_or(0);
  }

  std::string_view phase() {
    const auto number = phaseNumber(field(column::kPhase));
    if (!number) {
      fail(fmt::format("\"{}\" is no phase", clipped(field(column::kPhase))));
    }
    return kPhaseWords.at(number.value_or(0));
  }

  std::string_view m_rest;
  std::string_view m_file;
  std::int64_t m_line = 0;
  Fields m_fields;
  std::size_t m_columns = 0;
  Order m_order{};
  std::string m_reason;
};

} // namespace

Expected<std::vector<ProfileRow>> readProfile(std::string_view text, std::string_view file) {
  base::takesLong("readProfile");
  return ProfileReader(text, file).read();
}

} // namespace arris::files
