#include "ui/models/signal_model.h"

#include "ui/widgets/signal_icon.h"

#include <utility>

namespace arris::ui {

SignalModel::SignalModel(QStringList headings, QObject* parent)
    : QAbstractTableModel(parent), m_headings(std::move(headings)) {
  for (int sign = 0; sign < kSignalSigns; ++sign) {
    m_icons.at(static_cast<std::size_t>(sign)) = signalIcon(static_cast<SignalSign>(sign));
  }
}

void SignalModel::show(const SignalRows& rows) {
  if (rows.size() != m_rows.size()) {
    beginResetModel();
    m_rows = rows;
    endResetModel();
    return;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i] != m_rows[i]) {
      m_rows[i] = rows[i];
      const int row = static_cast<int>(i);
      Q_EMIT dataChanged(index(row, 0), index(row, columnCount() - 1));
    }
  }
}

int SignalModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int SignalModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_headings.size());
}

QVariant SignalModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
    return {};
  }
  const SignalRow& row = m_rows[static_cast<std::size_t>(index.row())];
  if (index.column() == 0) {
    return role == Qt::DisplayRole ? QVariant(row.name) : QVariant();
  }
  const auto place = static_cast<std::size_t>(index.column()) - 1;
  if (place >= row.cells.size()) {
    return {};
  }
  const SignalCell& cell = row.cells[place];
  switch (role) {
  case Qt::DisplayRole:
    return cell.text;
  case Qt::DecorationRole:
    return cell.sign != SignalSign::None ? QVariant(m_icons.at(static_cast<std::size_t>(cell.sign))) : QVariant();
  case Qt::TextAlignmentRole:
    return QVariant(Qt::AlignVCenter | (cell.sign == SignalSign::None ? Qt::AlignRight : Qt::AlignLeft));
  default:
    return {};
  }
}

QVariant SignalModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || section < 0 || section >= m_headings.size()) {
    return {};
  }
  if (role == Qt::TextAlignmentRole) {
    return QVariant(Qt::AlignVCenter | Qt::AlignLeft);
  }
  return role == Qt::DisplayRole ? QVariant(m_headings[section]) : QVariant();
}

} // namespace arris::ui
