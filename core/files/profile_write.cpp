#include "core/files/profile_columns.h"
#include "core/files/profile_csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>

namespace arris::files {
namespace {

/// Significant digits of every number but the positions: 1 µs in the last digit after a day.
constexpr int kDigits = 12;

/// A speed or acceleration below this is rounding, mm/s and mm/s².
constexpr double kNothing = 1e-12;

constexpr std::size_t kRowsPiece = std::size_t{1} << 18; ///< bytes given to the output at a time
constexpr std::size_t kLongestRow = 1024;
constexpr std::ptrdiff_t kLongestNumber = 32;

/// Rows as text, gathered into large pieces.
class Rows {
public:
  explicit Rows(Output& output) : m_output(output), m_buffer(kRowsPiece + kLongestRow, '\0'), m_end(m_buffer.data()) {}

  void header() {
    for (const std::string_view name : kProfileColumns) {
      text(name);
      separate();
    }
    endRow();
  }

  void row(const ProfileRow& row) {
    number(row.time);
    for (const double x : row.position) {
      position(x);
    }
    for (const double v : row.velocity) {
      number(v);
    }
    for (const double a : row.acceleration) {
      number(a);
    }
    number(row.speed);
    number(row.path);
    integer(row.contour);
    integer(row.segment);
    text(row.phase);
    separate();
    integer(row.corner);
    if (row.corner != 0) {
      number(row.distance);
    } else {
      separate();
    }
    endRow();
  }

  void flush() {
    m_output.write({m_buffer.data(), static_cast<std::size_t>(m_end - m_buffer.data())});
    m_end = m_buffer.data();
  }

private:
  void text(std::string_view text) {
    m_end = std::copy(text.begin(), text.end(), m_end);
  }

  void separate() {
    *m_end++ = ',';
  }

  void integer(int value) {
    m_end = std::to_chars(m_end, m_end + kLongestNumber, value).ptr;
    separate();
  }

  void number(double value) {
    if (std::abs(value) < kNothing) {
      *m_end++ = '0';
    } else {
      m_end = std::to_chars(m_end, m_end + kLongestNumber, value, std::chars_format::general, kDigits).ptr;
    }
    separate();
  }

  // Nine decimals through integers: as exact as positions on a table are, and several times faster.
  void position(double value) {
    constexpr std::int64_t kPerMillimetre = 1'000'000'000;
    const std::int64_t units = std::llround(value * static_cast<double>(kPerMillimetre));
    if (units < 0) {
      *m_end++ = '-';
    }
    const std::int64_t size = std::abs(units);
    m_end = std::to_chars(m_end, m_end + kLongestNumber, size / kPerMillimetre).ptr;
    *m_end++ = '.';
    std::int64_t decimals = size % kPerMillimetre;
    for (char* digit = m_end + 9; digit != m_end; decimals /= 10) {
      *--digit = static_cast<char>('0' + decimals % 10);
    }
    m_end += 9;
    separate();
  }

  // The last separator becomes the end of the line.
  void endRow() {
    m_end[-1] = '\n';
    if (static_cast<std::size_t>(m_end - m_buffer.data()) >= kRowsPiece) {
      flush();
    }
  }

  Output& m_output;
  std::string m_buffer;
  char* m_end;
};

ProfileRow rowOf(const job::Sample& sample) {
  const motion::SetPoint& at = sample.setPoint;
  return {at.time,        at.position,    at.velocity,    at.axisAcceleration,     sample.speed,
          sample.path,    sample.contour, sample.segment, job::name(sample.phase), sample.corner,
          sample.distance};
}

} // namespace

void writeProfile(const job::Job& job, Output& output, const std::function<void(double)>& progress) {
  constexpr std::size_t kRowsBetweenProgress = 10000;
  Rows rows(output);
  rows.header();
  job::Sampler sampler(job);
  const std::size_t count = sampler.count();
  for (std::size_t i = 0; !sampler.done() && !output.failed(); ++i) {
    rows.row(rowOf(sampler.next()));
    if (progress && i % kRowsBetweenProgress == 0) {
      progress(static_cast<double>(i) / static_cast<double>(count));
    }
  }
  rows.flush();
}

} // namespace arris::files
