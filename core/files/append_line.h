#pragma once

#include "core/base/problem.h"

#include <filesystem>
#include <string>

namespace arris::files {

/// Appends a line (without its end) to a text file of whole lines, which is made where there is none, and puts it on
/// the disk. A line that a power failure left half does not take this one with it. CannotWrite where the disk fails;
/// what was in the file stays readable.
[[nodiscard]] base::Expected<void> appendLine(const std::filesystem::path& file, std::string line);

} // namespace arris::files
