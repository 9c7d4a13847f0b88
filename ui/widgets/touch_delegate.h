#pragma once

#include <QStyledItemDelegate>

namespace arris::ui {

/// Rows of a list that a finger can hit; long texts wrap instead of being cut off.
class TouchDelegate : public QStyledItemDelegate {
  Q_OBJECT

public:
  using QStyledItemDelegate::QStyledItemDelegate;

  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

} // namespace arris::ui
