#pragma once

#include "app/exit_status.h"

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace arris::app {

/// A file to write and the option that asked for it.
struct OutputFile {
  std::string option;
  std::filesystem::path file;
  bool isFigure = false; ///< its ending chooses the format
};

/// The files that a planned job is written to; an empty path is none.
struct Outputs {
  std::filesystem::path report;
  std::filesystem::path profile;
  std::filesystem::path gcode;
  std::filesystem::path preview;
  std::filesystem::path plot;

  [[nodiscard]] std::vector<OutputFile> given() const;
};

// Options of a call for these files. `call` then refers to `outputs`, which must outlive it.
void addReportAndPreview(CLI::App& call, Outputs& outputs);
void addProgramOutputs(CLI::App& call, Outputs& outputs);

/// How an option for a figure names its value.
inline constexpr const char* kFigureFile = "FILE.svg|png|pdf";

/// Says what can be known to be wrong before the work is done: an ending that names no kind of picture, a file that
/// would overwrite one of the call's `inputs` or another output, a folder in its place or none to hold it.
[[nodiscard]] ExitStatus check(const std::vector<OutputFile>& outputs,
                               const std::vector<std::filesystem::path>& inputs);

} // namespace arris::app
