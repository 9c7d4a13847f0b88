#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace arris::test {

/// Seeded random numbers, the same with every library.
class Dice {
public:
  explicit Dice(std::uint64_t seed) : m_engine(seed) {}

  // Not std::uniform_real_distribution: its numbers differ between libraries.
  double between(double least, double most) {
    return least + (most - least) * static_cast<double>(m_engine() >> 11U) * 0x1p-53;
  }

  double logBetween(double least, double most) {
    return std::exp(between(std::log(least), std::log(most)));
  }

  bool chance(double share) {
    return between(0, 1) < share;
  }

private:
  std::mt19937_64 m_engine;
};

} // namespace arris::test
