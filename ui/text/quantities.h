#pragma once

#include <QLocale>
#include <QString>

namespace arris::ui {

// Numbers as the operator reads them: in the locale given, never with group separators.

/// At most `decimals` decimals, zeros at the end left out: "75", "0.13".
[[nodiscard]] QString numberText(double value, int decimals, const QLocale& locale);

/// Exactly `decimals` decimals, so that columns line up.
[[nodiscard]] QString fixedText(double value, int decimals, const QLocale& locale);

/// What lengths are shown in, with speeds and accelerations of the same: "mm/s" becomes "in/s". Of the whole window, as
/// the default locale is; files, and figures in files, have mm.
enum class LengthUnit { Millimetre, Inch };
void showLengthsIn(LengthUnit unit);
[[nodiscard]] LengthUnit lengthUnit();

/// A length in mm (a speed in mm/s …) as the number that is shown, and back.
[[nodiscard]] double shownLength(double millimetres, LengthUnit unit = lengthUnit());
[[nodiscard]] double lengthFromShown(double shown);

/// As `numberText` and `fixedText` for a length in mm (a speed …): in inches with one decimal more.
[[nodiscard]] QString lengthText(double millimetres, int decimals, const QLocale& locale,
                                 LengthUnit unit = lengthUnit());
[[nodiscard]] QString fixedLengthText(double millimetres, int decimals, const QLocale& locale,
                                      LengthUnit unit = lengthUnit());

/// A text that names millimetres, for its units as shown: "%1 mm/s" becomes "%1 in/s".
[[nodiscard]] QString inShownUnits(QString text, LengthUnit unit = lengthUnit());

/// An angle given in rad: "60°", "89.5°".
[[nodiscard]] QString angleText(double radians, const QLocale& locale);

/// "12.3 s", "1 min 15.6 s", "2 h 05 min".
[[nodiscard]] QString durationText(double seconds, const QLocale& locale);

} // namespace arris::ui
