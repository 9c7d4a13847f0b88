#include "ui/text/number_input.h"

#include "core/base/numbers.h"

#include <string>

namespace arris::ui {
namespace {

constexpr qsizetype kGroupDigits = 3;

bool isSeparator(QChar c) {
  return c == QLatin1Char('.') || c == QLatin1Char(',');
}

// "3.600" with the separator that groups thousands in this locale; not "0.600", which nobody groups.
bool couldBeGrouped(const QString& digits, qsizetype separator, const QLocale& locale) {
  return QString(digits[separator]) == locale.groupSeparator() && separator >= 1 && separator <= kGroupDigits &&
         digits[0] != QLatin1Char('0') && digits.size() - separator - 1 == kGroupDigits;
}

} // namespace

NumberInput readNumber(const QString& text, const QLocale& locale) {
  QString digits = text.trimmed();
  if (digits.isEmpty()) {
    return {NumberInput::Kind::Empty};
  }
  const bool negative = digits.startsWith(QLatin1Char('-')) || digits.startsWith(QChar(0x2212));
  if (negative || digits.startsWith(QLatin1Char('+'))) {
    digits.remove(0, 1);
  }
  qsizetype separator = -1;
  std::string plain = negative ? "-" : "";
  bool anyDigit = false;
  for (qsizetype i = 0; i < digits.size(); ++i) {
    if (isSeparator(digits[i]) && separator < 0) {
      separator = i;
      plain += '.';
    } else if (digits[i].digitValue() >= 0) {
      plain += static_cast<char>('0' + digits[i].digitValue());
      anyDigit = true;
    } else {
      return {NumberInput::Kind::NotANumber};
    }
  }
  const std::optional<double> value = base::parseNumber<double>(plain);
  if (!value || !anyDigit) {
    return {NumberInput::Kind::NotANumber};
  }
  if (separator >= 0 && couldBeGrouped(digits, separator, locale)) {
    return {NumberInput::Kind::Ambiguous, *value, *value * 1000};
  }
  return {NumberInput::Kind::Number, *value};
}

} // namespace arris::ui
