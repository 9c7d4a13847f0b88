#include "ui/widgets/touch_delegate.h"

#include "ui/widgets/theme.h"

#include <QAbstractItemView>
#include <QFontMetrics>

#include <algorithm>

namespace arris::ui {
namespace {

constexpr int kIconRoom = 44;
constexpr int kPadding = 12;

} // namespace

QSize TouchDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const auto* view = qobject_cast<const QAbstractItemView*>(option.widget);
  const int width = view ? view->viewport()->width() : option.rect.width();
  const QString text = index.data(Qt::DisplayRole).toString();
  const QRect words =
      QFontMetrics(option.font).boundingRect(0, 0, std::max(width - kIconRoom, 50), 10000, Qt::TextWordWrap, text);
  return {width, std::max(kTouch, words.height() + kPadding)};
}

} // namespace arris::ui
