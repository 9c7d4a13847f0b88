#include "app/folders.h"

#include <QCoreApplication>
#include <QStandardPaths>

namespace arris::app {

std::filesystem::path defaultStateFolder() {
  QCoreApplication::setApplicationName("arris");
  return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation).toStdString();
}

std::vector<std::filesystem::path> moduleFolders() {
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  return {program, program / "../lib/arris"};
}

} // namespace arris::app
