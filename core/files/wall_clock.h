#pragma once

#include <string>

namespace arris::files {

/// The present local time as records and alarms carry it, ISO 8601: "2031-05-06T07:08:09".
[[nodiscard]] std::string wallClock();

} // namespace arris::files
