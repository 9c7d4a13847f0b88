#include "core/control/run_keeper.h"

#include "core/control/alarms.h"
#include "core/files/record_folder.h"
#include "core/files/whole_file.h"

#include <algorithm>
#include <utility>

namespace arris::control {

namespace {

base::Expected<void> tryToWriteIn(const std::filesystem::path& folder) {
  const std::filesystem::path trial = folder / ".trial";
  base::Expected<void> written = files::writeWholeFile(trial, "");
  std::error_code ignored;
  std::filesystem::remove(trial, ignored);
  return written;
}

} // namespace

RunKeeper::RunKeeper(files::StateFolder folder, std::shared_ptr<const job::Job> job, std::string patternFile,
                     std::string patternHash, std::function<std::string()> wallClock, files::Axes axes,
                     const PaneOrder& panes)
    : m_folder(std::move(folder)), m_job(std::move(job)), m_patternFile(std::move(patternFile)),
      m_patternHash(std::move(patternHash)), m_wallClock(std::move(wallClock)), m_axes(axes),
      m_resumePoint(m_folder.resumePoint()), m_pane(panes.first - 1), m_panesOrdered(panes.ordered) {
  std::error_code failure;
  std::filesystem::create_directories(m_folder.records(), failure);
  if (failure) {
    m_problems.push_back(
        base::Problem(base::Code::CannotWrite, {{"file", m_folder.records().string()}, {"reason", failure.message()}}));
    return;
  }
  keep(tryToWriteIn(m_folder.root));
  keep(tryToWriteIn(m_folder.records()));
}

RunKeeper::~RunKeeper() {
  finish();
}

void RunKeeper::keep(const base::Expected<void>& result) {
  if (!result) {
    m_problems.push_back(result.error());
  }
}

base::Problems RunKeeper::takeProblems() {
  if (const auto failure = m_resumePoint.failure()) {
    m_problems.push_back(*failure);
  }
  return std::exchange(m_problems, {});
}

void RunKeeper::add(const Report& report) {
  if (report.runTick == 0) {
    finish();
    m_jobsBefore = report.jobsEnded;
    beginRun();
  }
  if (m_rows) {
    m_rows->add(report);
    if (report.runTick >= 0) {
      note(report);
    } else if (m_endTick < 0) {
      m_endTick = m_last.tick;
      const bool done = report.jobsEnded > m_jobsBefore;
      if (done) {
        event(m_last, "pane-done", {{"pane", std::int64_t{m_pane}}});
        m_isPaneOver = true;
        m_resumePoint.remove();
      } else {
        keepPlace(m_last, m_last.state == State::EmergencyStop ? files::Ended::EmergencyStop
                          : m_last.faults.any()                ? files::Ended::Fault
                                                               : files::Ended::Stopped);
      }
    }
    if (m_endTick >= 0 && report.measuredTick >= m_endTick) {
      finish();
    }
  }
  m_last = report;
}

files::Alarm RunKeeper::add(const FaultReport& fault) {
  files::Alarm alarm = alarmOf(fault, m_wallClock());
  if (m_record) { // the two seconds around it in the record
    const double time = static_cast<double>(std::max<std::int64_t>(0, m_last.runTick)) * m_job->machine.period;
    alarm.values.push_back({"from_s", std::max(0.0, time - 1)});
    alarm.values.push_back({"to_s", time + 1});
    event(m_last, alarm.code, alarm.values);
    alarm.values.push_back({"record", m_recordFile.filename().string()});
  }
  keep(files::appendAlarm(m_folder.alarmLog(), alarm));
  return alarm;
}

void RunKeeper::nothingLeft() {
  m_pane += m_isPaneOver ? 1 : 0;
  m_isPaneOver = true;
  m_resumePoint.remove();
}

void RunKeeper::beginRun() {
  m_pane += m_isPaneOver ? 1 : 0;
  m_isPaneOver = false;
  m_endTick = -1;
  keep(files::dropOldRecords(m_folder.records()));
  const std::string now = m_wallClock();
  m_recordFile = files::newRecordFile(m_folder.records(), now);
  files::RecordHeader header;
  header.patternFile = std::filesystem::path(m_patternFile).filename().string();
  header.patternHash = m_patternHash;
  header.startTime = now;
  header.pane = m_pane;
  header.recipe = m_job->recipe;
  header.machine = m_job->machine;
  auto record = files::RecordWriter::open(m_recordFile, header);
  if (!record) {
    m_problems.push_back(record.error());
    return;
  }
  m_record.emplace(std::move(*record));
  m_rows.emplace(m_job, [this](const files::RunRow& row) {
    if (m_record) {
      if (const auto added = m_record->add(row); !added) {
        m_problems.push_back(added.error());
        m_record.reset();
      }
    }
  });
}

void RunKeeper::finish() {
  if (m_rows) {
    m_rows->finish();
  }
  m_rows.reset();
  if (m_record) {
    keep(m_record->close());
  }
  m_record.reset();
}

void RunKeeper::event(const Report& report, std::string code, std::vector<base::Value> values) {
  if (m_record) {
    keep(m_record->add(files::RunEvent{static_cast<double>(report.runTick) * m_job->machine.period, std::move(code),
                                       std::move(values)}));
  }
}

// Changes that a person would want to read later.
void RunKeeper::note(const Report& report) {
  if (report.runTick == 0 || report.overrideFactor != m_last.overrideFactor) {
    event(report, "override", {{"percent", 100 * report.overrideFactor}});
  }
  if (report.state != m_last.state && report.runTick > 0) {
    event(report, std::string(name(report.state)));
  }
  const bool isDue = static_cast<double>(report.tick - m_lastKept) * m_job->machine.period >= kResumeEvery;
  if (report.runTick == 0 || isDue || report.state != m_last.state) {
    keepPlace(report, report.state == State::Held ? files::Ended::Held : files::Ended::Running);
  }
}

void RunKeeper::keepPlace(const Report& report, files::Ended ended) {
  m_lastKept = report.tick;
  files::ResumePoint point;
  point.patternFile = m_patternFile;
  point.patternHash = m_patternHash;
  point.recipe = m_job->recipe;
  point.machine = m_job->machine;
  point.place = report.place.segment >= 0 ? report.place : program::JobPlace{0, 0};
  point.position = report.measured;
  point.origin = report.origin;
  point.contour = report.contour;
  point.time = static_cast<double>(std::max<std::int64_t>(0, report.runTick)) * m_job->machine.period;
  point.pane = m_pane;
  point.panes = std::max(m_pane, m_panesOrdered);
  point.ended = ended;
  point.axes = m_axes;
  m_resumePoint.write(files::writeResumePoint(point));
}

} // namespace arris::control
