#pragma once

#include "ui/presenters/diagnosis.h"

#include <QAbstractTableModel>
#include <QIcon>
#include <QStringList>

#include <array>

namespace arris::ui {

/// Signals or figures that change all the time: a row each, its name first. Only what has changed is told to the view.
class SignalModel : public QAbstractTableModel {
  Q_OBJECT

public:
  /// `headings` of the columns, that of the names first.
  explicit SignalModel(QStringList headings, QObject* parent = nullptr);

  void show(const SignalRows& rows);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role = Qt::DisplayRole) const override;

private:
  QStringList m_headings;
  SignalRows m_rows;
  std::array<QIcon, kSignalSigns> m_icons; ///< by sign
};

} // namespace arris::ui
