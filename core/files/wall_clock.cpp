#include "core/files/wall_clock.h"

#include <ctime>

namespace arris::files {

std::string wallClock() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &local);
  return text;
}

} // namespace arris::files
