#include "ui/models/time_model.h"

#include "ui/text/job_texts.h"
#include "ui/text/quantities.h"

#include <QFont>

namespace arris::ui {

void TimeModel::setPlan(const PlanPointer& plan) {
  beginResetModel();
  m_rows.clear();
  m_duration = 0;
  if (plan && !plan->job.pieces.empty()) {
    const job::Job& job = plan->job;
    for (int i = 0; i < job::kPhaseCount; ++i) {
      const double seconds = job.byPhase.at(static_cast<std::size_t>(i));
      if (seconds > 0) {
        m_rows.push_back({phaseText(static_cast<job::Phase>(i)), seconds});
      }
    }
    m_rows.push_back({tr("Grinding, lead-in to lead-out"), job.working, true});
    m_rows.push_back({tr("Whole program"), job.duration, true});
    m_duration = job.duration;
  }
  endResetModel();
}

int TimeModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int TimeModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant TimeModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
    return {};
  }
  const Row& row = m_rows[static_cast<std::size_t>(index.row())];
  if (role == Qt::TextAlignmentRole) {
    return QVariant(Qt::AlignVCenter | (index.column() == What ? Qt::AlignLeft : Qt::AlignRight));
  }
  if (role == Qt::FontRole && row.sum) {
    QFont bold;
    bold.setBold(true);
    return bold;
  }
  if (role != Qt::DisplayRole) {
    return {};
  }
  switch (index.column()) {
  case What:
    return row.what;
  case Duration:
    return durationText(row.seconds, QLocale());
  default:
    return fixedText(100 * row.seconds / m_duration, 0, QLocale()) + QChar::Nbsp + QLatin1Char('%');
  }
}

QVariant TimeModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
  case What:
    return tr("Phase");
  case Duration:
    return tr("Time");
  default:
    return tr("Share");
  }
}

} // namespace arris::ui
