#pragma once

#include <QDir>
#include <QLocale>
#include <QStringList>

#include <string>
#include <vector>

namespace arris::test {

inline const QLocale kEnglish(QLocale::English, QLocale::UnitedStates);
inline const QLocale kGerman(QLocale::German, QLocale::Germany);

/// The languages of the window beside English, by what the program carries: "de", "zh_CN".
[[nodiscard]] inline std::vector<std::string> languages() {
  std::vector<std::string> names;
  for (const QString& file : QDir(QStringLiteral(":/i18n")).entryList({QStringLiteral("arris_*.qm")})) {
    names.push_back(file.section('_', 1).section('.', 0, 0).toStdString());
  }
  return names;
}

} // namespace arris::test
