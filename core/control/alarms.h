#pragma once

#include "core/control/report.h"
#include "core/files/alarm_log.h"

#include <optional>
#include <string>

namespace arris::control {

/// A fault as the alarm log keeps it: its code, the English sentence, and axis and figure where it has them.
[[nodiscard]] files::Alarm alarmOf(const FaultReport& fault, std::string time);

/// And back, without its tick; nothing for a code that no fault of this Arris has.
[[nodiscard]] std::optional<FaultReport> faultOf(const files::Alarm& alarm);

} // namespace arris::control
