#pragma once

#include "core/files/bundle.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// What the operator has set, in one file: `settings.json`, `machine.json`, `recipe.json`, `recipes/*.json` and
// `counters.json` of the state folder, as far as they are there, and before them `arris-bundle.json`, which says what
// it is and carries the fingerprint of each.

namespace arris::files {

/// What a back-up or support bundle says of itself beside its kind.
struct BundleOrigin {
  std::string made;                ///< ISO 8601
  std::vector<base::Value> system; ///< versions of what Arris runs on: {"qt", "6.4.2"}
};

/// A back-up that has been read and checked, but not restored.
struct BackUp {
  std::string made;  ///< ISO 8601
  std::string arris; ///< version that made it
  BundledFiles files;
};

/// Writes a back-up of the state folder; gives the number of files in it. Where there are none nothing is written and
/// it is 0. CannotRead, CannotWrite.
[[nodiscard]] base::Expected<std::size_t> writeBackUp(const std::filesystem::path& stateFolder,
                                                      const std::filesystem::path& archive, const BundleOrigin& origin);

/// The same with the alarm log, the resume point and the latest records of runs, for whoever helps. What cannot be read
/// is left out and named in it.
[[nodiscard]] base::Expected<std::size_t> writeSupportBundle(const std::filesystem::path& stateFolder,
                                                             const std::filesystem::path& archive,
                                                             const BundleOrigin& origin);

/// Reads a back-up and checks all of it: only the files named above, each with its fingerprint and valid as what it is.
/// BundleMalformed, or what is wrong with a file in it.
[[nodiscard]] base::Expected<BackUp> readBackUp(const std::filesystem::path& archive, const BundleLimits& limits = {});

/// Puts the files of a back-up into the state folder, all or none of them; other files there stay. What is there before
/// is kept first, as a back-up `back-ups/before-restore-….tar.gz` of the same folder, which is returned where there was
/// anything. CannotRead, CannotWrite.
[[nodiscard]] base::Expected<std::optional<std::filesystem::path>>
restoreBackUp(const BackUp& backUp, const std::filesystem::path& stateFolder, const BundleOrigin& now);

} // namespace arris::files
