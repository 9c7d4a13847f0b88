#pragma once

#include "core/base/problem.h"
#include "core/files/state_folder.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// What there is to open, as lists of files and folders. All of it asks the file system, which can take long.

namespace arris::ui {

struct ShelfEntry {
  std::filesystem::path path;
  bool isFolder = false;

  bool operator==(const ShelfEntry&) const = default;
};

/// A list of patterns, and why it is not whole.
struct ShelfListing {
  std::filesystem::path folder; ///< whose entries these are; empty: they are from several
  std::vector<ShelfEntry> entries;
  std::filesystem::path chosen; ///< the entry that was asked for; empty: none in particular
  std::optional<base::Problem> problem;
};

/// Those of the files that are there, in the same order.
[[nodiscard]] std::vector<std::filesystem::path> stillThere(const std::vector<std::string>& files);

[[nodiscard]] ShelfListing listRecent(const std::vector<std::string>& files);

/// The folders and drawings (*.dxf in any case) in a folder, each by name. For a file the folder that it is in, with
/// the file among the entries and chosen, whatever it is called. CannotOpen where there is no such folder or none that
/// may be read.
[[nodiscard]] ShelfListing listFolder(const std::filesystem::path& place);

/// The patterns that come with the program. Those that are missing in the state folder are written first; what the
/// operator has changed there stays. CannotWrite where one could not be.
[[nodiscard]] ShelfListing listSamples(const files::StateFolder& state);

/// The sample to begin with, which can be ground with the values of a new program; CannotWrite as above.
[[nodiscard]] base::Expected<std::filesystem::path> firstSample(const files::StateFolder& state);

} // namespace arris::ui
