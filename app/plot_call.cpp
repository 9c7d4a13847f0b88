#include "app/command_line.h"
#include "app/figures.h"
#include "app/inputs.h"
#include "app/messages.h"
#include "app/outputs.h"
#include "core/files/report.h"
#include "ui/figures/profile_figure.h"
#include "ui/figures/profile_file.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace arris::app {
namespace {

namespace fs = std::filesystem;

QString nameOf(const fs::path& file) {
  return QString::fromStdString(file.filename().string());
}

OrStatus<ui::ProfileCurves> loadCurves(const fs::path& file) {
  ui::ProfileReading reading = ui::readProfileFile(file);
  tell(reading.damage);
  if (!reading.curves) {
    return tl::unexpected(tellAndJudge({reading.curves.error()}));
  }
  return *std::move(reading.curves);
}

OrStatus<ui::ProfileLimits> loadLimits(const fs::path& report) {
  if (report.empty()) {
    return ui::ProfileLimits{};
  }
  return load(report).and_then([&](const std::string& text) -> OrStatus<ui::ProfileLimits> {
    const auto figures = files::readReport(text, report.string());
    if (!figures) {
      return tl::unexpected(tellAndJudge({figures.error()}));
    }
    ui::ProfileLimits limits{figures->feed, figures->accelX, figures->accelY, figures->wheelRadius, {}};
    for (const auto& corner : figures->corners) {
      limits.corners.push_back({corner.id, corner.angle, corner.reliefRadius});
    }
    return limits;
  });
}

} // namespace

ExitStatus plot(const Arguments& arguments) {
  CLI::App call(
      "A picture of profiles and records of runs; the second one (the actual) is laid over the first (the planned).",
      "arris plot");
  std::vector<fs::path> profiles;
  fs::path report;
  fs::path picture;
  constexpr int kMostProfiles = 2;
  call.add_option("PROFILE", profiles, "Profiles (CSV) or records of runs")
      ->required()
      ->expected(1, kMostProfiles)
      ->type_name("");
  call.add_option("-o,--output", picture, "The picture")->required()->type_name(kFigureFile);
  call.add_option("--report", report, "Report of the job: limits and angles of the corners")->type_name("FILE.json");
  if (const auto status = read(call, arguments)) {
    return *status;
  }
  std::vector<fs::path> inputs = profiles;
  inputs.push_back(report);
  if (const ExitStatus status = check({{"-o", picture, true}}, inputs); status != ExitStatus::Done) {
    return status;
  }
  const auto limits = loadLimits(report);
  if (!limits) {
    return limits.error();
  }
  std::vector<ui::ProfileCurves> curves;
  for (const fs::path& profile : profiles) {
    auto loaded = loadCurves(profile);
    if (!loaded) {
      return loaded.error();
    }
    curves.push_back(*std::move(loaded));
  }
  const Offscreen offscreen;
  const ui::Figure figure = ui::profileFigure(curves, *limits, nameOf(profiles.front()), {});
  const auto written = writeFigure(figure, picture);
  return written ? ExitStatus::Done : tellAndJudge({written.error()});
}

} // namespace arris::app
