#pragma once

#include "core/job/job.h"

#include <cstdint>

namespace arris::test {

/// A pane of lines and arcs with 3 to 40 corners, some rounded, some edges bulging, and in every fourth some hollow;
/// the others are convex. With a recipe over the whole range that a shop would use: wheel radius 5 to 150 mm, feeds and
/// accelerations over two decades. The same seed gives the same pane. It lies near the table's origin, where a position
/// has most digits.
struct RandomPane {
  pattern::Pattern pattern;
  recipe::Recipe recipe;
  recipe::Machine machine; ///< with travel for every transition
};

[[nodiscard]] RandomPane randomPane(std::uint64_t seed);

/// As `randomPane`, in one of the first seeds from `seed` on for which the pane can be ground with leads (on very short
/// edges none fits); `seed` is set to the next one.
[[nodiscard]] job::Job randomJob(std::uint64_t& seed);

} // namespace arris::test
