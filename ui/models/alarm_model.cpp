#include "ui/models/alarm_model.h"

#include "ui/text/alarm_texts.h"
#include "ui/widgets/signs.h"

#include <algorithm>
#include <utility>

namespace arris::ui {

void AlarmModel::setAlarms(PastAlarms alarms) {
  if (alarms == m_alarms) {
    return;
  }
  beginResetModel();
  m_alarms = std::move(alarms);
  endResetModel();
}

const PastAlarm& AlarmModel::alarm(int row) const {
  return m_alarms.at(static_cast<std::size_t>(row));
}

int AlarmModel::rowOf(const files::Alarm& alarm) const {
  const auto row = std::find_if(m_alarms.begin(), m_alarms.end(),
                                [&](const PastAlarm& candidate) { return isSame(candidate.alarm, alarm); });
  return row != m_alarms.end() ? static_cast<int>(row - m_alarms.begin()) : -1;
}

int AlarmModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_alarms.size());
}

int AlarmModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant AlarmModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
    return {};
  }
  const PastAlarm& past = m_alarms[static_cast<std::size_t>(index.row())];
  if (role == Qt::DecorationRole && index.column() == State) {
    return past.isActive ? QVariant(signIcon(base::Severity::Error)) : QVariant();
  }
  if (role != Qt::DisplayRole) {
    return {};
  }
  switch (index.column()) {
  case State:
    return alarmStateText(past);
  case Time:
    return alarmTimeText(past.alarm, QLocale());
  case Code:
    return alarmCodeText(past.alarm, QLocale());
  case What:
    return alarmText(past.alarm, QLocale());
  default:
    return {};
  }
}

QVariant AlarmModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
  case State:
    return tr("State");
  case Time:
    return tr("Time");
  case Code:
    return tr("Code, axis, value");
  case What:
    return tr("What happened");
  default:
    return {};
  }
}

} // namespace arris::ui
