#include "ui/widgets/file_question.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QRegularExpression>

namespace arris::ui {
namespace {

// "tar.gz" of "Archives (*.tar.gz)"; none of "All files (*)".
QString endingOf(const QString& filter) {
  static const QRegularExpression kEnding(QStringLiteral(R"(\*\.([\w.]+))"));
  return kEnding.match(filter).captured(1);
}

} // namespace

void askForFile(QWidget& asker, const FileQuestion& question,
                const std::function<void(const std::filesystem::path&)>& take) {
  delete asker.findChild<QFileDialog*>(QString(), Qt::FindDirectChildrenOnly);
  auto* dialog = new QFileDialog(&asker, question.title);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setOption(QFileDialog::DontUseNativeDialog); // in the language and the size of the window
  dialog->setModal(false);
  dialog->setAcceptMode(question.isToSave ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
  dialog->setFileMode(question.isToSave ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
  dialog->setNameFilters(question.filters);
  const QFileInfo start(question.start);
  dialog->setDirectory(start.isDir() ? question.start : start.path());
  if (!start.isDir()) {
    dialog->selectFile(question.start);
  }
  if (question.isToSave) {
    dialog->setDefaultSuffix(endingOf(question.filters.value(0)));
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog,
                     [dialog](const QString& filter) { dialog->setDefaultSuffix(endingOf(filter)); });
  }
  QObject::connect(dialog, &QFileDialog::fileSelected, &asker,
                   [take](const QString& file) { take(file.toStdString()); });
  dialog->show();
}

} // namespace arris::ui
