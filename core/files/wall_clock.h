#pragma once

#include <filesystem>
#include <string>

namespace arris::files {

/// The present local time as records and alarms carry it, ISO 8601: "2031-05-06T07:08:09".
[[nodiscard]] std::string wallClock();

/// When a file was last written, the same way; empty where that cannot be known.
[[nodiscard]] std::string writtenAt(const std::filesystem::path& file);

} // namespace arris::files
