#include "tests/fuzz/promised.h"

#include <cstdio>
#include <cstdlib>

namespace arris::test {

void endWhereBroken(const std::optional<std::string>& promise) {
  if (promise) {
    std::fprintf(stderr, "Broken promise: %s\n", promise->c_str());
    std::abort();
  }
}

} // namespace arris::test
