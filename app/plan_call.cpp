#include "app/command_line.h"
#include "app/interruption.h"
#include "app/job_request.h"
#include "app/summary.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

namespace arris::app {

ExitStatus plan(const Arguments& arguments) {
  CLI::App call("From a pattern to the wheel path, the time it takes, its profile and G-code.", "arris plan");
  JobRequest request;
  addJobOptions(call, request);
  const RecipeOptions recipeOptions(call);
  if (const auto status = read(call, arguments)) {
    return *status;
  }
  if (const ExitStatus status = checkFiles(request); status != ExitStatus::Done) {
    return status;
  }
  const auto settings = loadSettings(request.recipe, request.machine, recipeOptions);
  if (!settings) {
    return settings.error();
  }
  watchForInterruption();
  const auto planned = planJobOf(request.pattern, *settings);
  if (!planned) {
    return planned.error();
  }
  if (const ExitStatus status = writeOutputs(request, *planned); status != ExitStatus::Done) {
    return status;
  }
  if (!planned->job.canBeGround()) {
    return ExitStatus::CannotBeGround;
  }
  fmt::print("{}", summaryOf(planned->job));
  return ExitStatus::Done;
}

} // namespace arris::app
