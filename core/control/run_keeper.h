#pragma once

#include "core/control/latest_file.h"
#include "core/control/run_rows.h"
#include "core/files/alarm_log.h"
#include "core/files/resume_point.h"
#include "core/files/run_record.h"
#include "core/files/state_folder.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace arris::control {

/// The resume point is written so often, s of the run.
inline constexpr double kResumeEvery = 0.2;

/// The panes that are to be ground: the first of these runs, of so many ordered.
struct PaneOrder {
  int first = 1;
  int ordered = 1;
};

/// Keeps what the runs of one job leave: a record each, the point to resume from, the alarms. Hears of every report and
/// fault on the operator's side.
class RunKeeper {
public:
  /// `wallClock` gives the present time, ISO 8601. Folders that are absent are made; one in which nothing can be
  /// written is a problem from the first.
  RunKeeper(files::StateFolder folder, std::shared_ptr<const job::Job> job, std::string patternFile,
            std::string patternHash, std::function<std::string()> wallClock, files::Axes axes,
            const PaneOrder& panes = {});

  /// Writes what waits; a run that still goes on stays resumable.
  ~RunKeeper();
  RunKeeper(const RunKeeper&) = delete;
  RunKeeper& operator=(const RunKeeper&) = delete;

  void add(const Report& report);

  /// Into the record and the alarm log; gives back what stands in the log.
  files::Alarm add(const FaultReport& fault);

  /// Nothing is left of the pane that was broken off, or it has been given up: there is no more to resume, and the next
  /// run is of the next pane.
  void nothingLeft();

  /// So many panes are to be ground now, rejects counted.
  void setOrdered(int panes) {
    m_panesOrdered = panes;
  }

  /// Of the present or the last run; the one before the first where none has begun.
  [[nodiscard]] int pane() const {
    return m_pane;
  }

  /// Everything of the run that has ended is in its record.
  void finish();

  /// The record of the present or the last run; empty before the first.
  [[nodiscard]] const std::filesystem::path& record() const {
    return m_recordFile;
  }

  /// What could not be written: each failure once.
  [[nodiscard]] base::Problems takeProblems();

private:
  void beginRun();
  void note(const Report& report);
  void event(const Report& report, std::string code, std::vector<base::Value> values = {});
  void keepPlace(const Report& report, files::Ended ended);
  void keep(const base::Expected<void>& result);

  files::StateFolder m_folder;
  std::shared_ptr<const job::Job> m_job;
  std::string m_patternFile;
  std::string m_patternHash;
  std::function<std::string()> m_wallClock;
  files::Axes m_axes;
  LatestFile m_resumePoint;
  std::filesystem::path m_recordFile;
  std::optional<files::RecordWriter> m_record;
  std::optional<RunRows> m_rows;
  Report m_last;
  std::int64_t m_lastKept = 0;   ///< tick of the last resume point
  std::int64_t m_endTick = -1;   ///< of the last row of a run that has ended
  std::int64_t m_jobsBefore = 0; ///< jobs ended when the run began
  int m_pane;                    ///< of the present or the last run
  bool m_isPaneOver = true;      ///< the next run is of the next pane, not of one that was broken off
  int m_panesOrdered;
  base::Problems m_problems;
};

} // namespace arris::control
