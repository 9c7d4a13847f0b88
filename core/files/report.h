#pragma once

#include "core/job/job.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace arris::files {

/// The JSON report of a planned job, whether it can be ground or not: what was found, how each corner is treated and
/// why, times, and every problem. `file` is the pattern file's name. Keys that do not apply are absent; the same input
/// gives the same bytes.
[[nodiscard]] std::string report(const pattern::Pattern& pattern, const job::Job& job, std::string_view file);

/// The JSON report of what the import found, in the drawing's coordinates.
[[nodiscard]] std::string report(const pattern::Pattern& pattern, std::string_view file);

/// What a plot of a profile takes from the report of its job; absent where the report does not have it.
struct ReportFigures {
  struct Corner {
    int id = 0;
    double angle = 0;                   ///< β, rad
    std::optional<double> reliefRadius; ///< R + d, mm, where there is a transition
  };

  std::optional<double> feed;           ///< mm/s
  std::optional<double> accelX, accelY; ///< mm/s²
  std::optional<double> wheelRadius;    ///< mm
  std::vector<Corner> corners;
};

/// From the text of a report; refuses what is no report or a newer one. `name` names the file in the problem.
[[nodiscard]] base::Expected<ReportFigures> readReport(std::string_view text, std::string_view name);

} // namespace arris::files
