#include "ui/presenters/alarm_history.h"

#include "ui/text/problem_texts.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

namespace arris::ui {

bool isSame(const files::Alarm& one, const files::Alarm& other) {
  return one.time == other.time && one.code == other.code && one.text == other.text;
}

AlarmHistory::AlarmHistory(MachineLink& machine, QObject* parent) : QObject(parent), m_machine(machine) {
  m_pool.setMaxThreadCount(1);
  connect(&machine, &MachineLink::alarmRaised, this, &AlarmHistory::takeLive);
  connect(&machine, &MachineLink::changed, this, &AlarmHistory::takeLive);
  reload();
}

AlarmHistory::~AlarmHistory() {
  m_pool.waitForDone();
}

void AlarmHistory::reload() {
  ++m_tasks;
  m_pool.start([this, file = m_machine.folder().alarmLog()] {
    auto log = files::readAlarmLog(file);
    QMetaObject::invokeMethod(
        this, [this, read = std::move(log)] { take(read); }, Qt::QueuedConnection);
  });
  if (m_tasks == 1) {
    Q_EMIT changed();
  }
}

// Where it cannot be read what was read before stays.
void AlarmHistory::take(const base::Expected<files::AlarmLog>& log) {
  --m_tasks;
  m_problem = log ? std::nullopt : std::optional(log.error());
  if (log) {
    m_log = *log;
  }
  merge();
  Q_EMIT changed();
}

// They only become more, and active ones acknowledged.
void AlarmHistory::takeLive() {
  const auto& live = m_machine.alarms();
  const auto active = std::count_if(live.begin(), live.end(), [](const Alarm& alarm) { return alarm.isActive; });
  const std::pair<std::size_t, std::size_t> now(live.size(), static_cast<std::size_t>(active));
  if (std::exchange(m_live, now) != now) {
    merge();
    Q_EMIT changed();
  }
}

void AlarmHistory::merge() {
  PastAlarms all;
  all.reserve(m_log.alarms.size() + m_machine.alarms().size());
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> places;
  const auto put = [&](const files::Alarm& alarm, bool isActive) {
    const auto [place, isNew] = places.try_emplace({alarm.time, alarm.code, alarm.text}, all.size());
    if (isNew) {
      all.push_back({alarm, isActive});
    } else {
      all[place->second] = {alarm, isActive};
    }
  };
  for (const files::Alarm& alarm : m_log.alarms) {
    put(alarm, false);
  }
  for (const Alarm& alarm : m_machine.alarms()) {
    put(alarm.logged, alarm.isActive);
  }
  std::reverse(all.begin(), all.end());
  m_all = std::move(all);
}

PastAlarms AlarmHistory::shown() const {
  if (!m_activeOnly) {
    return m_all;
  }
  PastAlarms active;
  std::copy_if(m_all.begin(), m_all.end(), std::back_inserter(active),
               [](const PastAlarm& alarm) { return alarm.isActive; });
  return active;
}

void AlarmHistory::showActiveOnly(bool on) {
  if (m_activeOnly != on) {
    m_activeOnly = on;
    Q_EMIT changed();
  }
}

void AlarmHistory::choose(const files::Alarm& alarm) {
  if (!m_chosen || !isSame(*m_chosen, alarm)) {
    m_chosen = alarm;
    Q_EMIT changed();
  }
}

std::optional<PastAlarm> AlarmHistory::chosen() const {
  const auto first = [this](const auto& fits) {
    const auto found = std::find_if(m_all.begin(), m_all.end(), fits);
    return found != m_all.end() ? std::optional(*found) : std::nullopt;
  };
  const auto tapped = m_chosen ? first([this](const PastAlarm& past) {
    return isSame(past.alarm, *m_chosen) && (past.isActive || !m_activeOnly);
  })
                               : std::nullopt;
  const auto cause = std::find_if(m_all.rbegin(), m_all.rend(), [](const PastAlarm& past) { return past.isActive; });
  return tapped ? tapped : cause != m_all.rend() ? std::optional(*cause) : std::nullopt; // as in the banner
}

QString AlarmHistory::summary() const {
  if (m_problem) {
    return problemText(*m_problem, QLocale());
  }
  if (isBusy() && m_all.empty()) {
    return tr("Reading the alarm log…");
  }
  const QString count = tr("Alarms: %1").arg(shown().size());
  return m_log.brokenLines == 0
             ? count
             : count + QStringLiteral(" · ") +
                   tr("Damaged lines of the alarm log, which cannot be read: %1").arg(m_log.brokenLines);
}

} // namespace arris::ui
