#pragma once

#include <array>

namespace arris::motion {

/// One interval of the backward pass, in x = λ̇² at its two ends: every row demands |start·x₀ + end·x₁| ≤ limit.
struct ReachProblem {
  struct Row {
    double start = 0, end = 0, limit = 0;
  };

  std::array<Row, 4> rows; ///< two axes at two ends
  double startMost = 0;    ///< x₀ ≤
  double endMost = 0;      ///< x₁ ≤ K² at the end
};

struct ReachResult {
  double start = 0; ///< the greatest x₀ from which some x₁ is reached
  double end = 0;   ///< that x₁
};

/// Solves it exactly: the feasible set is a convex polygon that holds (0, 0).
[[nodiscard]] ReachResult greatestStart(const ReachProblem& problem);

} // namespace arris::motion
