#include "app/interruption.h"

#include <csignal>

namespace arris::app {
namespace {

volatile std::sig_atomic_t interruptions = 0;

void mark(int) {
  interruptions = 1;
}

} // namespace

void watchForInterruption() {
  struct sigaction action {};

  action.sa_handler = mark;
  action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() {
  return interruptions != 0;
}

} // namespace arris::app
