#pragma once

#include "app/inputs.h"
#include "app/outputs.h"
#include "core/files/gcode.h"
#include "core/job/job.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace arris::app {

/// What the calls that plan a job are asked for.
struct JobRequest {
  std::filesystem::path pattern;
  std::filesystem::path recipe;
  std::filesystem::path machine;
  std::string transitions{files::kTransitionForms.front()};
  Outputs outputs;
};

/// Options of a call for it. `call` then refers to `request`, which must outlive it.
void addJobOptions(CLI::App& call, JobRequest& request);

/// Says what can be known to be wrong with the files before the work is done.
[[nodiscard]] ExitStatus checkFiles(const JobRequest& request);

/// Pattern and job; the work before anything is written.
struct PlannedJob {
  pattern::Pattern pattern;
  job::Job job;
};

/// Plans the pattern in the bytes of a file; problems are told.
[[nodiscard]] OrStatus<PlannedJob> planJobIn(std::string_view bytes, const std::filesystem::path& file,
                                             const Settings& settings);

/// Reads the file first.
[[nodiscard]] OrStatus<PlannedJob> planJobOf(const std::filesystem::path& file, const Settings& settings);

/// Every output that the job allows; a failure of one does not hold up the others. Where there is the `record` of a
/// run, profile and plot show what was executed.
[[nodiscard]] ExitStatus writeOutputs(const JobRequest& request, const PlannedJob& planned,
                                      const std::filesystem::path& record = {});

} // namespace arris::app
