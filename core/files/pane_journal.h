#pragma once

#include "core/base/problem.h"

#include <filesystem>
#include <string>
#include <vector>

namespace arris::files {

/// What the operator said of a pane. Unjudged: nothing before the program ended.
enum class Verdict { Good, Reject, Unjudged };

/// A pane that has been ground or given up, as the journal keeps it.
struct PaneEntry {
  std::string time;        ///< of the verdict, ISO 8601
  std::string patternFile; ///< without its path
  std::string patternHash; ///< `fileHash` of its bytes
  int pane = 1;            ///< number in its order, rejects counted
  Verdict verdict = Verdict::Good;
  double duration = 0; ///< s of grinding, every run of the pane together
  bool operator==(const PaneEntry&) const = default;
};

/// Appends a pane to the journal, a text file of one JSON object a line, and puts it on the disk. CannotWrite where the
/// disk fails; what was in the journal stays readable.
[[nodiscard]] base::Expected<void> appendPane(const std::filesystem::path& journal, const PaneEntry& entry);

/// The panes of the journal, oldest first; none where there is no journal yet. Lines that are broken are passed over.
[[nodiscard]] base::Expected<std::vector<PaneEntry>> readPanes(const std::filesystem::path& journal);

/// How many panes of an order were good and how many rejected before its pane `pane`: the last entries of this pattern
/// whose numbers go up to the pane without a gap.
struct PaneCounts {
  int good = 0;
  int rejects = 0;
  bool operator==(const PaneCounts&) const = default;
};

[[nodiscard]] PaneCounts countBefore(int pane, const std::string& patternHash, const std::vector<PaneEntry>& journal);

} // namespace arris::files
