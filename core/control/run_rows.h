#pragma once

#include "core/control/report.h"
#include "core/files/run_row.h"

#include <deque>
#include <functional>
#include <memory>

namespace arris::control {

/// The rows of a run, one a period, from the reports of the controller: with the phases and corners that a plan would
/// tell, and the places that the axes had in that period, which come later. Not for the control loop.
class RunRows {
public:
  /// `sink` hears of each row in order.
  RunRows(std::shared_ptr<const job::Job> job, std::function<void(const files::RunRow&)> sink);

  /// The next report, also those after the run's end, which bring the last places. True where it belongs to the run.
  bool add(const Report& report);

  /// No more is coming: what waits is told as it is.
  void finish();

private:
  struct Row {
    std::int64_t tick = 0;
    files::RunRow row;
    int stopCorner = 0; ///< of its segment
    int segment = -1;   ///< of the program
    bool isMeasured = false;
    bool isAttributed = false;
  };

  Row rowOf(const Report& report);
  void attribute(Row& next);
  void measure(const Report& report);
  void setCorner(files::RunRow& row, int corner) const;
  void tell();
  void tell(const files::RunRow& row);

  std::shared_ptr<const job::Job> m_job;
  std::function<void(const files::RunRow&)> m_sink;
  files::MeasuredVelocities m_velocities;
  std::deque<Row> m_waiting;
  Row m_last;
  bool m_hasLast = false;
  int m_leaving = 0; ///< corner that the present acceleration comes out of
  bool m_finished = false;
};

} // namespace arris::control
