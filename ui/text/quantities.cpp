#include "ui/text/quantities.h"

#include "core/base/numbers.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <cmath>

namespace arris::ui {
namespace {

constexpr double kInch = 25.4; // mm

LengthUnit& shownUnit() {
  static LengthUnit unit = LengthUnit::Millimetre;
  return unit;
}

int shownDecimals(int decimals, LengthUnit unit) {
  return unit == LengthUnit::Inch ? decimals + 1 : decimals;
}

QLocale withoutGroups(QLocale locale) {
  locale.setNumberOptions(locale.numberOptions() | QLocale::OmitGroupSeparator);
  return locale;
}

} // namespace

QString fixedText(double value, int decimals, const QLocale& locale) {
  const double unit = std::pow(10, decimals);
  const double rounded = std::round(value * unit) / unit;
  return withoutGroups(locale).toString(rounded == 0 ? 0.0 : rounded, 'f', decimals); // never "-0"
}

QString numberText(double value, int decimals, const QLocale& locale) {
  QString text = fixedText(value, decimals, locale);
  const QString zero = locale.zeroDigit();
  const QString point = locale.decimalPoint();
  if (text.contains(point)) {
    while (text.endsWith(zero)) {
      text.chop(zero.size());
    }
    if (text.endsWith(point)) {
      text.chop(point.size());
    }
  }
  return text;
}

void showLengthsIn(LengthUnit unit) {
  shownUnit() = unit;
}

LengthUnit lengthUnit() {
  return shownUnit();
}

double shownLength(double millimetres, LengthUnit unit) {
  return unit == LengthUnit::Inch ? millimetres / kInch : millimetres;
}

double lengthFromShown(double shown) {
  return lengthUnit() == LengthUnit::Inch ? shown * kInch : shown;
}

QString lengthText(double millimetres, int decimals, const QLocale& locale, LengthUnit unit) {
  return numberText(shownLength(millimetres, unit), shownDecimals(decimals, unit), locale);
}

QString fixedLengthText(double millimetres, int decimals, const QLocale& locale, LengthUnit unit) {
  return fixedText(shownLength(millimetres, unit), shownDecimals(decimals, unit), locale);
}

QString inShownUnits(QString text, LengthUnit unit) {
  static const QRegularExpression kMillimetre(QStringLiteral("\\bmm(?=\\b|²)"));
  return unit == LengthUnit::Inch ? text.replace(kMillimetre, QStringLiteral("in")) : text;
}

QString angleText(double radians, const QLocale& locale) {
  return numberText(base::degrees(radians), 1, locale) + QStringLiteral("°");
}

QString durationText(double seconds, const QLocale& locale) {
  const double tenths = std::round(seconds * 10);
  if (tenths < 600) {
    return QCoreApplication::translate("Quantities", "%1 s").arg(fixedText(tenths / 10, 1, locale));
  }
  if (tenths < 36000) {
    const double minutes = std::floor(tenths / 600);
    return QCoreApplication::translate("Quantities", "%1 min %2 s")
        .arg(fixedText(minutes, 0, locale), fixedText((tenths - 600 * minutes) / 10, 1, locale));
  }
  const int minutes = static_cast<int>(std::round(tenths / 600));
  const int hours = minutes / 60;
  return QCoreApplication::translate("Quantities", "%1 h %2 min")
      .arg(fixedText(hours, 0, locale), QStringLiteral("%1").arg(minutes % 60, 2, 10, QLatin1Char('0')));
}

} // namespace arris::ui
