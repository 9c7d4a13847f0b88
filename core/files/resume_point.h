#pragma once

#include "core/files/axes.h"
#include "core/files/recipe_json.h"
#include "core/program/input_point.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace arris::files {

/// Why a pane has not been finished. Running: the file was not written again, so the power failed or the program died.
enum class Ended { Running, Held, Stopped, Fault, EmergencyStop, Interrupted };

/// Where a job was broken off, and all that is needed to plan it again.
struct ResumePoint {
  std::string patternFile; ///< with its path
  std::string patternHash; ///< `fileHash` of its bytes
  recipe::Recipe recipe;
  recipe::Machine machine;
  program::JobPlace place;           ///< of the wheel on the job's way
  Eigen::Vector3d position{0, 0, 0}; ///< where the wheel truly was, table coordinates, mm
  Eigen::Vector3d origin{0, 0, 0};   ///< G54 then: the table's zero in machine coordinates, mm
  int contour = 0;                   ///< from 1; 0 off the contours
  double time = 0;                   ///< `t_s` of the run, s
  int pane = 1;                      ///< pane `pane` of `panes`
  int panes = 1;
  Ended ended = Ended::Running;
  std::optional<Axes> axes; ///< that moved; not known of points of the first version
  bool operator==(const ResumePoint&) const = default;
};

/// As a JSON file, `"arris_resume": 1`. `writeWholeFile` puts it on the disk: the new point or the one before is there,
/// also after a power failure.
[[nodiscard]] std::string writeResumePoint(const ResumePoint& point);

/// From the text of the file; without an origin in it the origin is 0, without axes these are not known. Reports every
/// wrong or absent value by name with its unit and range; an unknown key is a warning, a newer version is refused.
/// `file` names it in the problems.
[[nodiscard]] Read<ResumePoint> readResumePoint(std::string_view text, std::string_view file);

} // namespace arris::files
