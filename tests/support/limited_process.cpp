#include "tests/support/limited_process.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>
#include <exception>

namespace arris::test {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kLimitsMemory = false;
#else
constexpr bool kLimitsMemory = true;
#endif

void limit(decltype(RLIMIT_CPU) resource, rlim_t value) {
  const rlimit both{value, value};
  setrlimit(resource, &both);
}

[[noreturn]] void beTheChild(int pipe, unsigned cpuSeconds, unsigned megabytes,
                             const std::function<std::string()>& work) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, cpuSeconds);
  if (kLimitsMemory) {
    limit(RLIMIT_AS, rlim_t{megabytes} << 20U);
  }
  int status = 0;
  try {
    const std::string text = work();
    for (std::size_t written = 0; written < text.size();) {
      const ssize_t count = write(pipe, text.data() + written, text.size() - written);
      if (count <= 0) {
        break;
      }
      written += static_cast<std::size_t>(count);
    }
  } catch (const std::exception&) {
    status = 1;
  }
  _exit(status);
}

std::string readAll(int pipe) {
  std::string text;
  std::array<char, 4096> buffer{};
  for (ssize_t count = 0; (count = read(pipe, buffer.data(), buffer.size())) > 0;) {
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
  return text;
}

} // namespace

Outcome inLimitedProcess(unsigned cpuSeconds, unsigned megabytes, const std::function<std::string()>& work) {
  std::array<int, 2> ends{};
  Outcome outcome;
  if (pipe(ends.data()) != 0) {
    outcome.failure = "no pipe";
    return outcome;
  }
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    beTheChild(ends[1], cpuSeconds, megabytes, work);
  }
  close(ends[1]);
  outcome.text = readAll(ends[0]);
  close(ends[0]);
  int status = 0;
  rusage used{};
  wait4(child, &status, 0, &used);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  outcome.cpuSeconds = seconds(used.ru_utime) + seconds(used.ru_stime);
  outcome.peakMegabytes = static_cast<double>(used.ru_maxrss) / 1024;
  outcome.ended = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (WIFSIGNALED(status)) {
    outcome.failure = strsignal(WTERMSIG(status));
  } else if (!outcome.ended) {
    outcome.failure = "an exception, or no memory left";
  }
  return outcome;
}

} // namespace arris::test
