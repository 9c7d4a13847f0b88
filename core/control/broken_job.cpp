#include "core/control/broken_job.h"

#include "core/files/wall_clock.h"
#include "core/files/whole_file.h"
#include "core/recipe/fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace arris::control {
namespace {

using base::Code;
using base::Problem;
using recipe::Machine;

/// By which a job is planned; the others say how the machine is moved by hand and watched.
constexpr std::array kPlannedBy{&Machine::plungeFeed, &Machine::period};
constexpr std::array kPlannedByAxes{&Machine::travel, &Machine::maxSpeed, &Machine::maxAccel, &Machine::park};

Problem ofAnotherMachine(std::string_view key, std::string was, std::string is) {
  return Problem(Code::JobOfAnotherMachine,
                 {{"key", std::string(key)}, {"was", std::move(was)}, {"is", std::move(is)}});
}

std::string axesText(const Eigen::Vector3d& values) {
  return fmt::format("{}, {}, {}", values.x(), values.y(), values.z());
}

} // namespace

FoundJob findBrokenJob(const files::StateFolder& folder) {
  FoundJob found;
  const std::filesystem::path file = folder.resumePoint();
  std::error_code none;
  if (!std::filesystem::exists(file, none)) {
    return found;
  }
  const auto text = files::readFile(file);
  if (!text) {
    found.problems.push_back(text.error());
    return found;
  }
  auto read = files::readResumePoint(*text, file.string());
  found.problems = std::move(read.problems);
  if (!base::hasErrors(found.problems)) {
    found.job = BrokenJob{std::move(read.value), files::writtenAt(file)};
  }
  return found;
}

std::optional<Problem> checkPattern(const files::ResumePoint& point, const std::string& patternHash) {
  if (point.patternHash == patternHash) {
    return std::nullopt;
  }
  return Problem(Code::JobOfAnotherPattern,
                 {{"file", point.patternFile}, {"was", point.patternHash}, {"is", patternHash}});
}

base::Problems checkMachine(const files::ResumePoint& point, const Machine& machine) {
  base::Problems problems;
  for (const recipe::MachineAxesField& field : recipe::machineAxesFields()) {
    const bool matters = std::find(kPlannedByAxes.begin(), kPlannedByAxes.end(), field.member) != kPlannedByAxes.end();
    if (matters && point.machine.*field.member != machine.*field.member) {
      problems.push_back(
          ofAnotherMachine(field.key, axesText(point.machine.*field.member), axesText(machine.*field.member)));
    }
  }
  for (const recipe::MachineNumberField& field : recipe::machineNumberFields()) {
    const bool matters = std::find(kPlannedBy.begin(), kPlannedBy.end(), field.member) != kPlannedBy.end();
    if (matters && point.machine.*field.member != machine.*field.member) {
      problems.push_back(ofAnotherMachine(field.key, fmt::format("{}", point.machine.*field.member),
                                          fmt::format("{}", machine.*field.member)));
    }
  }
  return problems;
}

std::optional<Problem> checkAxes(const files::ResumePoint& point, files::Axes axes) {
  if (point.axes.value_or(axes) == axes) {
    return std::nullopt;
  }
  return ofAnotherMachine("axes", std::string(wordOf(*point.axes)), std::string(wordOf(axes)));
}

std::optional<Problem> checkPlace(const files::ResumePoint& point, const job::Job& job) {
  const auto segment = static_cast<std::size_t>(std::max(point.place.segment, 0));
  constexpr double kRoundedInTheFile = 1e-6; // mm
  if (segment < job.track.size() &&
      point.place.lambda <= motion::parameterLength(job.track[segment]) + kRoundedInTheFile) {
    return std::nullopt;
  }
  return Problem(Code::JobPlaceUnknown,
                 {{"segment", std::int64_t{point.place.segment}}, {"lambda_mm", point.place.lambda}});
}

} // namespace arris::control
