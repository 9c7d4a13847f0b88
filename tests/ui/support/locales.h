#pragma once

#include <QLocale>

namespace arris::test {

inline const QLocale kEnglish(QLocale::English, QLocale::UnitedStates);
inline const QLocale kGerman(QLocale::German, QLocale::Germany);

} // namespace arris::test
