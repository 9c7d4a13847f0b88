#pragma once

#include "ui/presenters/planner.h"

#include <QAbstractListModel>

namespace arris::ui {

/// The problems of a plan in words, the worst first; repairs of the drawing come last.
class ProblemModel : public QAbstractListModel {
  Q_OBJECT

public:
  using QAbstractListModel::QAbstractListModel;

  void setPlan(const PlanPointer& plan);

  /// The problem of a row.
  [[nodiscard]] const base::Problem& problem(int row) const;

  /// The row of a problem of the plan; −1 for any other.
  [[nodiscard]] int rowOf(const base::Problem& problem) const;

  [[nodiscard]] int count(base::Severity severity) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

private:
  base::Problems m_problems;
  int m_firstRepair = 0; // row
};

} // namespace arris::ui
