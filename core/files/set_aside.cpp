#include "core/files/set_aside.h"

#include "core/files/descriptor.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <cstdio>

namespace arris::files {
namespace {

using std::filesystem::path;

/// More damaged files of one name than anybody lets gather.
constexpr int kMostSetAside = 10'000;

// False with errno. Never over another file, also where two programs try at once.
bool renameToNew(const path& from, const path& to) {
  if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) {
    return true;
  }
  std::error_code none;
  if (errno != EINVAL || std::filesystem::exists(std::filesystem::symlink_status(to, none))) {
    return false;
  }
  return std::rename(from.c_str(), to.c_str()) == 0; // a file system that does not know the flag
}

} // namespace

base::Expected<path> setAside(const path& file) {
  for (int number = 1; number <= kMostSetAside; ++number) {
    path aside = file;
    aside += number == 1 ? std::string(".damaged") : fmt::format(".{}.damaged", number);
    if (renameToNew(file, aside)) {
      return aside;
    }
    if (errno != EEXIST && errno != EINVAL) {
      break;
    }
  }
  return base::Unexpected(systemProblem(base::Code::CannotWrite, file, errno));
}

base::Problem setAsideAndTell(const path& file) {
  const auto aside = setAside(file);
  return aside ? base::Problem(base::Code::FileSetAside, {{"file", file.string()}, {"aside", aside->string()}})
               : aside.error();
}

} // namespace arris::files
