#pragma once

#include "ui/presenters/machine_link.h"

#include <QThreadPool>

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace arris::ui {

/// An alarm of the log, or since the program began.
struct PastAlarm {
  files::Alarm alarm;
  bool isActive = false; ///< since the program began, and not acknowledged
  bool operator==(const PastAlarm&) const = default;
};

using PastAlarms = std::vector<PastAlarm>;

/// Whether both are the same alarm, acknowledged or not.
[[nodiscard]] bool isSame(const files::Alarm& one, const files::Alarm& other);

/// Every alarm that the machine's log holds, also of earlier starts, with those since the program began: each once, the
/// latest first. The log is read in the background. It remembers what is chosen and shown while pages come and go.
class AlarmHistory : public QObject {
  Q_OBJECT

public:
  /// Refers to the machine; reads its log.
  explicit AlarmHistory(MachineLink& machine, QObject* parent = nullptr);
  ~AlarmHistory() override; ///< waits for the reading under way
  AlarmHistory(const AlarmHistory&) = delete;
  AlarmHistory& operator=(const AlarmHistory&) = delete;
  AlarmHistory(AlarmHistory&&) = delete;
  AlarmHistory& operator=(AlarmHistory&&) = delete;

  /// Reads the log again.
  void reload();

  [[nodiscard]] bool isBusy() const {
    return m_tasks > 0;
  }

  /// What is to be shown: all, or those that are active.
  [[nodiscard]] PastAlarms shown() const;

  [[nodiscard]] const PastAlarms& all() const {
    return m_all;
  }

  [[nodiscard]] bool showsActiveOnly() const {
    return m_activeOnly;
  }

  void showActiveOnly(bool on);

  /// The one that was tapped, or else the first that is still active, which the banner tells too; none where there is
  /// neither.
  [[nodiscard]] std::optional<PastAlarm> chosen() const;
  void choose(const files::Alarm& alarm);

  /// How many are shown, and what of the log could not be read, in words.
  [[nodiscard]] QString summary() const;

  /// Whether something could not be read.
  [[nodiscard]] bool isIncomplete() const {
    return m_problem.has_value() || m_log.brokenLines > 0;
  }

Q_SIGNALS:
  /// Alarms, or what is shown of them.
  void changed();

private:
  void take(const base::Expected<files::AlarmLog>& log);
  void takeLive();
  void merge();

  MachineLink& m_machine;
  files::AlarmLog m_log;
  std::optional<base::Problem> m_problem;
  PastAlarms m_all;
  std::optional<files::Alarm> m_chosen;
  std::pair<std::size_t, std::size_t> m_live; ///< alarms since the program began, and those of them that are active
  bool m_activeOnly = false;
  int m_tasks = 0;
  QThreadPool m_pool; // one thread; last, so that it ends before what it uses
};

} // namespace arris::ui
