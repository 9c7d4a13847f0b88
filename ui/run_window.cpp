#include "ui/run_window.h"

#include "core/files/settings_json.h"
#include "core/files/whole_file.h"
#include "ui/main_window.h"
#include "ui/text/translators.h"
#include "ui/widgets/theme.h"

#include <QApplication>
#include <QScreen>

namespace arris::ui {
namespace {

constexpr QSize kComfortable(1280, 860);

} // namespace

std::string scaleFactor(const files::StateFolder& folder) {
  const auto text = files::readFile(folder.settings());
  const auto read = text ? files::readSettingsFile(*text, folder.settings().string()) : files::Read<files::Settings>();
  const bool isScaled = !base::hasErrors(read.problems) && read.value.scale != files::kLeastScale;
  return isScaled ? QByteArray::number(read.value.scale / 100.0).toStdString() : std::string();
}

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
