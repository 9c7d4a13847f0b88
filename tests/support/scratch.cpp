#include "tests/support/scratch.h"

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace arris::test {

Scratch::Scratch() {
  std::string pattern = (std::filesystem::temp_directory_path() / "arris-test-XXXXXX").string();
  if (!mkdtemp(pattern.data())) {
    throw std::runtime_error("no scratch folder");
  }
  m_folder = pattern;
}

Scratch::~Scratch() {
  std::error_code ignored;
  std::filesystem::remove_all(m_folder, ignored);
}

} // namespace arris::test
