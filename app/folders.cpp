#include "app/folders.h"

#include <QCoreApplication>
#include <QStandardPaths>

namespace arris::app {

std::filesystem::path defaultStateFolder() {
  QCoreApplication::setApplicationName("arris");
  return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation).toStdString();
}

} // namespace arris::app
