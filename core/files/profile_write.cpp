#include "core/base/window_thread.h"
#include "core/files/profile_columns.h"
#include "core/files/profile_csv.h"
#include "core/files/run_row.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <span>
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

ProfileRow rowOf(const job::Sample& sample) {
  const motion::SetPoint& at = sample.setPoint;
  return {at.time,        at.position,    at.velocity,    at.axisAcceleration,     sample.speed,
          sample.path,    sample.contour, sample.segment, job::name(sample.phase), sample.corner,
          sample.distance};
}

} // namespace

/// Rows as text, gathered into large pieces.
class ProfileText {
public:
  explicit ProfileText(Output& output)
      : m_output(output), m_buffer(kRowsPiece + kLongestRow, '\0'), m_end(m_buffer.data()) {}

  void names(std::span<const std::string_view> columns) {
    for (const std::string_view name : columns) {
      text(name);
      separate();
    }
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
  }

  void runRow(const RunRow& run) {
    row(run.row);
    for (const double x : run.commanded) {
      position(x);
    }
    for (const double v : run.measuredVelocity) {
      number(v);
    }
  }

  // The last separator becomes the end of the line.
  void endRow() {
    m_end[-1] = '\n';
    if (static_cast<std::size_t>(m_end - m_buffer.data()) >= kRowsPiece) {
      flush();
    }
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

  Output& m_output;
  std::string m_buffer;
  char* m_end;
};

void writeProfile(const job::Job& job, Output& output, const std::function<void(double)>& progress) {
  base::takesLong("writeProfile");
  constexpr std::size_t kRowsBetweenProgress = 10000;
  ProfileText text(output);
  text.names(kProfileColumns);
  text.endRow();
  job::Sampler sampler(job);
  const std::size_t count = sampler.count();
  for (std::size_t i = 0; !sampler.done() && !output.failed(); ++i) {
    text.row(rowOf(sampler.next()));
    text.endRow();
    if (progress && i % kRowsBetweenProgress == 0) {
      progress(static_cast<double>(i) / static_cast<double>(count));
    }
  }
  text.flush();
}

RunProfileWriter::RunProfileWriter(Output& output) : m_text(std::make_unique<ProfileText>(output)) {
  m_text->names(kProfileColumns);
  m_text->names(kRunColumns);
  m_text->endRow();
}

RunProfileWriter::RunProfileWriter(RunProfileWriter&&) noexcept = default;
RunProfileWriter& RunProfileWriter::operator=(RunProfileWriter&&) noexcept = default;
RunProfileWriter::~RunProfileWriter() = default;

void RunProfileWriter::add(const RunRow& row) {
  m_text->runRow(row);
  m_text->endRow();
}

void RunProfileWriter::flush() {
  m_text->flush();
}

} // namespace arris::files
