#pragma once

#include "ui/presenters/alarm_history.h"

#include <QAbstractTableModel>

namespace arris::ui {

/// Alarms, one a row, in the order given.
class AlarmModel : public QAbstractTableModel {
  Q_OBJECT

public:
  enum Column { State, Time, Code, What, ColumnCount };

  using QAbstractTableModel::QAbstractTableModel;

  void setAlarms(PastAlarms alarms);

  /// The alarm of a row.
  [[nodiscard]] const PastAlarm& alarm(int row) const;

  /// The row of an alarm, as it stands or with another state; −1 for any other.
  [[nodiscard]] int rowOf(const files::Alarm& alarm) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role = Qt::DisplayRole) const override;

private:
  PastAlarms m_alarms;
};

} // namespace arris::ui
