#include "tests/ui/support/artefacts.h"

#include <QAbstractButton>
#include <QHeaderView>
#include <QLabel>
#include <QTableView>
#include <QTextDocument>

#include <gtest/gtest.h>

namespace arris::test {
namespace {

void expectRoom(const QWidget& widget, const QString& text, const QSize& needed) {
  EXPECT_GE(widget.width(), needed.width()) << "too narrow for \"" << text.toStdString() << '"';
  EXPECT_GE(widget.height(), needed.height()) << "too low for \"" << text.toStdString() << '"';
}

QSize neededBy(const QLabel& label) {
  if (!label.wordWrap()) {
    return label.minimumSizeHint();
  }
  return {0, label.heightForWidth(label.width())};
}

void expectColumnsShown(const QTableView& table) {
  const QHeaderView* header = table.horizontalHeader();
  EXPECT_LE(header->length(), table.viewport()->width()) << table.objectName().toStdString();
  for (int column = 0; column < header->count(); ++column) {
    EXPECT_GE(header->sectionSize(column), table.sizeHintForIndex(table.model()->index(0, column)).width())
        << table.model()->headerData(column, Qt::Horizontal).toString().toStdString();
    EXPECT_GE(header->sectionSize(column), header->sectionSizeHint(column))
        << table.model()->headerData(column, Qt::Horizontal).toString().toStdString();
  }
}

} // namespace

void expectNothingCutOff(const QWidget& window) {
  for (const QLabel* label : window.findChildren<QLabel*>()) {
    if (label->isVisible() && !label->text().isEmpty()) {
      expectRoom(*label, label->text(), neededBy(*label));
      const QRect place(label->mapTo(&window, QPoint()), label->size());
      EXPECT_GE(place.left(), 0) << label->text().toStdString();
      EXPECT_LE(place.right(), window.width()) << label->text().toStdString();
    }
  }
  for (const QAbstractButton* button : window.findChildren<QAbstractButton*>()) {
    if (button->isVisible() && !button->text().isEmpty()) {
      expectRoom(*button, button->text(), button->minimumSizeHint());
    }
  }
  for (const QTableView* table : window.findChildren<QTableView*>()) {
    if (table->isVisible() && table->model()->rowCount() > 0) {
      expectColumnsShown(*table);
    }
  }
}

} // namespace arris::test
