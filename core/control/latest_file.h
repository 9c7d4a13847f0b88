#pragma once

#include "core/base/problem.h"

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace arris::control {

/// Keeps a small file up to date on a thread of its own: whoever gives a text never waits for the disk. Where texts
/// come faster than they can be written, the latest one wins. The file is whole at every moment.
class LatestFile {
public:
  explicit LatestFile(std::filesystem::path file);
  LatestFile(const LatestFile&) = delete;
  LatestFile& operator=(const LatestFile&) = delete;

  /// Writes what waits.
  ~LatestFile();

  void write(std::string text);

  /// The file goes away.
  void remove();

  /// The first failure, once.
  [[nodiscard]] std::optional<base::Problem> failure();

private:
  void run();

  std::filesystem::path m_file;
  std::mutex m_mutex;
  std::condition_variable m_changed;
  std::optional<std::string> m_text; ///< that waits; empty: the file is to go
  std::optional<base::Problem> m_failure;
  bool m_ends = false;
  std::thread m_thread; ///< last: it uses the others
};

} // namespace arris::control
