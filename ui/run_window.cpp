#include "ui/run_window.h"

#include "ui/main_window.h"
#include "ui/widgets/theme.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QScreen>
#include <QTranslator>

#include <algorithm>

namespace arris::ui {
namespace {

constexpr QSize kComfortable(1280, 860);

void install(QApplication& application, const QString& name, const QString& folder) {
  auto* translator = new QTranslator(&application);
  if (translator->load(QLocale(), name, QStringLiteral("_"), folder)) {
    QApplication::installTranslator(translator);
  } else {
    delete translator;
  }
}

} // namespace

void prepareApplication(QApplication& application) {
  QApplication::setApplicationName(QStringLiteral("Arris"));
  install(application, QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  install(application, QStringLiteral("arris"), QStringLiteral(":/i18n"));
  applyTheme(application);
}

int runWindow(QApplication& application, const std::optional<std::filesystem::path>& pattern,
              const recipe::Machine& machine) {
  prepareApplication(application);
  MainWindow window(machine);
  window.resize(kComfortable.boundedTo(QGuiApplication::primaryScreen()->availableSize()));
  window.show();
  if (pattern) {
    window.openPattern(*pattern);
  }
  return QApplication::exec();
}

} // namespace arris::ui
