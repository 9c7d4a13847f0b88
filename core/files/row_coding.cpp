#include "core/files/row_coding.h"

#include "core/files/profile_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace arris::files {
namespace {

using base::Code;
using base::Expected;
using base::Problem;
using base::Unexpected;

constexpr std::size_t kCells = kProfileColumns.size() + kRunColumns.size();
constexpr std::size_t kCommanded = kProfileColumns.size();
constexpr std::size_t kMeasuredVelocity = kCommanded + 3;
constexpr std::size_t kHighestOrder = 3;

/// Divided by this and not multiplied by the unit: so 0.001 comes back as 0.001.
constexpr double kUnitsInOne = 1e9;
constexpr std::int64_t kMostUnits = 1'000'000'000'000'000'000;

/// A row as whole numbers, by column.
using Cells = std::array<std::int64_t, kCells>;

std::string_view nameOfCell(std::size_t index) {
  return index < kCommanded ? kProfileColumns.at(index) : kRunColumns.at(index - kCommanded);
}

// Every number of a row but the phase, with its column: `real` those in units, `count` the whole ones.
template <typename Row, typename Real, typename Count> void visitNumbers(Row& run, Real real, Count count) {
  auto& row = run.row;
  real(column::kTime, row.time);
  for (int axis = 0; axis < 3; ++axis) {
    const auto offset = static_cast<std::size_t>(axis);
    real(column::kPosition + offset, row.position[axis]);
    real(column::kVelocity + offset, row.velocity[axis]);
    real(column::kAcceleration + offset, row.acceleration[axis]);
    real(kCommanded + offset, run.commanded[axis]);
    real(kMeasuredVelocity + offset, run.measuredVelocity[axis]);
  }
  real(column::kSpeed, row.speed);
  real(column::kPath, row.path);
  count(column::kContour, row.contour);
  count(column::kSegment, row.segment);
  count(column::kCorner, row.corner);
  if (row.corner != 0) { // without meaning otherwise; the corner comes first
    real(column::kDistance, row.distance);
  }
}

std::int64_t unitsOf(double value) {
  return std::llround(value * kUnitsInOne);
}

Cells cellsOf(const RunRow& row) {
  Cells cells{};
  visitNumbers(
      row, [&](std::size_t column, double value) { cells.at(column) = unitsOf(value); },
      [&](std::size_t column, int value) { cells.at(column) = value; });
  cells[column::kPhase] = static_cast<std::int64_t>(phaseNumber(row.row.phase).value_or(0));
  return cells;
}

std::optional<RunRow> rowOf(const Cells& cells) {
  RunRow row;
  bool sound = true;
  visitNumbers(
      row,
      [&](std::size_t column, double& value) {
        sound = sound && cells.at(column) >= -kMostUnits && cells.at(column) <= kMostUnits;
        value = static_cast<double>(cells.at(column)) / kUnitsInOne;
      },
      [&](std::size_t column, int& value) {
        sound = sound && cells.at(column) >= 0 && cells.at(column) <= std::numeric_limits<int>::max();
        value = sound ? static_cast<int>(cells.at(column)) : 0;
      });
  const auto phase = static_cast<std::uint64_t>(cells[column::kPhase]);
  if (!sound || phase >= kPhaseWords.size()) {
    return std::nullopt;
  }
  row.row.phase = kPhaseWords.at(static_cast<std::size_t>(phase));
  return row;
}

/// The differences of one order along a column, and the column from its differences. The first values are of the orders
/// that exist there. Unsigned, since damaged numbers may overflow.
class Differences {
public:
  explicit Differences(std::size_t order) : m_order(order) {}

  std::uint64_t of(std::uint64_t value) {
    const std::size_t order = orderHere();
    for (std::size_t i = 0; i < order; ++i) {
      const std::uint64_t difference = value - m_last.at(i);
      m_last.at(i) = value;
      value = difference;
    }
    return m_last.at(order) = value;
  }

  std::uint64_t valueFrom(std::uint64_t difference) {
    const std::size_t order = orderHere();
    m_last.at(order) = difference;
    for (std::size_t i = order; i-- > 0;) {
      m_last.at(i) += m_last.at(i + 1);
    }
    return m_last[0];
  }

private:
  std::size_t orderHere() {
    return std::min(m_count++, m_order);
  }

