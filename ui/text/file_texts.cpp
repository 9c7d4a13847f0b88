#include "ui/text/file_texts.h"

#include <QFileInfo>

namespace arris::ui {

QString nameOfFile(const std::filesystem::path& file) {
  return QString::fromStdString(file.filename().string());
}

QString folderOfFile(const std::filesystem::path& file) {
  return QFileInfo(QString::fromStdString(file.string())).absolutePath();
}

QString breakableAtFolders(QString text) {
  return text.replace(QLatin1Char('/'), QStringLiteral("/\u200b"));
}

} // namespace arris::ui
