#include "ui/widgets/busy_bar.h"

namespace arris::ui {
namespace {

constexpr int kBusyHeight = 8; // px

} // namespace

BusyBar::BusyBar(const QString& what, QWidget* parent) : QProgressBar(parent) {
  setRange(0, 0);
  setTextVisible(false);
  setFixedHeight(kBusyHeight);
  setAccessibleName(what);
  QSizePolicy keepsPlace = sizePolicy();
  keepsPlace.setRetainSizeWhenHidden(true);
  setSizePolicy(keepsPlace);
}

} // namespace arris::ui
