#pragma once

#include "core/base/caps.h"

#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <utility>

namespace arris::pattern {

/// Comparisons of curves or contours with each other that one check of a drawing may take, and as many more for each of
/// them: many times what a pane needs. Where all lie on top of each other they would be the square of their number.
inline constexpr std::int64_t kMostComparisons = 5'000'000 / base::kCapDivisor;
inline constexpr std::int64_t kMostComparisonsOfEach = 200;

/// What is left of them.
class Effort {
public:
  /// A stop leaves nothing.
  explicit Effort(std::size_t things, std::stop_token stop = {})
      : m_most(kMostComparisons + kMostComparisonsOfEach * static_cast<std::int64_t>(things)), m_left(m_most),
        m_stop(std::move(stop)) {}

  /// False once nothing is left.
  bool spend(std::int64_t comparisons = 1) {
    m_left = m_stop.stop_requested() ? 0 : m_left - comparisons;
    return m_left > 0;
  }

  [[nodiscard]] bool isSpent() const {
    return m_left <= 0;
  }

  [[nodiscard]] std::int64_t most() const {
    return m_most;
  }

private:
  std::int64_t m_most;
  std::int64_t m_left;
  std::stop_token m_stop;
};

} // namespace arris::pattern
