#pragma once

#include <cstdint>

namespace arris::base {

/// Counts that bound the work which a small file can ask for are divided by this. The fuzzer reads a million files and
/// has seconds for each, with an instrumented program on top: it meets every bound, nearer.
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
inline constexpr std::int64_t kCapDivisor = 1000;
#else
inline constexpr std::int64_t kCapDivisor = 1;
#endif

} // namespace arris::base
