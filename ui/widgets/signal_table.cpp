#include "ui/widgets/signal_table.h"

#include "ui/models/signal_model.h"

#include <QHeaderView>

namespace arris::ui {
namespace {

constexpr int kSignalRowHeight = 28; // px: nothing to tap here
constexpr int kSignalIconSize = 20;  // px
constexpr int kNarrowSignalTable = 200;

} // namespace

SignalTable::SignalTable(SignalModel& model, const QString& name, QWidget* parent) : QTableView(parent) {
  setObjectName(name);
  setModel(&model);
  setSelectionMode(QAbstractItemView::NoSelection);
  setFocusPolicy(Qt::NoFocus);
  setShowGrid(false);
  setAlternatingRowColors(true);
  setIconSize(QSize(kSignalIconSize, kSignalIconSize));
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(kSignalRowHeight);
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  horizontalHeader()->setSectionsClickable(false);
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch); // a share each, so that nothing jumps
  horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  connect(&model, &QAbstractItemModel::modelReset, this, &QWidget::updateGeometry);
}

QSize SignalTable::sizeHint() const {
  return minimumSizeHint();
}

QSize SignalTable::minimumSizeHint() const {
  const int rows = model()->rowCount() * kSignalRowHeight;
  return {kNarrowSignalTable, rows + horizontalHeader()->sizeHint().height() + 2 * frameWidth() + 2};
}

} // namespace arris::ui
