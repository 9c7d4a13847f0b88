#include "ui/text/translators.h"

#include <QCoreApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>

namespace arris::ui {

std::vector<std::unique_ptr<QTranslator>> installTranslators(const QStringList& languages) {
  std::vector<std::unique_ptr<QTranslator>> installed;
  const auto install = [&installed](const QLocale& locale, const QString& name, const QString& folder) {
    auto translator = std::make_unique<QTranslator>();
    const bool known = translator->load(locale, name, QStringLiteral("_"), folder);
    if (known) {
      QCoreApplication::installTranslator(translator.get());
      installed.push_back(std::move(translator));
    }
    return known;
  };
  for (const QString& language : languages) {
    const QLocale locale(language);
    if (locale.language() == QLocale::English) {
      break;
    }
    if (install(locale, QStringLiteral("arris"), QStringLiteral(":/i18n"))) {
      install(locale, QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
      break;
    }
  }
  return installed;
}

QStringList spokenLanguages() {
  QStringList names{QStringLiteral("en")};
  for (const QString& file : QDir(QStringLiteral(":/i18n")).entryList({QStringLiteral("arris_*.qm")})) {
    names.push_back(file.section(QLatin1Char('_'), 1).section(QLatin1Char('.'), 0, 0));
  }
  return names;
}

void speak(const QString& language) {
  static std::vector<std::unique_ptr<QTranslator>> spoken;
  const QLocale system = QLocale::system();
  const bool isSystems = language.isEmpty() || QLocale(language).language() == system.language();
  spoken.clear(); // before the next ones, which may be the same
  spoken = installTranslators(language.isEmpty() ? system.uiLanguages() : QStringList(language));
  QLocale::setDefault(isSystems ? system : QLocale(language));
}

} // namespace arris::ui
