#include "core/files/pane_journal.h"

#include "core/files/json_members.h"
#include "core/files/lines.h"
#include "core/files/run_record.h"
#include "core/files/whole_file.h"

#include <algorithm>
#include <array>
#include <optional>

namespace arris::files {
namespace {

/// In the order of the enumeration.
constexpr std::array<std::string_view, 3> kVerdictWords{"good", "reject", "unjudged"};
constexpr double kLongestPane = 1e9; ///< s

std::optional<PaneEntry> paneFrom(std::string_view line) {
  const auto object = parseJson(line, "");
  if (!object) {
    return std::nullopt;
  }
  base::Problems problems;
  JsonMembers members(*object, problems);
  PaneEntry entry;
  entry.time = members.text("time");
  entry.patternFile = members.text("pattern");
  entry.patternHash = members.hash("hash");
  entry.pane = members.count("pane", 1, kMostPanes);
  const std::string word = members.text("verdict");
  entry.duration = members.number("duration_s", 0, kLongestPane, "s");
  const auto* const verdict = std::find(kVerdictWords.begin(), kVerdictWords.end(), word);
  if (!problems.empty() || verdict == kVerdictWords.end()) {
    return std::nullopt;
  }
  entry.verdict = static_cast<Verdict>(verdict - kVerdictWords.begin());
  return entry;
}

} // namespace

base::Expected<void> appendPane(const std::filesystem::path& journal, const PaneEntry& entry) {
  Json object;
  object["time"] = entry.time;
  object["pattern"] = entry.patternFile;
  object["hash"] = entry.patternHash;
  object["pane"] = entry.pane;
  object["verdict"] = kVerdictWords.at(static_cast<std::size_t>(entry.verdict));
  object["duration_s"] = entry.duration;
  return appendLine(journal, oneLine(object));
}

base::Expected<std::vector<PaneEntry>> readPanes(const std::filesystem::path& journal) {
  std::error_code none;
  if (!std::filesystem::exists(journal, none)) {
    return std::vector<PaneEntry>();
  }
  return readFile(journal).map([](const std::string& text) {
    std::vector<PaneEntry> panes;
    eachLine(text, [&](std::string_view line) {
      if (auto entry = paneFrom(line)) {
        panes.push_back(*std::move(entry));
      }
    });
    return panes;
  });
}

PaneCounts countBefore(int pane, const std::string& patternHash, const std::vector<PaneEntry>& journal) {
  PaneCounts counts;
  int wanted = pane - 1;
  for (auto entry = journal.rbegin(); entry != journal.rend() && wanted > 0; ++entry) {
    if (entry->patternHash != patternHash || entry->pane != wanted) {
      break;
    }
    --wanted;
    counts.good += entry->verdict == Verdict::Reject ? 0 : 1;
    counts.rejects += entry->verdict == Verdict::Reject ? 1 : 0;
  }
  return counts;
}

} // namespace arris::files
