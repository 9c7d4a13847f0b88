#include "app/command_line.h"
#include "app/figures.h"
#include "app/inputs.h"
#include "app/messages.h"
#include "app/outputs.h"
#include "app/summary.h"
#include "core/files/report.h"
#include "core/files/whole_file.h"
#include "ui/figures/preview_figure.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include <cstdio>

namespace arris::app {
namespace {

namespace fs = std::filesystem;

ExitStatus writeOutputs(const Outputs& outputs, const pattern::Pattern& pattern, const std::string& name) {
  base::Problems problems;
  if (!outputs.report.empty()) {
    if (const auto written = files::writeWholeFile(outputs.report, files::report(pattern, name)); !written) {
      problems.push_back(written.error());
    }
  }
  if (!outputs.preview.empty()) {
    const Offscreen offscreen;
    const ui::PreviewTitle title = ui::previewTitle(pattern, QString::fromStdString(name));
    if (const auto written = writeFigure(ui::previewFigure(ui::drawingOf(pattern), title), outputs.preview); !written) {
      problems.push_back(written.error());
    }
  }
  return tellAndJudge(problems);
}

} // namespace

ExitStatus inspect(const Arguments& arguments) {
  CLI::App call("What is in a pattern: units, contours, repairs, and problems with their places.", "arris inspect");
  fs::path file;
  Outputs outputs;
  call.add_option("PATTERN", file, "A drawing (DXF, ASCII or binary)")->required()->type_name("");
  addReportAndPreview(call, outputs);
  const RecipeOptions recipeOptions(call, {"units", "layer", "gap", "smooth"});
  if (const auto status = read(call, arguments)) {
    return *status;
  }
  if (const ExitStatus status = check(outputs.given(), {file}); status != ExitStatus::Done) {
    return status;
  }
  const auto settings = loadSettings({}, {}, recipeOptions);
  if (!settings) {
    return settings.error();
  }
  const auto pattern = loadPattern(file, settings->recipe);
  if (!pattern) {
    return pattern.error();
  }
  // The problems come last: on a terminal they are what is still to be seen after a long list.
  fmt::print("{}", summaryOf(*pattern));
  std::fflush(stdout);
  tell(pattern->problems);
  if (const ExitStatus status = writeOutputs(outputs, *pattern, file.filename().string()); status != ExitStatus::Done) {
    return status;
  }
  return base::hasErrors(pattern->problems) ? ExitStatus::CannotBeGround : ExitStatus::Done;
}

} // namespace arris::app
