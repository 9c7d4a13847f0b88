#pragma once

#include "core/files/whole_file.h"
#include "core/job/job.h"

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

namespace arris::files {

/// One row of a profile. mm, s.
struct ProfileRow {
  double time = 0;
  Eigen::Vector3d position{0, 0, 0};
  Eigen::Vector3d velocity{0, 0, 0};
  Eigen::Vector3d acceleration{0, 0, 0};
  double speed = 0; ///< actual speed in space
  double path = 0;  ///< true length travelled
  int contour = 0;  ///< from 1, as segment and corner; 0 none
  int segment = 0;
  std::string_view phase; ///< one of the contract's words; lives as long as the program
  int corner = 0;
  double distance = 0; ///< wheel centre to the corner's S; meaningless where corner is 0
};

/// Streams the profile of a planned job as CSV, one row per servo period. `progress`, where given, hears the share that
/// is done now and then. For jobs that can be ground.
void writeProfile(const job::Job& job, Output& output, const std::function<void(double)>& progress = {});

struct RunRow;
class ProfileText;

/// Streams the profile of a run as CSV, row by row: the plan's columns and those that only a run has.
class RunProfileWriter {
public:
  /// Writes the header. `output` must outlive this.
  explicit RunProfileWriter(Output& output);
  RunProfileWriter(RunProfileWriter&&) noexcept;
  RunProfileWriter& operator=(RunProfileWriter&&) noexcept;
  ~RunProfileWriter();

  void add(const RunRow& row);
  /// To be called after the last row: rows reach the output in large pieces.
  void flush();

private:
  std::unique_ptr<ProfileText> m_text;
};

/// The rows of a profile from the text of a CSV file. Columns may stand in any order and others beside them; every
/// value is finite and time increases. CsvMalformed with the line where the text is not such a profile; `file` names
/// it.
[[nodiscard]] base::Expected<std::vector<ProfileRow>> readProfile(std::string_view text, std::string_view file);

} // namespace arris::files
