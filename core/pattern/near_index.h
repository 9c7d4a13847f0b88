#pragma once

#include "core/base/tolerances.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace arris::pattern {

/// Finds things that are all but equal by four numbers each, mm, in a hash: numbers of equal things differ by at most
/// `kSamePlace`, so they may lie in neighbouring cells.
class NearIndex {
public:
  using Numbers = std::array<double, 4>;

  explicit NearIndex(std::size_t things) : m_buckets(bucketCount(things), kNone) {
    m_next.reserve(things);
  }

  /// The number (in the order in which they were added, from 0) of one that `isEqual(number)` accepts.
  template <typename IsEqual>
  [[nodiscard]] std::optional<std::size_t> find(const Numbers& numbers, IsEqual isEqual) const {
    Cells lower{};
    Cells upper{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      lower[i] = cell(numbers[i] - base::kSamePlace);
      upper[i] = cell(numbers[i] + base::kSamePlace);
    }
    for (unsigned choice = 0; choice < 16; ++choice) {
      Cells cells = lower;
      bool repeated = false;
      for (std::size_t i = 0; i < cells.size(); ++i) {
        if (((choice >> i) & 1U) != 0) {
          repeated = repeated || lower[i] == upper[i];
          cells[i] = upper[i];
        }
      }
      for (std::uint32_t k = repeated ? kNone : m_buckets[bucket(cells)]; k != kNone; k = m_next[k]) {
        if (isEqual(std::size_t{k})) {
          return k;
        }
      }
    }
    return std::nullopt;
  }

  void add(const Numbers& numbers) {
    Cells cells{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      cells[i] = cell(numbers[i]);
    }
    std::uint32_t& head = m_buckets[bucket(cells)];
    m_next.push_back(head);
    head = static_cast<std::uint32_t>(m_next.size() - 1);
  }

private:
  using Cells = std::array<std::int64_t, 4>;
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  static std::size_t bucketCount(std::size_t things) {
    std::size_t count = 16;
    while (count < 2 * things) {
      count *= 2;
    }
    return count;
  }

  static std::int64_t cell(double x) {
    constexpr double kCell = 64 * base::kSamePlace;
    return static_cast<std::int64_t>(std::floor(x / kCell));
  }

  [[nodiscard]] std::size_t bucket(const Cells& cells) const {
    std::uint64_t hash = 0;
    for (const std::int64_t c : cells) {
      hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15U;
      hash ^= hash >> 32U;
    }
    return hash & (m_buckets.size() - 1);
  }

  std::vector<std::uint32_t> m_buckets; ///< last thing of each
  std::vector<std::uint32_t> m_next;    ///< the one before in the same bucket
};

} // namespace arris::pattern
