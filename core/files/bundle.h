#pragma once

#include "core/base/problem.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace arris::files {

/// A file in a bundle: its name with folders, "recipes/door.json", and its bytes.
struct BundledFile {
  std::string name;
  std::string bytes;
  bool operator==(const BundledFile&) const = default;
};

using BundledFiles = std::vector<BundledFile>;

/// What a bundle that is read may hold at most: bytes of the archive, of each file and of all files, and files.
struct BundleLimits {
  std::size_t archive = 64'000'000;
  std::size_t file = 16'000'000;
  std::size_t all = 128'000'000;
  std::size_t files = 2000;
};

/// Writes the files into one archive (`.tar.gz`), whole or not at all; CannotWrite with the reason.
[[nodiscard]] base::Expected<void> writeBundle(const std::filesystem::path& archive, const BundledFiles& files);

/// The files of such an archive, in memory: nothing is written. CannotOpen, CannotRead; BundleMalformed for whatever is
/// no such archive, is cut off, exceeds the limits, names a file twice, or holds what is no plain file (a folder, a
/// link, a device). The names are as they stand there, not trusted yet.
[[nodiscard]] base::Expected<BundledFiles> readBundle(const std::filesystem::path& archive,
                                                      const BundleLimits& limits = {});

/// The problem of an archive that cannot be restored.
[[nodiscard]] base::Problem malformedBundle(const std::filesystem::path& archive, std::string reason);

} // namespace arris::files
