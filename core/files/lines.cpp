#include "core/files/lines.h"

#include "core/files/descriptor.h"
#include "core/files/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

namespace arris::files {
namespace {

bool endsInALine(int descriptor, off_t size) {
  char last = '\n';
  return size == 0 || (pread(descriptor, &last, 1, size - 1) == 1 && last == '\n');
}

} // namespace

base::Expected<void> appendLine(const std::filesystem::path& file, std::string line) {
  const WriteSignalsBlocked blocked;
  constexpr mode_t kAsTheUserMaskAllows = 0666;
  Descriptor descriptor(open(file.c_str(), O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC, kAsTheUserMaskAllows));
  if (!descriptor.isOpen()) {
    return base::Unexpected(systemProblem(base::Code::CannotWrite, file, errno));
  }
  line += '\n';
  if (!endsInALine(descriptor.number(), lseek(descriptor.number(), 0, SEEK_END))) {
    line.insert(line.begin(), '\n');
  }
  Output output(descriptor.number());
  output.write(line);
  if (output.failed()) {
    return base::Unexpected(systemProblem(base::Code::CannotWrite, file, output.error()));
  }
  if (fsync(descriptor.number()) != 0 || !descriptor.close()) {
    return base::Unexpected(systemProblem(base::Code::CannotWrite, file, errno));
  }
  return {};
}

} // namespace arris::files
