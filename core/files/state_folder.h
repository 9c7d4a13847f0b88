#pragma once

#include <filesystem>

namespace arris::files {

/// Where a machine keeps what its runs leave and what the operator has chosen.
struct StateFolder {
  std::filesystem::path root;

  [[nodiscard]] std::filesystem::path records() const {
    return root / "records";
  }

  [[nodiscard]] std::filesystem::path resumePoint() const {
    return root / "resume.json";
  }

  [[nodiscard]] std::filesystem::path alarmLog() const {
    return root / "alarms.jsonl";
  }

  [[nodiscard]] std::filesystem::path settings() const {
    return root / "settings.json";
  }

  [[nodiscard]] std::filesystem::path machine() const {
    return root / "machine.json";
  }

  /// The recipe of last time.
  [[nodiscard]] std::filesystem::path recipe() const {
    return root / "recipe.json";
  }

  /// The recipes that have a name.
  [[nodiscard]] std::filesystem::path recipes() const {
    return root / "recipes";
  }

  /// The patterns that come with the program, to open and to change.
  [[nodiscard]] std::filesystem::path samples() const {
    return root / "samples";
  }

  /// What a restored back-up has replaced.
  [[nodiscard]] std::filesystem::path backUps() const {
    return root / "back-ups";
  }

  [[nodiscard]] std::filesystem::path counters() const {
    return root / "counters.json";
  }

  [[nodiscard]] std::filesystem::path paneJournal() const {
    return root / "panes.jsonl";
  }
};

} // namespace arris::files
