#pragma once

#include <string>
#include <vector>

namespace arris::base {

/// While one lives, the thread that made it serves an operator and must stay free: what can take long is not for it.
/// All of them are made in the same thread. Without any, as in a call without a window, every thread may do all.
class WindowThread {
public:
  WindowThread();
  ~WindowThread();
  WindowThread(const WindowThread&) = delete;
  WindowThread& operator=(const WindowThread&) = delete;
  WindowThread(WindowThread&&) = delete;
  WindowThread& operator=(WindowThread&&) = delete;

  /// What held it up since the last time, each once. The program goes on all the same; the tests fail.
  [[nodiscard]] static std::vector<std::string> takeOffenders();
};

/// At the head of every function that can take long; `what` is its name, a literal.
void takesLong(const char* what);

} // namespace arris::base
