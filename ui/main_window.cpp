#include "ui/main_window.h"

#include "ui/pages/job_page.h"
#include "ui/pages/profiles_page.h"
#include "ui/pages/run_page.h"
#include "ui/pages/setup_page.h"
#include "ui/widgets/alarm_banner.h"
#include "ui/widgets/control_strip.h"

#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QUrl>
#include <QVBoxLayout>

namespace arris::ui {
namespace {

// The one file of a drag, where it is one.
QString droppedFile(const QMimeData& data) {
  const QList<QUrl> urls = data.urls();
  return urls.size() == 1 && urls.front().isLocalFile() ? urls.front().toLocalFile() : QString();
}

} // namespace

MainWindow::MainWindow(const MachineSetup& setup, PlannerSteps steps, QWidget* parent)
    : QMainWindow(parent), m_planner(setup.machine, std::move(steps)), m_machine(setup),
      m_strip(new ControlStrip(m_machine)), m_pages(new QStackedWidget) {
  setWindowTitle(QStringLiteral("Arris"));
  setAcceptDrops(true);
  auto* job = new JobPage(m_planner);
  addPage(job, tr("Job"), QStringLiteral("pageJob"));
  addPage(new SetupPage(m_machine), tr("Setup"), QStringLiteral("pageSetup"));
  addPage(new RunPage(m_planner, m_machine), tr("Run"), QStringLiteral("pageRun"));
  addPage(new ProfilesPage(m_planner, m_profileFiles), tr("Profiles"), QStringLiteral("pageProfiles"));
  m_strip->showPage(0);
  auto* beside = new QWidget;
  auto* row = new QHBoxLayout(beside);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(m_pages, 1);
  row->addWidget(m_strip);
  auto* all = new QWidget;
  auto* column = new QVBoxLayout(all);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(new AlarmBanner(m_machine));
  column->addWidget(beside, 1);
  setCentralWidget(all);
  connect(m_strip, &ControlStrip::pageChosen, m_pages, &QStackedWidget::setCurrentIndex);
  connect(job, &JobPage::openRequested, this, &MainWindow::askForPattern);
  connect(&m_planner, &Planner::planned, this, [this](const PlanPointer& plan) {
    const QString name = QString::fromStdString(plan->import->file.filename().string());
    setWindowTitle(tr("%1 – Arris").arg(name));
  });
  connect(&m_machine, &MachineLink::changed, this, [this] {
    if (m_closes && !m_machine.allowed().stop) {
      close();
    }
  });
}

MainWindow::~MainWindow() {
  delete takeCentralWidget();
}

void MainWindow::addPage(QWidget* page, const QString& text, const QString& name) {
  m_pages->addWidget(page);
  m_strip->addPage(text, name);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!m_machine.allowed().stop) {
    event->accept();
    return;
  }
  event->ignore();
  if (m_closes || m_question) { // on its way, or being asked
    return;
  }
  m_question = new QMessageBox(QMessageBox::Warning, tr("The machine is moving"),
                               tr("Stop the machine and close Arris? The job can be resumed later."),
                               QMessageBox::NoButton, this);
  QPushButton* stops = m_question->addButton(tr("Stop and close"), QMessageBox::AcceptRole);
  m_question->addButton(tr("Keep running"), QMessageBox::RejectRole);
  m_question->setAttribute(Qt::WA_DeleteOnClose);
  m_question->setModal(false); // FEED HOLD and STOP stay within reach
  connect(stops, &QPushButton::clicked, this, [this] {
    m_closes = true;
    m_machine.stop();
    if (!m_machine.allowed().stop) {
      close();
    }
  });
  m_question->show();
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
