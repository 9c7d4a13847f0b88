#pragma once

#include "core/base/problem.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace arris::files {

/// Appends a line (without its end) to a text file of whole lines, which is made where there is none, and puts it on
/// the disk. A line that a power failure left half does not take this one with it. CannotWrite where the disk fails;
/// what was in the file stays readable.
[[nodiscard]] base::Expected<void> appendLine(const std::filesystem::path& file, std::string line);

/// Calls `take` with every line of a text, without its end.
template <typename Take> void eachLine(std::string_view text, Take take) {
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    take(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
}

} // namespace arris::files
