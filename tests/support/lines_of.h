#pragma once

#include <string>
#include <vector>

namespace arris::test {

/// The lines of a text, without their ends.
[[nodiscard]] std::vector<std::string> linesOf(const std::string& text);

} // namespace arris::test
