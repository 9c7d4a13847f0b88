#include "app/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace arris::app {
namespace {

constexpr const char* kClearLine = "\r\033[K";

}

Progress::Progress() : m_onTerminal(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  show("");
}

void Progress::show(std::string_view what) const {
  if (m_onTerminal) {
    std::fputs(fmt::format("{}{}", kClearLine, what).c_str(), stderr);
    std::fflush(stderr);
  }
}

void Progress::show(std::string_view what, double fraction) {
  const int percent = static_cast<int>(fraction * 100);
  if (m_onTerminal && percent != m_percent) {
    m_percent = percent;
    show(fmt::format("{} … {} %", what, percent));
  }
}

} // namespace arris::app
