#pragma once

#include "core/control/run_keeper.h"

#include <optional>
#include <string>

namespace arris::control {

/// A job that was broken off, as the state folder keeps it: what command line and window resume.
struct BrokenJob {
  files::ResumePoint point;
  std::string time; ///< when it was broken off, ISO 8601
};

/// What there is to resume; nothing and no problem where no job was broken off. With errors among the problems the file
/// cannot be used.
struct FoundJob {
  std::optional<BrokenJob> job;
  base::Problems problems;
};

[[nodiscard]] FoundJob findBrokenJob(const files::StateFolder& folder);

/// JobOfAnotherPattern where the pattern with this fingerprint is not the one that was being ground.
[[nodiscard]] std::optional<base::Problem> checkPattern(const files::ResumePoint& point,
                                                        const std::string& patternHash);

/// JobOfAnotherMachine for every value by which the job was planned that this machine has otherwise.
[[nodiscard]] base::Problems checkMachine(const files::ResumePoint& point, const recipe::Machine& machine);

/// JobOfAnotherMachine where other axes moved: a pane that was broken off in a simulation does not lie on the machine.
[[nodiscard]] std::optional<base::Problem> checkAxes(const files::ResumePoint& point, files::Axes axes);

/// JobPlaceUnknown where the job, planned again, does not have the place.
[[nodiscard]] std::optional<base::Problem> checkPlace(const files::ResumePoint& point, const job::Job& job);

} // namespace arris::control
