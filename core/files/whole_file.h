#pragma once

#include "core/base/problem.h"

#include <cerrno>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace arris::files {

/// Where the text of a file goes while it is written. Nothing is buffered: give it large pieces.
class Output {
public:
  explicit Output(int descriptor) : m_descriptor(descriptor) {}

  /// Once writing has failed this does nothing.
  void write(std::string_view text);

  /// Writing has failed and the file will not come about: whoever produces much may stop.
  [[nodiscard]] bool failed() const {
    return m_error != 0;
  }

  /// Gives up: the file does not come about, as if writing had failed.
  void abandon() {
    m_error = ECANCELED;
  }

  [[nodiscard]] int error() const {
    return m_error;
  } ///< errno of the failure, 0 where there was none

private:
  int m_descriptor;
  int m_error = 0;
};

/// Writes a file whole or not at all: `produce` streams into a temporary file beside it, which then takes its name.
/// An existing file keeps its permissions and stays as it is when anything fails (CannotWrite with the reason); no
/// temporary file is left. Links are followed. What is not a regular file (/dev/stdout, a pipe) is written directly.
[[nodiscard]] base::Expected<void> writeWholeFile(const std::filesystem::path& file,
                                                  const std::function<void(Output&)>& produce);
[[nodiscard]] base::Expected<void> writeWholeFile(const std::filesystem::path& file, std::string_view text);

/// The largest file that is read, bytes: more than any drawing or profile, less than would exhaust the machine.
inline constexpr std::size_t kLargestFile = std::size_t{1} << 30;

/// The bytes of a file; CannotOpen or CannotRead with the reason. A named pipe that nobody writes to is empty.
[[nodiscard]] base::Expected<std::string> readFile(const std::filesystem::path& file);

} // namespace arris::files
