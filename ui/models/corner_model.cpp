#include "ui/models/corner_model.h"

#include "ui/text/job_texts.h"
#include "ui/text/quantities.h"
#include "ui/widgets/signs.h"

namespace arris::ui {
namespace {

bool isTransition(const toolpath::Corner& corner) {
  return corner.treatment == toolpath::Treatment::Transition;
}

} // namespace

void CornerModel::setPlan(PlanPointer plan) {
  beginResetModel();
  m_plan = std::move(plan);
  endResetModel();
}

int CornerModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || !m_plan ? 0 : static_cast<int>(m_plan->job.toolpath.corners.size());
}

int CornerModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant CornerModel::data(const QModelIndex& index, int role) const {
  if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
    return {};
  }
  const toolpath::Corner& corner = m_plan->job.toolpath.corners[static_cast<std::size_t>(index.row())];
  switch (role) {
  case Qt::DisplayRole:
    return text(corner, index.column());
  case Qt::TextAlignmentRole:
    return QVariant(Qt::AlignVCenter | (index.column() == Treatment ? Qt::AlignLeft : Qt::AlignRight));
  case Qt::DecorationRole:
    return index.column() == Relief && isTransition(corner) && !corner.relief
               ? QVariant(signIcon(base::Severity::Warning))
               : QVariant();
  default:
    return {};
  }
}

QString CornerModel::text(const toolpath::Corner& corner, int column) const {
  const QLocale locale;
  const auto ofTransition = [&](double value, int decimals) {
    return isTransition(corner) ? fixedLengthText(value, decimals, locale) : QStringLiteral("–");
  };
  switch (column) {
  case Number:
    return QString::number(corner.id);
  case Angle:
    return angleText(corner.angle, locale);
  case Treatment:
    return treatmentText(corner.treatment);
  case Speed:
    return ofTransition(corner.transitionSpeed, 1);
  case Acceleration:
    return ofTransition(corner.blendAcceleration, 2);
  case Time:
    return isTransition(corner) ? fixedText(corner.blendTime, 2, locale) : QStringLiteral("–");
  case Widest:
    return corner.kind == toolpath::CornerKind::Concave ? QStringLiteral("–")
                                                        : fixedLengthText(corner.widest, 2, locale);
  case Relief:
    return reliefText(corner);
  default:
    return {};
  }
}

QString CornerModel::reliefText(const toolpath::Corner& corner) const {
  if (!isTransition(corner)) {
    return QStringLiteral("–");
  }
  const double margin = corner.widest - m_plan->job.recipe.wheelRadius - corner.tipDepth;
  return (margin < 0 ? QString() : QStringLiteral("+")) + fixedLengthText(margin, 2, QLocale());
}

QVariant CornerModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
  case Number:
    return tr("#");
  case Angle:
    return tr("Angle\nβ");
  case Treatment:
    return tr("Treatment");
  case Speed:
    return inShownUnits(tr("Speed\nmm/s"));
  case Acceleration:
    return inShownUnits(tr("Accel.\nmm/s²"));
  case Time:
    return tr("Time\ns");
  case Widest:
    return inShownUnits(tr("Widest\nmm"));
  case Relief:
    return inShownUnits(tr("Relief\nmm"));
  default:
    return {};
  }
}

} // namespace arris::ui
