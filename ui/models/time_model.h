#pragma once

#include "ui/presenters/planner.h"

#include <QAbstractTableModel>

#include <vector>

namespace arris::ui {

/// The time of a plan by phase, and below the phases the grinding and the whole.
class TimeModel : public QAbstractTableModel {
  Q_OBJECT

public:
  enum Column { What, Duration, Share, ColumnCount };

  using QAbstractTableModel::QAbstractTableModel;

  void setPlan(const PlanPointer& plan);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role = Qt::DisplayRole) const override;

private:
  struct Row {
    QString what;
    double seconds = 0;
    bool sum = false;
  };

  std::vector<Row> m_rows;
  double m_duration = 0;
};

} // namespace arris::ui
