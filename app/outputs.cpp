#include "app/outputs.h"

#include "app/messages.h"
#include "ui/figures/figure.h"

#include <CLI/App.hpp>
#include <fmt/format.h>

#include <optional>
#include <span>

namespace arris::app {
namespace {

namespace fs = std::filesystem;
using base::Code;
using base::Problem;

constexpr const char* kOutputGroup = "Outputs";

void addFile(CLI::App& call, const char* option, fs::path& file, const char* kind, const char* what) {
  call.add_option(option, file, what)->type_name(kind)->group(kOutputGroup);
}

/// Where a file that need not exist is or would be, links to nothing followed.
fs::path target(fs::path file, std::error_code& failure) {
  constexpr int kMostLinks = 40;
  for (int i = 0; i < kMostLinks && fs::is_symlink(fs::symlink_status(file, failure)); ++i) {
    file = file.parent_path() / fs::read_symlink(file, failure);
  }
  return fs::weakly_canonical(fs::absolute(file), failure);
}

/// One file under two names, also through links. What is not a regular file (a pipe, /dev/null) may be named twice.
bool sameFile(const fs::path& a, const fs::path& b) {
  std::error_code none;
  if (fs::exists(a, none) && fs::exists(b, none)) {
    return fs::equivalent(a, b, none) && fs::is_regular_file(a, none);
  }
  std::error_code unknown; // a chain of links without an end
  const fs::path one = target(a, unknown);
  const fs::path other = target(b, unknown);
  return !unknown && one == other;
}

std::optional<Problem> obstacle(const fs::path& file) {
  std::error_code none;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const auto cannotWrite = [&](const char* reason) {
    return Problem(Code::CannotWrite, {{"file", file.string()}, {"reason", std::string(reason)}});
  };
  if (fs::is_directory(file, none) || !file.has_filename()) {
    return cannotWrite("it is a folder");
  }
  if (!fs::is_directory(folder, none)) {
    return cannotWrite("there is no such folder");
  }
  return std::nullopt;
}

std::optional<Problem> unknownFigure(const OutputFile& output) {
  if (!output.isFigure || ui::figureFormat(output.file)) {
    return std::nullopt;
  }
  return Problem(Code::ValueNotAChoice, {{"name", output.option},
                                         {"value", output.file.string()},
                                         {"choices", std::string("FILE.svg, FILE.png, FILE.pdf")}});
}

/// What the output would overwrite: an input, or an output named before it.
std::optional<std::string> overwritten(const OutputFile& output, std::span<const OutputFile> before,
                                       const std::vector<fs::path>& inputs) {
  for (const fs::path& input : inputs) {
    if (!input.empty() && sameFile(input, output.file)) {
      return input.string() + ", which is read";
    }
  }
  for (const OutputFile& other : before) {
    if (sameFile(other.file, output.file)) {
      return "the file of " + other.option;
    }
  }
  return std::nullopt;
}

} // namespace

std::vector<OutputFile> Outputs::given() const {
  std::vector<OutputFile> result{{"--report", report},
                                 {"--profile", profile},
                                 {"--gcode", gcode},
                                 {"--preview", preview, true},
                                 {"--plot", plot, true}};
  std::erase_if(result, [](const OutputFile& output) { return output.file.empty(); });
  return result;
}

void addReportAndPreview(CLI::App& call, Outputs& outputs) {
  addFile(call, "--report", outputs.report, "FILE.json", "Everything that was found and planned");
  addFile(call, "--preview", outputs.preview, kFigureFile, "The drawing: glass, wheel path, corners");
}

void addProgramOutputs(CLI::App& call, Outputs& outputs) {
  addFile(call, "--profile", outputs.profile, "FILE.csv", "The profile, one row per servo period");
  addFile(call, "--gcode", outputs.gcode, "FILE.ngc", "The program as G-code");
  addFile(call, "--plot", outputs.plot, kFigureFile, "Velocities, accelerations and distance to the corners over time");
}

ExitStatus check(const std::vector<OutputFile>& outputs, const std::vector<fs::path>& inputs) {
  base::Problems problems;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const OutputFile& output = outputs[i];
    if (const auto victim = overwritten(output, std::span(outputs).first(i), inputs)) {
      complain(fmt::format("{} would overwrite {}", output.option, *victim));
      return ExitStatus::WrongUsage;
    }
    for (const auto& problem : {unknownFigure(output), obstacle(output.file)}) {
      if (problem) {
        problems.push_back(*problem);
      }
    }
  }
  return tellAndJudge(problems);
}

} // namespace arris::app
