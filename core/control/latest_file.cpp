#include "core/control/latest_file.h"

#include "core/files/whole_file.h"

#include <utility>

namespace arris::control {

LatestFile::LatestFile(std::filesystem::path file) : m_file(std::move(file)), m_thread([this] { run(); }) {}

LatestFile::~LatestFile() {
  {
    const std::lock_guard lock(m_mutex);
    m_ends = true;
  }
  m_changed.notify_one();
  m_thread.join();
}

void LatestFile::write(std::string text) {
  {
    const std::lock_guard lock(m_mutex);
    m_text = std::move(text);
  }
  m_changed.notify_one();
}

void LatestFile::remove() {
  write({});
}

std::optional<base::Problem> LatestFile::failure() {
  const std::lock_guard lock(m_mutex);
  return std::exchange(m_failure, std::nullopt);
}

void LatestFile::run() {
  std::unique_lock lock(m_mutex);
  while (true) {
    m_changed.wait(lock, [this] { return m_text || m_ends; });
    if (!m_text) {
      return;
    }
    const std::string text = *std::exchange(m_text, std::nullopt);
    lock.unlock();
    std::error_code none;
    std::optional<base::Problem> failure;
    if (text.empty()) {
      std::filesystem::remove(m_file, none);
    } else if (const auto written = files::writeWholeFile(m_file, text); !written) {
      failure = written.error();
    }
    lock.lock();
    m_failure = m_failure ? m_failure : failure;
  }
}

} // namespace arris::control
