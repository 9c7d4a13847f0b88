#include "ui/run_window.h"

#include "ui/main_window.h"
#include "ui/text/translators.h"
#include "ui/widgets/theme.h"

#include <QApplication>
#include <QScreen>

namespace arris::ui {
namespace {

constexpr QSize kComfortable(1280, 860);

} // namespace

void prepareApplication(QApplication& application) {
  QApplication::setApplicationName(QStringLiteral("Arris"));
  applyTheme(application);
}

int runWindow(QApplication& application, const MachineSetup& setup,
              const std::optional<std::filesystem::path>& pattern) {
  prepareApplication(application);
  speak({});
  MainWindow window(setup);
  window.resize(kComfortable.boundedTo(QGuiApplication::primaryScreen()->availableSize()));
  window.show();
  if (pattern) {
    window.openPattern(*pattern);
  } else {
    window.openLast();
  }
  return QApplication::exec();
}

} // namespace arris::ui
