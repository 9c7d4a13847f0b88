#pragma once

#include "ui/text/quantities.h"

#include <QColor>
#include <QFont>
#include <QLocale>
#include <QPen>

namespace arris::ui {

/// The colours of figures. Those that must be told apart are from the palette of Okabe and Ito, which the colour-blind
/// tell apart too; line patterns differ as well.
struct Palette {
  QColor paper = QColor(0xffffff);
  QColor ink = QColor(0x1f2428);     ///< text, frames
  QColor faint = QColor(0x6b747b);   ///< lesser text, ticks
  QColor grid = QColor(0xe3e6e8);    ///< lines behind everything
  QColor glass = QColor(0xdfe8ec);   ///< area of the pane
  QColor contour = QColor(0x37474f); ///< its edge
  QColor path = QColor(0x1f2428);    ///< wheel path
  QColor transition = QColor(0xd55e00);
  QColor roll = QColor(0x0072b2);
  QColor lead = QColor(0x00795a);
  QColor rapid = QColor(0x7d878e);
  QColor loose = QColor(0x9c4a86);
  QColor error = QColor(0xb3261e);
  QColor warning = QColor(0x9a6700);
  QColor x = QColor(0x0072b2); ///< curves of the X axis
  QColor y = QColor(0xb34f00); ///< curves of the Y axis
  QColor speed = QColor(0x1f2428);
  QColor distance = QColor(0x8a3d74);
  QColor cornerBand = QColor(0xfdeee1);
  QColor phaseBand = QColor(0xeaedef);
  QColor awayBand = QColor(0xd7dcdf); ///< what is not grinding
};

/// The same colours, lighter, on dark paper: text stands out from it by 4.5 : 1 or more, lines by 3 : 1, also where
/// glass or bands lie under them.
[[nodiscard]] Palette darkPalette();

/// What the window looks like: of the whole process, as the default locale is. Pictures in files are always light.
enum class Appearance { Light, Dark };
void showAppearance(Appearance appearance);
[[nodiscard]] Appearance appearance();

/// How large and in whose numbers a figure is drawn. A figure's unit is 0.1 mm on paper; on a screen it is a share of a
/// pixel.
struct FigureStyle {
  Palette palette;
  double unit = 1;                             ///< device units per unit of figures
  QLocale locale = QLocale::c();               ///< of numbers: files have the decimal point, the window the operator's
  LengthUnit lengths = LengthUnit::Millimetre; ///< of numbers: files have mm, the window what it shows

  [[nodiscard]] QFont font(double height, bool bold = false) const {
    QFont result(QStringLiteral("DejaVu Sans"));
    result.setPixelSize(qRound(height * unit));
    result.setBold(bold);
    result.setHintingPreference(QFont::PreferNoHinting);
    return result;
  }

  /// A length (a speed …) given in mm, in the unit of the figure.
  [[nodiscard]] QString lengthText(double millimetres, int decimals) const {
    return ui::lengthText(millimetres, decimals, locale, lengths);
  }

  [[nodiscard]] QPen pen(const QColor& color, double width, Qt::PenStyle pattern = Qt::SolidLine) const {
    return {color, width * unit, pattern, Qt::FlatCap, Qt::RoundJoin};
  }
};

/// On a screen: with the operator's numbers and unit of length, and in the colours of the window.
[[nodiscard]] FigureStyle screenStyle(double unit);

// Sizes, in units of figures.
inline constexpr double kTextHeight = 27;
inline constexpr double kSmallTextHeight = 24;
inline constexpr double kTitleHeight = 40;
inline constexpr double kThinLine = 1.5;
inline constexpr double kLine = 2.5;
inline constexpr double kThickLine = 5;

} // namespace arris::ui
