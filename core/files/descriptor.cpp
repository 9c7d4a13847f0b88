#include "core/files/descriptor.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstring>

namespace arris::files {

bool Descriptor::close() {
  return !isOpen() || ::close(std::exchange(m_number, -1)) == 0;
}

WriteSignalsBlocked::WriteSignalsBlocked() {
  sigemptyset(&m_signals);
  sigaddset(&m_signals, SIGXFSZ);
  sigaddset(&m_signals, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &m_signals, &m_before);
}

WriteSignalsBlocked::~WriteSignalsBlocked() {
  constexpr timespec kNoWait{};
  while (sigtimedwait(&m_signals, nullptr, &kNoWait) > 0) {
  }
  pthread_sigmask(SIG_SETMASK, &m_before, nullptr);
}

base::Problem systemProblem(base::Code code, const std::filesystem::path& file, int error) {
  const char* text = strerrordesc_np(error);
  return base::Problem(code, {{"file", file.string()}, {"reason", text ? text : fmt::format("error {}", error)}});
}

} // namespace arris::files
