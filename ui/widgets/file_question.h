#pragma once

#include <QString>
#include <QStringList>

#include <filesystem>
#include <functional>

class QWidget;

namespace arris::ui {

/// What a dialog for a file asks.
struct FileQuestion {
  QString title;
  QString start;       ///< folder where it begins, or the file that it suggests
  QStringList filters; ///< "PDF (*.pdf)": the ending of the one that is chosen is added where none was typed
  bool isToSave = false;
};

/// Asks, and calls `take` with the file where one was chosen. The dialog is not modal: FEED HOLD and STOP stay within
/// reach, and the machine in sight. It ends with `asker`, which asks one thing at a time.
void askForFile(QWidget& asker, const FileQuestion& question,
                const std::function<void(const std::filesystem::path&)>& take);

} // namespace arris::ui