  std::size_t m_order;
  std::size_t m_count = 0;
  std::array<std::uint64_t, kHighestOrder + 1> m_last{}; ///< by order
};

constexpr unsigned kBitsOfDigit = 7;
constexpr std::uint64_t kMoreFollow = 0x80;

void putNumber(std::string& bytes, std::uint64_t value) {
  for (; value >= kMoreFollow; value >>= kBitsOfDigit) {
    bytes += static_cast<char>(value | kMoreFollow);
  }
  bytes += static_cast<char>(value);
}

void putZeros(std::string& bytes, std::uint64_t& count) {
  if (count != 0) {
    putNumber(bytes, 0);
    putNumber(bytes, count - 1);
    count = 0;
  }
}

std::string encodeColumn(std::span<const Cells> rows, std::size_t column, std::size_t order) {
  std::string bytes(1, static_cast<char>(order));
  Differences differences(order);
  std::uint64_t zeros = 0;
  for (const Cells& row : rows) {
    const std::uint64_t difference = differences.of(static_cast<std::uint64_t>(row.at(column)));
    const bool negative = (difference >> 63U) != 0;
    if (difference == 0) {
      ++zeros;
    } else {
      putZeros(bytes, zeros);
      putNumber(bytes, (difference << 1U) ^ (negative ? ~std::uint64_t{0} : 0));
    }
  }
  putZeros(bytes, zeros);
  return bytes;
}

/// Takes numbers from bytes; once it has failed everything is 0.
class NumberCursor {
public:
  explicit NumberCursor(std::string_view bytes) : m_rest(bytes) {}

  std::uint64_t number() {
    constexpr unsigned kBits = 64;
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < kBits; shift += kBitsOfDigit) {
      if (m_rest.empty()) {
        break;
      }
      const auto byte = static_cast<unsigned char>(m_rest.front());
      m_rest.remove_prefix(1);
      value |= (byte & ~kMoreFollow) << shift;
      if ((byte & kMoreFollow) == 0) {
        return value;
      }
    }
    fail();
    return 0;
  }

  void fail() {
    m_failed = true;
    m_rest = {};
  }

  [[nodiscard]] bool failed() const {
    return m_failed;
  }

  [[nodiscard]] bool atEnd() const {
    return m_rest.empty();
  }

private:
  std::string_view m_rest;
  bool m_failed = false;
};

void decodeColumn(NumberCursor& cursor, std::span<Cells> rows, std::size_t column) {
  const std::uint64_t order = cursor.number();
  if (order > kHighestOrder) {
    cursor.fail();
    return;
  }
  Differences differences(static_cast<std::size_t>(order));
  std::uint64_t zeros = 0;
  for (Cells& row : rows) {
    std::uint64_t zigzag = 0;
    if (zeros != 0) {
      --zeros;
    } else if (zigzag = cursor.number(); zigzag == 0) {
      zeros = cursor.number();
    }
    const std::uint64_t difference = (zigzag >> 1U) ^ ((zigzag & 1U) != 0 ? ~std::uint64_t{0} : 0);
    row.at(column) = static_cast<std::int64_t>(differences.valueFrom(difference));
  }
  if (zeros != 0) {
    cursor.fail();
  }
}

Unexpected cannotRecord(std::string_view column, const std::string& value) {
  return Unexpected(
      Problem(Code::NumericalFailure, {{"reason", fmt::format("{} is {} in a row of the run", column, value)}}));
}

} // namespace

std::int64_t recordedTime(const RunRow& row) {
  return unitsOf(row.row.time);
}

Expected<void> checkRow(const RunRow& row) {
  Expected<void> result;
  visitNumbers(
      row,
      [&](std::size_t column, double value) {
        if (!(std::abs(value) <= kMostRecorded)) { // nor NaN
          result = cannotRecord(nameOfCell(column), fmt::format("{}", value));
        }
      },
      [&](std::size_t column, int value) {
        if (value < 0) {
          result = cannotRecord(nameOfCell(column), fmt::format("{}", value));
        }
      });
  if (!phaseNumber(row.row.phase)) {
    return cannotRecord(nameOfCell(column::kPhase), fmt::format("\"{}\"", row.row.phase));
  }
  return result;
}

std::string encodeRows(std::span<const RunRow> rows) {
  std::vector<Cells> cells(rows.size());
  std::transform(rows.begin(), rows.end(), cells.begin(), cellsOf);
  std::string bytes;
  putNumber(bytes, rows.size());
  for (std::size_t column = 0; column < kCells; ++column) {
    std::string shortest = encodeColumn(cells, column, 0);
    for (std::size_t order = 1; order <= kHighestOrder; ++order) {
      if (std::string other = encodeColumn(cells, column, order); other.size() < shortest.size()) {
        shortest = std::move(other);
      }
    }
    bytes += shortest;
  }
  return bytes;
}

std::optional<std::vector<RunRow>> decodeRows(std::string_view bytes) {
  NumberCursor cursor(bytes);
  const std::uint64_t count = cursor.number();
  if (count > kMostRowsOfBlock) {
    return std::nullopt;
  }
  std::vector<Cells> cells(static_cast<std::size_t>(count));
  for (std::size_t column = 0; column < kCells && !cursor.failed(); ++column) {
    decodeColumn(cursor, cells, column);
  }
  if (cursor.failed() || !cursor.atEnd()) {
    return std::nullopt;
  }
  std::vector<RunRow> rows;
  rows.reserve(cells.size());
  for (const Cells& cell : cells) {
    const auto row = rowOf(cell);
    if (!row || (!rows.empty() && !(row->row.time > rows.back().row.time))) {
      return std::nullopt;
    }
    rows.push_back(*row);
  }
  return rows;
}

} // namespace arris::files
