#include "tests/support/lines_of.h"

#include <sstream>

namespace arris::test {

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    result.push_back(line);
  }
  return result;
}

} // namespace arris::test
