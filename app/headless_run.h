#pragma once

#include "app/exit_status.h"
#include "core/control/run_keeper.h"
#include "core/control/simulated_axes.h"
#include "core/files/axes.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace arris::app {

/// A fault of the simulated machine at a time of the run, s.
struct Injection {
  control::SimulatedFault fault{};
  double seconds = 0;
};

/// How a job is to be executed without a window.
struct HeadlessRun {
  files::StateFolder folder;
  std::string patternFile;
  std::string patternHash;
  files::Axes axes = files::Axes::Simulated;
  std::vector<std::filesystem::path> moduleFolders; ///< where the module of LinuxCNC's axes may be
  bool isFast = false;
  double overrideFactor = 1;
  std::vector<Injection> injections;
  std::optional<program::JobPlace> from; ///< resumes there
  Eigen::Vector3d origin{0, 0, 0};       ///< G54 of the job that is resumed, mm
  control::PaneOrder panes;              ///< one after the other; on a real machine each next one by cycle start
};

struct Executed {
  ExitStatus status = ExitStatus::Done;
  std::filesystem::path record; ///< empty where the run did not begin
};

/// Switches the machine on, homes it, parks the wheel, runs the job and switches off. Ctrl-C is a controlled stop.
[[nodiscard]] Executed execute(const HeadlessRun& run, const std::shared_ptr<const job::Job>& job);

} // namespace arris::app
