#pragma once

namespace arris::test {

/// What this thread has asked of the allocator and of locks while `Counting` lives.
struct Calls {
  long allocations = 0;
  long frees = 0;
  long locks = 0;
};

class Counting {
public:
  Counting();
  Counting(const Counting&) = delete;
  Counting& operator=(const Counting&) = delete;
  ~Counting();

  [[nodiscard]] static Calls calls();
};

} // namespace arris::test
