#include "app/job_request.h"

#include "app/figures.h"
#include "app/interruption.h"
#include "app/messages.h"
#include "app/progress.h"
#include "core/files/profile_csv.h"
#include "core/files/report.h"
#include "core/files/run_record.h"
#include "core/files/whole_file.h"
#include "ui/figures/preview_figure.h"
#include "ui/figures/profile_figure.h"

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <span>

namespace arris::app {
namespace {

namespace fs = std::filesystem;

/// One file to write.
struct Task {
  fs::path file;
  bool onlyWhenGround; ///< not for a job that cannot be ground
  std::function<base::Expected<void>()> write;
};

files::TransitionForm transitionForm(const JobRequest& request) {
  const auto& words = files::kTransitionForms;
  return static_cast<files::TransitionForm>(std::find(words.begin(), words.end(), request.transitions) - words.begin());
}

base::Expected<void> writePlannedProfile(const job::Job& job, const fs::path& file, Progress& progress) {
  return files::writeWholeFile(file, [&](files::Output& output) {
    files::writeProfile(job, output, [&](double share) {
      progress.show(fmt::format("Writing {}", file.filename().string()), share);
      if (interrupted()) {
        output.abandon();
      }
    });
  });
}

base::Expected<ui::Figure> executedFigure(const job::Job& job, const fs::path& record, const QString& title) {
  ui::ProfileColumns executed;
  const auto read = files::readRecord(record, {[&](const files::RunRow& row) { ui::append(executed, row.row); }, {}});
  if (!read) {
    return tl::unexpected(read.error());
  }
  return ui::profileFigure({ui::curvesOf(ui::columnsOf(job), "planned"), ui::curvesOf(executed, "executed")},
                           ui::limitsOf(job), title, {});
}

std::vector<Task> tasks(const JobRequest& request, const PlannedJob& planned, const fs::path& record,
                        Progress& progress) {
  const std::string name = request.pattern.filename().string();
  const QString title = QString::fromStdString(name);
  const Outputs& files = request.outputs;
  const job::Job& job = planned.job;
  return {
      {files.report, false,
       [&, name] { return files::writeWholeFile(files.report, files::report(planned.pattern, job, name)); }},
      {files.preview, false,
       [&, title] {
         return writeFigure(ui::previewFigure(ui::drawingOf(job, planned.pattern), ui::previewTitle(job, title)),
                            files.preview);
       }},
      {files.profile, true,
       [&] {
         return record.empty() ? writePlannedProfile(job, files.profile, progress)
                               : files::writeProfileFile(record, files.profile);
       }},
      {files.gcode, true,
       [&, name] { return files::writeWholeFile(files.gcode, files::gcode(job, name, transitionForm(request))); }},
      {files.plot, true,
       [&, title]() -> base::Expected<void> {
         if (record.empty()) {
           return writeFigure(ui::profileFigure(job, title), files.plot);
         }
         const auto figure = executedFigure(job, record, title);
         return figure ? writeFigure(*figure, files.plot) : tl::unexpected(figure.error());
       }},
  };
}

} // namespace

void addJobOptions(CLI::App& call, JobRequest& request) {
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

ExitStatus checkFiles(const JobRequest& request) {
  return check(request.outputs.given(), {request.pattern, request.recipe, request.machine});
}

OrStatus<PlannedJob> planJobOf(const fs::path& file, const Settings& settings) {
  return load(file).and_then([&](const std::string& bytes) { return planJobIn(bytes, file, settings); });
}

OrStatus<PlannedJob> planJobIn(std::string_view bytes, const fs::path& file, const Settings& settings) {
  std::optional<PlannedJob> result;
  {
    const Progress progress;
    progress.show(fmt::format("Reading {} …", file.filename().string()));
    pattern::Pattern pattern = patternIn(bytes, settings.recipe);
    progress.show("Planning …");
    job::Job job = job::planJob(pattern, settings.recipe, settings.machine);
    result.emplace(PlannedJob{std::move(pattern), std::move(job)});
  }
  if (interrupted()) {
    return tl::unexpected(ExitStatus::Interrupted);
  }
  // What is wrong with the drawing is mended in the drawing; what is wrong with the job, on the table.
  const std::size_t ofPattern = result->pattern.problems.size();
  tell(result->pattern.problems);
  tell(std::span(result->job.problems).subspan(ofPattern), "on the table");
  return *std::move(result);
}

ExitStatus writeOutputs(const JobRequest& request, const PlannedJob& planned, const fs::path& record) {
  Progress progress;
  std::optional<Offscreen> offscreen;
  if (!request.outputs.preview.empty() || !request.outputs.plot.empty()) {
    offscreen.emplace();
  }
  base::Problems problems;
  for (const Task& task : tasks(request, planned, record, progress)) {
    if (task.file.empty() || (task.onlyWhenGround && !planned.job.canBeGround())) {
      continue;
    }
    progress.show(fmt::format("Writing {} …", task.file.filename().string()));
    const auto written = task.write();
    if (interrupted() && record.empty()) {
      return ExitStatus::Interrupted;
    }
    if (!written) {
      problems.push_back(written.error());
    }
  }
  progress.show("");
  return tellAndJudge(problems);
}

} // namespace arris::app
