#pragma once

#include <filesystem>

namespace arris::test {

/// A folder of its own for the running test, empty, deleted at the end.
class Scratch {
public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  Scratch(Scratch&&) = delete;
  Scratch& operator=(Scratch&&) = delete;

  [[nodiscard]] std::filesystem::path operator/(const char* name) const {
    return m_folder / name;
  }

private:
  std::filesystem::path m_folder;
};

} // namespace arris::test
