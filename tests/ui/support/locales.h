#pragma once

#include "ui/text/translators.h"

#include <QDir>
#include <QLocale>
#include <QStringList>
#include <QTranslator>

#include <memory>
#include <string>
#include <vector>

namespace arris::test {

inline const QLocale kEnglish(QLocale::English, QLocale::UnitedStates);
inline const QLocale kGerman(QLocale::German, QLocale::Germany);

/// The languages of the window beside English, by what the program carries: "de", "it", "zh_CN".
[[nodiscard]] inline std::vector<std::string> languages() {
  std::vector<std::string> names;
  for (const QString& file : QDir(QStringLiteral(":/i18n")).entryList({QStringLiteral("arris_*.qm")})) {
    names.push_back(file.section('_', 1).section('.', 0, 0).toStdString());
  }
  return names;
}

/// Speaks a language as long as it lives; stands before the widgets that speak it.
class Language {
public:
  explicit Language(const std::string& name) : m_translators(ui::installTranslators({QString::fromStdString(name)})) {
    QLocale::setDefault(QLocale(QString::fromStdString(name)));
  }

  ~Language() {
    QLocale::setDefault(kEnglish);
  }

  Language(const Language&) = delete;
  Language& operator=(const Language&) = delete;
  Language(Language&&) = delete;
  Language& operator=(Language&&) = delete;

private:
  std::vector<std::unique_ptr<QTranslator>> m_translators;
};

} // namespace arris::test
