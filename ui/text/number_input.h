#pragma once

#include <QLocale>
#include <QString>

namespace arris::ui {

/// What somebody typed into a field for a number.
struct NumberInput {
  enum class Kind {
    Number,
    Empty,
    NotANumber,
    Ambiguous, ///< "3.600" where the point separates groups: 3.6 or 3600?
  };
  Kind kind = Kind::Empty;
  double value = 0;   ///< of a number; the lesser reading where ambiguous
  double grouped = 0; ///< the greater reading where ambiguous
};

/// Decimal comma and decimal point are both taken, in every locale; group separators are not. Digits only: no
/// exponents, "nan" or "inf".
[[nodiscard]] NumberInput readNumber(const QString& text, const QLocale& locale);

} // namespace arris::ui
