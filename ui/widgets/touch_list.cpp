#include "ui/widgets/touch_list.h"

#include "ui/widgets/touch_delegate.h"
#include "ui/widgets/touch_table.h"

namespace arris::ui {
namespace {

constexpr QSize kTouchListSign(24, 24); // px

} // namespace

TouchList::TouchList(QWidget* parent) : QListWidget(parent) {
  setWordWrap(true);
  setTextElideMode(Qt::ElideMiddle);
  setIconSize(kTouchListSign);
  setResizeMode(QListView::Adjust);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setItemDelegate(new TouchDelegate(this));
  makeTouchable(*this);
}

} // namespace arris::ui
