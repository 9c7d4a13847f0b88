#include "core/files/whole_file.h"

#include "core/files/descriptor.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>

namespace arris::files {
namespace {

using base::Code;
using base::Expected;
using base::Unexpected;
using std::filesystem::path;

Unexpected failure(Code code, const path& file, int error) {
  return Unexpected(systemProblem(code, file, error));
}

// A new file in a folder, deleted at the end unless it got its final name.
class TemporaryFile {
public:
  // False with errno.
  bool create(const path& folder) {
    constexpr mode_t kAsTheUserMaskAllows = 0666;
    int number = 0;
    do {
      m_path = folder / fmt::format(".arris-{}-{}.tmp", getpid(), number++);
      m_descriptor = Descriptor(open(m_path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kAsTheUserMaskAllows));
    } while (!m_descriptor.isOpen() && errno == EEXIST);
    m_exists = m_descriptor.isOpen();
    return m_exists;
  }

  // False with errno. Everything is on the disk before the name is taken, so not even a power cut leaves half a file.
  bool becomes(const path& target) {
    if (fsync(m_descriptor.number()) != 0 || !m_descriptor.close() ||
        std::rename(m_path.c_str(), target.c_str()) != 0) {
      return false;
    }
    m_exists = false;
    const Descriptor folder(open(m_path.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    fsync(folder.number());
    return true;
  }

  [[nodiscard]] int descriptor() const {
    return m_descriptor.number();
  }

  TemporaryFile() = default;

  ~TemporaryFile() {
    if (m_exists) {
      unlink(m_path.c_str());
    }
  }

  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  TemporaryFile(TemporaryFile&&) = delete;
  TemporaryFile& operator=(TemporaryFile&&) = delete;

private:
  path m_path;
  Descriptor m_descriptor;
  bool m_exists = false;
};

// The file that a chain of links leads to, whether it exists or not: the renaming must not replace a link.
path followLinks(path file) {
  constexpr int kMostLinks = 40; // as the system's own limit
  std::error_code error;
  for (int i = 0; i < kMostLinks && std::filesystem::is_symlink(file, error); ++i) {
    file = file.parent_path() / std::filesystem::read_symlink(file, error);
  }
  return file;
}

Expected<void> writeDirectly(const path& file, Descriptor descriptor, const std::function<void(Output&)>& produce) {
  if (!descriptor.isOpen()) {
    return failure(Code::CannotWrite, file, errno);
  }
  Output output(descriptor.number());
  produce(output);
  if (output.failed()) {
    return failure(Code::CannotWrite, file, output.error());
  }
  if (!descriptor.close()) {
    return failure(Code::CannotWrite, file, errno);
  }
  return {};
}

Expected<void> replaceFile(const path& file, const path& target, const struct stat* existing,
                           const std::function<void(Output&)>& produce) {
  if (existing && faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0) {
    return failure(Code::CannotWrite, file, errno);
  }
  const path folder = target.has_parent_path() ? target.parent_path() : path(".");
  TemporaryFile temporary;
  if (!temporary.create(folder)) {
    return failure(Code::CannotWrite, file, errno);
  }
  if (existing) {
    // Whose file it is matters to root alone; for others the first call fails and changes nothing.
    (void)!fchown(temporary.descriptor(), existing->st_uid, existing->st_gid);
    (void)!fchmod(temporary.descriptor(), existing->st_mode & static_cast<mode_t>(07777));
  }
  Output output(temporary.descriptor());
  produce(output);
  if (output.failed()) {
    return failure(Code::CannotWrite, file, output.error());
  }
  if (!temporary.becomes(target)) {
    return failure(Code::CannotWrite, file, errno);
  }
  return {};
}

constexpr std::size_t kReadPiece = std::size_t{1} << 20;

// False with errno.
bool readAll(int descriptor, std::string& text) {
  std::size_t size = 0;
  while (size <= kLargestFile) {
    text.resize(std::max(text.size(), size + kReadPiece));
    const ssize_t count = ::read(descriptor, text.data() + size, text.size() - size);
    if (count == 0) {
      text.resize(size);
      return true;
    }
    if (count < 0 && errno != EINTR) {
      return false;
    }
    size += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  errno = EFBIG;
  return false;
}

} // namespace

void Output::write(std::string_view text) {
  while (!text.empty() && !failed()) {
    const ssize_t count = ::write(m_descriptor, text.data(), text.size());
    if (count >= 0) {
      text.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno != EINTR) {
      m_error = errno;
    }
  }
}

Expected<void> writeWholeFile(const path& file, const std::function<void(Output&)>& produce) {
  const WriteSignalsBlocked blocked;
  if (file == "/dev/stdout") { // opened anew it would overwrite what was printed to the same file before
    return writeDirectly(file, Descriptor(dup(STDOUT_FILENO)), produce);
  }

  struct stat status {};

  const bool exists = stat(file.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) {
    return failure(Code::CannotWrite, file, errno);
  }
  if (exists && S_ISDIR(status.st_mode)) {
    return failure(Code::CannotWrite, file, EISDIR);
  }
  if (exists && !S_ISREG(status.st_mode)) {
    return writeDirectly(file, Descriptor(open(file.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC)), produce);
  }
  return replaceFile(file, followLinks(file), exists ? &status : nullptr, produce);
}

Expected<void> writeWholeFile(const path& file, std::string_view text) {
  return writeWholeFile(file, [text](Output& output) { output.write(text); });
}

// A named pipe that nobody writes to has an end at once; opened otherwise it would be waited for.
Expected<std::string> readFile(const path& file) {
  const Descriptor descriptor(open(file.c_str(), O_RDONLY | O_NOCTTY | O_CLOEXEC | O_NONBLOCK));
  if (!descriptor.isOpen()) {
    return failure(Code::CannotOpen, file, errno);
  }
  (void)fcntl(descriptor.number(), F_SETFL, O_RDONLY);

  struct stat status {};

  if (fstat(descriptor.number(), &status) == 0 && S_ISREG(status.st_mode) &&
      static_cast<std::size_t>(status.st_size) > kLargestFile) {
    return failure(Code::CannotRead, file, EFBIG);
  }
  std::string text;
  text.reserve(static_cast<std::size_t>(std::max<off_t>(status.st_size, 0)) + kReadPiece + 1);
  if (!readAll(descriptor.number(), text)) {
    return failure(Code::CannotRead, file, errno);
  }
  return text;
}

} // namespace arris::files
