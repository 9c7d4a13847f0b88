#pragma once

#include "core/base/problem.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace arris::files {

/// An alarm as the log keeps it.
struct Alarm {
  std::string time; ///< ISO 8601
  std::string code;
  std::string text; ///< English
  std::vector<base::Value> values;
  bool acknowledged = false;
  bool operator==(const Alarm&) const = default;
};

/// The log stays smaller than this, bytes.
inline constexpr std::size_t kLargestAlarmLog = 10'000'000;

/// Appends an alarm to the log, a text file of one JSON object a line, and puts it on the disk. An acknowledgement is
/// the alarm once more with `acknowledged` set. Where the log would grow too large its older half goes first.
/// CannotWrite where the disk fails; what was in the log stays readable.
[[nodiscard]] base::Expected<void> appendAlarm(const std::filesystem::path& log, const Alarm& alarm,
                                               std::size_t largest = kLargestAlarmLog);

/// What a log holds.
struct AlarmLog {
  std::vector<Alarm> alarms;    ///< oldest first
  std::int64_t brokenLines = 0; ///< that were passed over
  bool operator==(const AlarmLog&) const = default;
};

/// The log as it stands; an alarm that stands there again (same time, code and text) counts once, as it stands last.
/// Empty where there is no log yet. Lines that are broken are passed over and counted.
[[nodiscard]] base::Expected<AlarmLog> readAlarmLog(const std::filesystem::path& log);

/// Its alarms alone.
[[nodiscard]] base::Expected<std::vector<Alarm>> readAlarms(const std::filesystem::path& log);

} // namespace arris::files
