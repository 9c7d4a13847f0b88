#include "app/command_line.h"
#include "app/folders.h"
#include "app/headless_run.h"
#include "app/interruption.h"
#include "app/job_request.h"
#include "app/messages.h"
#include "core/control/broken_job.h"
#include "core/files/file_hash.h"
#include "core/files/run_record.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Validators.hpp>
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

namespace arris::app {
namespace {

namespace fs = std::filesystem;

/// What `arris run` is asked for beside the job.
struct RunRequest {
  std::string axes = "simulated";
  std::string speed = "real";
  double overridePercent = 100;
  std::vector<std::string> injections;
  bool resumes = false;
  int count = 1;
  fs::path stateFolder;
};

void addRunOptions(CLI::App& call, RunRequest& request) {
  const char* const group = "Run";
  call.add_option("--axes", request.axes, "Which axes move (simulated, linuxcnc)")
      ->check(CLI::IsMember({"simulated", "linuxcnc"}))
      ->type_name("WORD")
      ->group(group);
  call.add_option("--speed", request.speed, "Simulated axes: at the clock's pace or as fast as they can (real, fast)")
      ->check(CLI::IsMember({"real", "fast"}))
      ->type_name("WORD")
      ->group(group);
  call.add_option("--override", request.overridePercent, "Feed override, 10 to 150 %")
      ->check(CLI::Range(10.0, 150.0))
      ->type_name("PERCENT")
      ->group(group);
  call.add_option("--inject", request.injections, "A fault of the simulated machine at a time of the run, repeatable")
      ->type_name("FAULT@SECONDS")
      ->group(group);
  CLI::Option* const resume =
      call.add_flag("--resume", request.resumes,
                    "Go on where the last job was broken off, with its recipe, machine and panes")
          ->group(group);
  call.add_option("--count", request.count, "So many panes, one after the other")
      ->check(CLI::Range(1, files::kMostPanes))
      ->type_name("NUMBER")
      ->excludes(resume)
      ->group(group);
  call.add_option("--state-dir", request.stateFolder, "Folder of records, alarms and the resume point")
      ->type_name("DIR")
      ->group(group);
}

OrStatus<std::vector<Injection>> injectionsOf(const std::vector<std::string>& texts) {
  std::vector<Injection> result;
  for (const std::string& text : texts) {
    const std::size_t at = text.rfind('@');
    const auto fault = control::faultNamed(std::string_view(text).substr(0, at));
    double seconds = -1;
    if (at != std::string::npos) {
      const char* const end = text.data() + text.size();
      const auto [last, error] = std::from_chars(text.data() + at + 1, end, seconds);
      seconds = last == end && error == std::errc() && std::isfinite(seconds) ? seconds : -1;
    }
    if (!fault || seconds < 0) {
      std::string names;
      for (const auto& [name, known] : control::kSimulatedFaultNames) {
        names += names.empty() ? "" : ", ";
        names += name;
      }
      complain(fmt::format("--inject: \"{}\" is not FAULT@SECONDS with one of the faults {} (see: arris help run)",
                           text, names));
      return tl::unexpected(ExitStatus::WrongUsage);
    }
    result.push_back({*fault, seconds});
  }
  return result;
}

/// Where the job of the run's pattern was broken off on its axes.
OrStatus<files::ResumePoint> resumePoint(const HeadlessRun& run) {
  control::FoundJob found = control::findBrokenJob(run.folder);
  if (const ExitStatus status = tellAndJudge(found.problems); status != ExitStatus::Done) {
    return tl::unexpected(status);
  }
  if (!found.job) {
    complain("there is no job to resume");
    return tl::unexpected(ExitStatus::SystemFailure);
  }
  for (const auto& problem :
       {control::checkPattern(found.job->point, run.patternHash), control::checkAxes(found.job->point, run.axes)}) {
    if (problem) {
      tell({&*problem, 1});
      return tl::unexpected(ExitStatus::WrongUsage);
    }
  }
  return std::move(found.job->point);
}

} // namespace

ExitStatus runJob(const Arguments& arguments) {
  CLI::App call("Executes a job through the controller, without a window.", "arris run");
  JobRequest request;
  addJobOptions(call, request);
  RunRequest runRequest;
  addRunOptions(call, runRequest);
  const RecipeOptions recipeOptions(call);
  if (const auto status = read(call, arguments)) {
    return *status;
  }
  if (const ExitStatus status = checkFiles(request); status != ExitStatus::Done) {
    return status;
  }
  const auto injections = injectionsOf(runRequest.injections);
  if (!injections) {
    return injections.error();
  }
  auto settings = loadSettings(request.recipe, request.machine, recipeOptions);
  if (!settings) {
    return settings.error();
  }
  const auto bytes = load(request.pattern);
  if (!bytes) {
    return bytes.error();
  }
  if (runRequest.axes == "linuxcnc" && (runRequest.speed == "fast" || !injections->empty())) {
    complain("--speed fast and --inject are for simulated axes (see: arris help run)");
    return ExitStatus::WrongUsage;
  }
  HeadlessRun run;
  run.folder = {runRequest.stateFolder.empty() ? defaultStateFolder() : runRequest.stateFolder};
  run.patternFile = request.pattern.string();
  run.patternHash = files::fileHash(*bytes);
  run.axes = files::axesNamed(runRequest.axes);
  run.moduleFolders = moduleFolders();
  run.isFast = runRequest.speed == "fast";
  run.overrideFactor = runRequest.overridePercent / 100;
  run.injections = *injections;
  run.panes.ordered = runRequest.count;
  std::optional<files::ResumePoint> resumed;
  if (runRequest.resumes) {
    const auto point = resumePoint(run);
    if (!point) {
      return point.error();
    }
    *settings = {point->recipe, point->machine};
    run.from = point->place;
    run.origin = point->origin;
    run.panes = {point->pane, point->panes};
    resumed = *point;
  }
  watchForInterruption();
  auto planned = planJobIn(*bytes, request.pattern, *settings);
  if (!planned) {
    return planned.error();
  }
  if (!planned->job.canBeGround()) {
    const ExitStatus status = writeOutputs(request, *planned);
    return status == ExitStatus::Done ? ExitStatus::CannotBeGround : status;
  }
  if (const auto problem = resumed ? control::checkPlace(*resumed, planned->job) : std::nullopt) {
    tell({&*problem, 1});
    return ExitStatus::WrongUsage;
  }
  const Executed executed = execute(run, std::make_shared<const job::Job>(planned->job));
  if (executed.record.empty()) {
    return executed.status;
  }
  const ExitStatus written = writeOutputs(request, *planned, executed.record);
  return executed.status != ExitStatus::Done ? executed.status : written;
}

} // namespace arris::app
