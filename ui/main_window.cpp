#include "ui/main_window.h"

#include "ui/pages/job_page.h"

#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMimeData>
#include <QUrl>

namespace arris::ui {
namespace {

// The one file of a drag, where it is one.
QString droppedFile(const QMimeData& data) {
  const QList<QUrl> urls = data.urls();
  return urls.size() == 1 && urls.front().isLocalFile() ? urls.front().toLocalFile() : QString();
}

} // namespace

MainWindow::MainWindow(recipe::Machine machine, PlannerSteps steps, QWidget* parent)
    : QMainWindow(parent), m_planner(std::move(machine), std::move(steps)) {
  setWindowTitle(QStringLiteral("Arris"));
  setAcceptDrops(true);
  auto* page = new JobPage(m_planner);
  setCentralWidget(page);
  connect(page, &JobPage::openRequested, this, &MainWindow::askForPattern);
  connect(&m_planner, &Planner::planned, this, [this](const PlanPointer& plan) {
    const QString name = QString::fromStdString(plan->import->file.filename().string());
    setWindowTitle(tr("%1 – Arris").arg(name));
  });
}

void MainWindow::openPattern(const std::filesystem::path& file) {
  m_folder = QFileInfo(QString::fromStdString(file.string())).absolutePath();
  m_planner.openPattern(file);
}

void MainWindow::askForPattern() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Open pattern"), m_folder, tr("Drawings (*.dxf *.DXF);;All files (*)"));
  if (!file.isEmpty()) {
    openPattern(file.toStdString());
  }
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!droppedFile(*event->mimeData()).isEmpty()) {
    event->acceptProposedAction();
  }
}

void MainWindow::dropEvent(QDropEvent* event) {
  openPattern(droppedFile(*event->mimeData()).toStdString());
  event->acceptProposedAction();
}

} // namespace arris::ui
