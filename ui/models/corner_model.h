#pragma once

#include "ui/presenters/planner.h"

#include <QAbstractTableModel>

namespace arris::ui {

/// The corners of a plan, one a row, in the order of machining; every column's unit stands in its heading.
class CornerModel : public QAbstractTableModel {
  Q_OBJECT

public:
  enum Column { Number, Angle, Treatment, Speed, Acceleration, Time, Widest, Relief, ColumnCount };

  using QAbstractTableModel::QAbstractTableModel;

  void setPlan(PlanPointer plan);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role = Qt::DisplayRole) const override;

private:
  [[nodiscard]] QString text(const toolpath::Corner& corner, int column) const;
  [[nodiscard]] QString reliefText(const toolpath::Corner& corner) const;

  PlanPointer m_plan;
};

} // namespace arris::ui
