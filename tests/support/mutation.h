#pragma once

#include "tests/support/dice.h"

#include <string>

namespace arris::test {

/// The bytes with a few random changes: bits flipped, stretches cut out, doubled or exchanged, numbers replaced by
/// extreme ones, brackets nested very deep, the end cut off.
[[nodiscard]] std::string mutated(std::string bytes, Dice& dice);

} // namespace arris::test
