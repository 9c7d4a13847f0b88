#include "app/command_line.h"
#include "app/figures.h"
#include "app/inputs.h"
#include "app/interruption.h"
#include "app/messages.h"
#include "app/outputs.h"
#include "app/progress.h"
#include "app/summary.h"
#include "core/files/gcode.h"
#include "core/files/profile_csv.h"
#include "core/files/report.h"
#include "core/files/whole_file.h"
#include "ui/figures/preview_figure.h"
#include "ui/figures/profile_figure.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Validators.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <span>

namespace arris::app {
namespace {

namespace fs = std::filesystem;

/// What was asked for.
struct Request {
  fs::path pattern;
  fs::path recipe;
  fs::path machine;
  std::string transitions{files::kTransitionForms.front()};
  Outputs outputs;

  [[nodiscard]] files::TransitionForm transitionForm() const {
    const auto& words = files::kTransitionForms;
    return static_cast<files::TransitionForm>(std::find(words.begin(), words.end(), transitions) - words.begin());
  }
};

/// One file to write.
struct Task {
  fs::path file;
  bool onlyWhenGround; ///< not for a job that cannot be ground
  std::function<base::Expected<void>()> write;
};

void addOptions(CLI::App& call, Request& request) {
  call.add_option("PATTERN", request.pattern, "A drawing (DXF, ASCII or binary)")->required()->type_name("");
  call.add_option("--recipe", request.recipe, "Values of the recipe; options win over it")->type_name("FILE.json");
  call.add_option("--machine", request.machine, "What the machine is and can do")->type_name("FILE.json");
  addReportAndPreview(call, request.outputs);
  addProgramOutputs(call, request.outputs);
  call.add_option("--gcode-transition", request.transitions, "How G-code writes transitions (spline, arcs, lines)")
      ->check(CLI::IsMember(std::vector<std::string>(files::kTransitionForms.begin(), files::kTransitionForms.end())))
      ->type_name("WORD")
      ->group("Outputs");
}

base::Expected<void> writeProfile(const job::Job& job, const fs::path& file, Progress& progress) {
  return files::writeWholeFile(file, [&](files::Output& output) {
    files::writeProfile(job, output, [&](double share) {
      progress.show(fmt::format("Writing {}", file.filename().string()), share);
      if (interrupted()) {
        output.abandon();
      }
    });
  });
}

std::vector<Task> tasks(const Request& request, const pattern::Pattern& pattern, const job::Job& job,
                        Progress& progress) {
  const std::string name = request.pattern.filename().string();
  const QString title = QString::fromStdString(name);
  const Outputs& files = request.outputs;
  return {
      {files.report, false,
       [&, name] { return files::writeWholeFile(files.report, files::report(pattern, job, name)); }},
      {files.preview, false,
       [&, title] {
         return writeFigure(ui::previewFigure(ui::drawingOf(job, pattern), ui::previewTitle(job, title)),
                            files.preview);
       }},
      {files.profile, true, [&] { return writeProfile(job, files.profile, progress); }},
      {files.gcode, true,
       [&, name] { return files::writeWholeFile(files.gcode, files::gcode(job, name, request.transitionForm())); }},
      {files.plot, true, [&, title] { return writeFigure(ui::profileFigure(job, title), files.plot); }},
  };
}

/// Every output that the job allows; a failure of one does not hold up the others.
ExitStatus writeOutputs(const Request& request, const pattern::Pattern& pattern, const job::Job& job) {
  Progress progress;
  std::optional<Offscreen> offscreen;
  if (!request.outputs.preview.empty() || !request.outputs.plot.empty()) {
    offscreen.emplace();
  }
  base::Problems problems;
  for (const Task& task : tasks(request, pattern, job, progress)) {
    if (task.file.empty() || (task.onlyWhenGround && !job.canBeGround())) {
      continue;
    }
    progress.show(fmt::format("Writing {} …", task.file.filename().string()));
    const auto written = task.write();
    if (interrupted()) {
      return ExitStatus::Interrupted;
    }
    if (!written) {
      problems.push_back(written.error());
    }
  }
  progress.show("");
  return tellAndJudge(problems);
}

/// Pattern and job; the work before anything is written.
struct Planned {
  pattern::Pattern pattern;
  job::Job job;
};

OrStatus<Planned> planned(const fs::path& file, const Settings& settings) {
  const Progress progress;
  progress.show(fmt::format("Reading {} …", file.filename().string()));
  auto pattern = loadPattern(file, settings.recipe);
  if (!pattern) {
    return tl::unexpected(pattern.error());
  }
  progress.show("Planning …");
  job::Job job = job::planJob(*pattern, settings.recipe, settings.machine);
  return Planned{*std::move(pattern), std::move(job)};
}

} // namespace

ExitStatus plan(const Arguments& arguments) {
  CLI::App call("From a pattern to the wheel path, the time it takes, its profile and G-code.", "arris plan");
  Request request;
  addOptions(call, request);
  const RecipeOptions recipeOptions(call);
  if (const auto status = read(call, arguments)) {
    return *status;
  }
  if (const ExitStatus status = check(request.outputs.given(), {request.pattern, request.recipe, request.machine});
      status != ExitStatus::Done) {
    return status;
  }
  const auto settings = loadSettings(request.recipe, request.machine, recipeOptions);
  if (!settings) {
    return settings.error();
  }

  watchForInterruption();
  const auto result = planned(request.pattern, *settings);
  if (!result) {
    return result.error();
  }
  if (interrupted()) {
    return ExitStatus::Interrupted;
  }
  // What is wrong with the drawing is mended in the drawing; what is wrong with the job, on the table.
  const std::size_t ofPattern = result->pattern.problems.size();
  tell(result->pattern.problems);
  tell(std::span(result->job.problems).subspan(ofPattern), "on the table");
  if (const ExitStatus status = writeOutputs(request, result->pattern, result->job); status != ExitStatus::Done) {
    return status;
  }
  if (!result->job.canBeGround()) {
    return ExitStatus::CannotBeGround;
  }
  fmt::print("{}", summaryOf(result->job));
  return ExitStatus::Done;
}

} // namespace arris::app
