#include "core/files/wall_clock.h"

#include <sys/stat.h>

#include <ctime>

namespace arris::files {
namespace {

std::string clockText(std::time_t time) {
  std::tm local{};
  localtime_r(&time, &local);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &local);
  return text;
}

} // namespace

std::string wallClock() {
  return clockText(std::time(nullptr));
}

std::string writtenAt(const std::filesystem::path& file) {
  struct stat status {};

  return stat(file.c_str(), &status) == 0 ? clockText(status.st_mtime) : std::string();
}

} // namespace arris::files
