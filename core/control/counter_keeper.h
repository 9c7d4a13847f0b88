#pragma once

#include "core/control/latest_file.h"
#include "core/control/report.h"
#include "core/files/counters.h"

#include <filesystem>
#include <optional>
#include <string>

namespace arris::control {

/// The counters are written so often, s of the machine's time, where they have changed.
inline constexpr double kCountersEvery = 5;

/// Counts what the machine does over its whole life, from every report on the operator's side, and keeps it in a file
/// that is always whole. A power failure costs `kCountersEvery` at most. Never waits for the disk once it counts.
class CounterKeeper {
public:
  /// Goes on from what stands in the file. One that cannot be used is set aside and told, and counting begins anew at
  /// `now`, ISO 8601; where it cannot be set aside either it stays as it is, and this counts without keeping.
  CounterKeeper(std::filesystem::path file, double period, std::string now);

  /// Writes what has been counted.
  ~CounterKeeper();
  CounterKeeper(const CounterKeeper&) = delete;
  CounterKeeper& operator=(const CounterKeeper&) = delete;

  /// The next report. Periods whose reports were lost are taken to be like it.
  void add(const Report& report);

  [[nodiscard]] files::Counters counters() const;

  /// What was wrong with the file when it was read.
  [[nodiscard]] const std::optional<base::Problem>& damage() const {
    return m_damage;
  }

  /// What could not be written: the first failure since it was asked for.
  [[nodiscard]] std::optional<base::Problem> takeFailure();

private:
  void read();
  void write();

  std::filesystem::path m_file;
  double m_period;
  files::Counters m_before; ///< this was built
  std::optional<base::Problem> m_damage;
  std::optional<LatestFile> m_writer;                           ///< none: nothing may be written
  std::int64_t m_drivesOn = 0, m_spindleOn = 0, m_grinding = 0; ///< periods since then
  double m_ground = 0;                                          ///< mm since then
  std::int64_t m_panes = 0;
  files::Counters m_written;
  std::int64_t m_tick = -1; ///< of the last report, as the following
  bool m_wasAlong = false;
  double m_path = 0;
  std::int64_t m_jobsEnded = 0;
  std::int64_t m_dueTick = 0; ///< of the next writing
};

} // namespace arris::control
