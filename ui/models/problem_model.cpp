#include "ui/models/problem_model.h"

#include "ui/text/problem_texts.h"
#include "ui/widgets/signs.h"

#include <algorithm>

namespace arris::ui {

void ProblemModel::setPlan(const PlanPointer& plan) {
  beginResetModel();
  m_problems = plan ? plan->drawing.problems : base::Problems();
  std::stable_sort(m_problems.begin(), m_problems.end(), [](const base::Problem& a, const base::Problem& b) {
    return base::severityOf(a) < base::severityOf(b);
  });
  m_firstRepair = static_cast<int>(m_problems.size());
  if (plan) {
    m_problems.insert(m_problems.end(), plan->drawing.repairs.begin(), plan->drawing.repairs.end());
  }
  endResetModel();
}

const base::Problem& ProblemModel::problem(int row) const {
  return m_problems.at(static_cast<std::size_t>(row));
}

int ProblemModel::rowOf(const base::Problem& problem) const {
  const auto row = std::find_if(m_problems.begin(), m_problems.end(), [&](const base::Problem& candidate) {
    return candidate.code == problem.code && candidate.where == problem.where && candidate.line == problem.line &&
           candidate.values == problem.values;
  });
  return row != m_problems.end() ? static_cast<int>(row - m_problems.begin()) : -1;
}

int ProblemModel::count(base::Severity severity) const {
  return static_cast<int>(std::count_if(m_problems.begin(), m_problems.end(), [severity](const base::Problem& problem) {
    return base::severityOf(problem) == severity;
  }));
}

int ProblemModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_problems.size());
}

QVariant ProblemModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
    return {};
  }
  const base::Problem& problem = m_problems[static_cast<std::size_t>(index.row())];
  const base::Severity severity = base::severityOf(problem);
  if (role == Qt::DecorationRole) {
    return signIcon(severity);
  }
  if (role != Qt::DisplayRole) {
    return {};
  }
  const QString kind = index.row() < m_firstRepair ? severityText(severity) : tr("Repaired");
  return tr("%1: %2 %3").arg(kind, problemText(problem, QLocale()), placeText(problem, QLocale())).trimmed();
}

} // namespace arris::ui
