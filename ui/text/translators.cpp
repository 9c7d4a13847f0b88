#include "ui/text/translators.h"

#include <QCoreApplication>
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

} // namespace arris::ui
