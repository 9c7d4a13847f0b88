#pragma once

#include "tests/support/bench.h"

namespace arris::test {

/// Something that goes wrong with a machine of ideal axes, and how it is mended.
struct Mishap {
  control::Fault fault; ///< what a run ends in where it lasts
  std::function<void(Bench&)> begins;
  std::function<void(Bench&)> isMended;
};

[[nodiscard]] std::vector<Mishap> mishaps();

} // namespace arris::test
