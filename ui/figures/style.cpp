#include "ui/figures/style.h"

namespace arris::ui {
namespace {

Appearance& shownAppearance() {
  static Appearance appearance = Appearance::Light;
  return appearance;
}

} // namespace

Palette darkPalette() {
  Palette palette;
  palette.paper = QColor(0x1b2024);
  palette.ink = QColor(0xe6e9eb);
  palette.faint = QColor(0xa3adb3);
  palette.grid = QColor(0x343b40);
  palette.glass = QColor(0x2b3940);
  palette.contour = QColor(0xb8c7cf);
  palette.path = QColor(0xe6e9eb);
  palette.transition = QColor(0xff8a3d);
  palette.roll = QColor(0x56b4e9);
  palette.lead = QColor(0x2fbf94);
  palette.rapid = QColor(0x939da4);
  palette.loose = QColor(0xd58abf);
  palette.error = QColor(0xff8078);
  palette.warning = QColor(0xe6a93a);
  palette.x = QColor(0x56b4e9);
  palette.y = QColor(0xf09a4a);
  palette.speed = QColor(0xe6e9eb);
  palette.distance = QColor(0xd98fc4);
  palette.cornerBand = QColor(0x433120);
  palette.phaseBand = QColor(0x2b3237);
  palette.awayBand = QColor(0x3a4248);
  return palette;
}

void showAppearance(Appearance appearance) {
  shownAppearance() = appearance;
}

Appearance appearance() {
  return shownAppearance();
}

FigureStyle screenStyle(double unit) {
  FigureStyle style;
  style.unit = unit;
  style.locale = QLocale();
  style.lengths = lengthUnit();
  if (appearance() == Appearance::Dark) {
    style.palette = darkPalette();
  }
  return style;
}

} // namespace arris::ui
