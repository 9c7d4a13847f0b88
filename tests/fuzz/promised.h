#pragma once

#include <optional>
#include <string>

namespace arris::test {

/// Ends the process, as a finding of the fuzzer, where a promise was broken.
void endWhereBroken(const std::optional<std::string>& promise);

} // namespace arris::test
