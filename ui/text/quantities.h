#pragma once

#include <QLocale>
#include <QString>

namespace arris::ui {

// Numbers as the operator reads them: in the locale given, never with group separators.

/// At most `decimals` decimals, zeros at the end left out: "75", "0.13".
[[nodiscard]] QString numberText(double value, int decimals, const QLocale& locale);

/// Exactly `decimals` decimals, so that columns line up.
[[nodiscard]] QString fixedText(double value, int decimals, const QLocale& locale);

/// An angle given in rad: "60°", "89.5°".
[[nodiscard]] QString angleText(double radians, const QLocale& locale);

/// "12.3 s", "1 min 15.6 s", "2 h 05 min".
[[nodiscard]] QString durationText(double seconds, const QLocale& locale);

} // namespace arris::ui
