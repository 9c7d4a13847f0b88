#pragma once

#include <functional>
#include <string>

namespace arris::test {

/// How a piece of work in a process of its own ended, and what it returned.
struct Outcome {
  bool ended = false;  ///< by itself: no crash, no limit reached
  std::string failure; ///< in words, where it did not
  std::string text;
  double cpuSeconds = 0;    ///< time of the processor
  double peakMegabytes = 0; ///< the most memory it had at once (a fork begins with what its parent has)
};

/// Does `work` in a process of its own under limits: processor time in seconds, memory in MiB (under AddressSanitizer,
/// which needs address space without end, only the time is limited).
[[nodiscard]] Outcome inLimitedProcess(unsigned cpuSeconds, unsigned megabytes,
                                       const std::function<std::string()>& work);

} // namespace arris::test
