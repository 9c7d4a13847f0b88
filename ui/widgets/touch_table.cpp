#include "ui/widgets/touch_table.h"

#include "ui/widgets/theme.h"

#include <QComboBox>
#include <QHeaderView>
#include <QScroller>
#include <QStyledItemDelegate>
#include <QTableView>

namespace arris::ui {

void makeTouchable(QAbstractScrollArea& area) {
  QScroller::grabGesture(area.viewport(), QScroller::TouchGesture);
}

// The delegate that a box has of its own does not ask the style sheet.
void makeTouchable(QComboBox& box) {
  box.setItemDelegate(new QStyledItemDelegate(&box));
}

void makeTouchTable(QTableView& table) {
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setSelectionMode(QAbstractItemView::SingleSelection);
  table.setTabKeyNavigation(false);
  table.setShowGrid(false);
  table.setAlternatingRowColors(true);
  table.setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  table.verticalHeader()->hide();
  table.verticalHeader()->setDefaultSectionSize(kTouch);
  table.verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table.horizontalHeader()->setSectionsClickable(false);
  table.horizontalHeader()->setHighlightSections(false);
  makeTouchable(table);
}

} // namespace arris::ui
