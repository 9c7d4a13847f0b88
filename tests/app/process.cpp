#include "tests/app/process.h"

#include "tests/support/scratch.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace arris::test {
namespace {

constexpr mode_t kPrivate = 0600;
constexpr int kSignalled = 128;
constexpr int kNotStarted = 127;

// Only between fork and exec: nothing here but what is allowed there.
[[noreturn]] void become(const char* program, char* const* arguments, char* const* environment, const char* out,
                         const char* err) {
  const int outFile = open(out, O_WRONLY | O_CREAT | O_TRUNC, kPrivate);
  const int errFile = open(err, O_WRONLY | O_CREAT | O_TRUNC, kPrivate);
  if (dup2(open("/dev/null", O_RDONLY), STDIN_FILENO) >= 0 && dup2(outFile, STDOUT_FILENO) >= 0 &&
      dup2(errFile, STDERR_FILENO) >= 0) {
    execve(program, arguments, environment);
  }
  _exit(kNotStarted);
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) {
    result.push_back(text.data());
  }
  result.push_back(nullptr);
  return result;
}

std::vector<std::string> environmentWith(const Environment& more) {
  std::vector<std::string> result;
  for (const char* name : {"PATH", "HOME", "TMPDIR", "ASAN_OPTIONS", "UBSAN_OPTIONS", "LSAN_OPTIONS"}) {
    if (const char* value = std::getenv(name)) {
      result.push_back(std::string(name) + "=" + value);
    }
  }
  for (const auto& [name, value] : more) {
    result.push_back(name + "=" + value);
  }
  return result;
}

/// The program while it runs.
class Process {
public:
  Process(const std::vector<std::string>& arguments, const Environment& environment)
      : m_out((m_scratch / "out").string()), m_err((m_scratch / "err").string()) {
    std::vector<std::string> texts{ARRIS_PROGRAM};
    texts.insert(texts.end(), arguments.begin(), arguments.end());
    std::vector<std::string> variables = environmentWith(environment);
    const std::vector<char*> argv = pointers(texts);
    const std::vector<char*> envp = pointers(variables);
    m_child = fork();
    if (m_child == 0) {
      become(ARRIS_PROGRAM, argv.data(), envp.data(), m_out.c_str(), m_err.c_str());
    }
  }

  void interrupt() const {
    kill(m_child, SIGINT);
  }

  Outcome wait() {
    int status = 0;
    if (m_child < 0 || waitpid(m_child, &status, 0) != m_child) {
      throw std::runtime_error("the program could not be started");
    }
    return {WIFEXITED(status) ? WEXITSTATUS(status) : kSignalled + WTERMSIG(status), contentOf(m_out),
            contentOf(m_err)};
  }

private:
  Scratch m_scratch;
  std::string m_out;
  std::string m_err;
  pid_t m_child = -1;
};

} // namespace

Outcome arris(const std::vector<std::string>& arguments, const Environment& environment) {
  return Process(arguments, environment).wait();
}

Outcome interruptedArris(const std::vector<std::string>& arguments, const std::function<bool()>& sign) {
  Process process(arguments, {});
  while (!sign()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  process.interrupt();
  return process.wait();
}

std::string sample(const std::string& name) {
  return std::string(ARRIS_SOURCE_DIR) + "/resources/samples/" + name;
}

std::string contentOf(const std::string& file) {
  std::ostringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  return content.str();
}

void writeTo(const std::string& file, const std::string& content) {
  std::ofstream(file, std::ios::binary) << content;
}

} // namespace arris::test
