#include "core/base/window_thread.h"

#include <atomic>
#include <mutex>
#include <set>
#include <thread>

namespace arris::base {
namespace {

std::atomic<int> windowsOpen = 0;
std::atomic<std::thread::id> threadOfWindows;

std::mutex offendersAccess;
std::set<std::string> offenders;

} // namespace

WindowThread::WindowThread() {
  threadOfWindows = std::this_thread::get_id();
  ++windowsOpen;
}

WindowThread::~WindowThread() {
  --windowsOpen;
}

std::vector<std::string> WindowThread::takeOffenders() {
  const std::lock_guard lock(offendersAccess);
  std::vector<std::string> taken(offenders.begin(), offenders.end());
  offenders.clear();
  return taken;
}

void takesLong(const char* what) {
  if (windowsOpen > 0 && threadOfWindows.load() == std::this_thread::get_id()) {
    const std::lock_guard lock(offendersAccess);
    offenders.insert(what);
  }
}

} // namespace arris::base
