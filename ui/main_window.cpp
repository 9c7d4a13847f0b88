#include "ui/main_window.h"

#include "ui/figures/style.h"
#include "ui/pages/alarms_page.h"
#include "ui/pages/help_page.h"
#include "ui/pages/job_page.h"
#include "ui/pages/pattern_dialog.h"
#include "ui/pages/profiles_page.h"
#include "ui/pages/run_page.h"
#include "ui/pages/settings_page.h"
#include "ui/pages/setup_page.h"
#include "ui/text/file_texts.h"
#include "ui/text/translators.h"
#include "ui/widgets/alarm_banner.h"
#include "ui/widgets/control_strip.h"
#include "ui/widgets/keypad.h"
#include "ui/widgets/signs.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/wipe_cover.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QGridLayout>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QShortcut>
#include <QUrl>

namespace arris::ui {
namespace {

// The one file of a drag, where it is one.
QString droppedFile(const QMimeData& data) {
  const QList<QUrl> urls = data.urls();
  return urls.size() == 1 && urls.front().isLocalFile() ? urls.front().toLocalFile() : QString();
}

// What is asked for at this start comes before what was chosen.
MachineSetup with(const Preferences& preferences, MachineSetup setup) {
  setup.machine = preferences.machine();
  setup.axes = setup.axes.value_or(preferences.settings().axes);
  return setup;
}

constexpr int kQuestionSign = 40;      // px
constexpr int kKeepRecipeAfter = 2000; // ms without a change

// What counts for the whole process, but for the language.
void showWith(const files::Settings& settings) {
  const auto look = settings.appearance == files::Settings::Appearance::Dark ? Appearance::Dark : Appearance::Light;
  showLengthsIn(settings.lengthUnit == files::Settings::LengthUnit::Inch ? LengthUnit::Inch : LengthUnit::Millimetre);
  setKeypadOpens(settings.keypad == files::Settings::Keypad::Always ? KeypadOpens::OnEveryTap : KeypadOpens::OnTouch);
  if (look != appearance()) {
    showAppearance(look);
    applyTheme(*qApp);
  }
}

} // namespace

MainWindow::MainWindow(const MachineSetup& setup, PlannerSteps steps, QWidget* parent)
    : QMainWindow(parent), m_preferences(setup.folder, setup.machine), m_planner(m_preferences.machine(), steps),
      m_desk(m_planner, setup.folder), m_shelf(setup.folder, std::move(steps.read)),
      m_machine(with(m_preferences, setup)), m_shown(m_preferences.settings()) {
  setAcceptDrops(true);
  m_planner.setRecipe(m_preferences.lastRecipe());
  m_desk.history.forget();
  showWith(m_shown);
  if (!m_shown.language.empty()) {
    speak(QString::fromStdString(m_shown.language));
  }
  build();
  addShortcuts();
  m_keepRecipe.setSingleShot(true);
  m_keepRecipe.setInterval(kKeepRecipeAfter);
  connect(&m_keepRecipe, &QTimer::timeout, this, [this] { m_preferences.keepRecipe(m_planner.recipe()); });
  connect(&m_planner, &Planner::planned, this, [this] {
    m_preferences.noteOpened(m_planner.plan()->import->file);
    m_keepRecipe.start();
    showTitle();
  });
  connect(&m_shelf, &PatternShelf::chosen, this, &MainWindow::openPattern);
  connect(&m_machine, &MachineLink::changed, this, [this] {
    if (m_closes && !m_machine.allowed().stop) {
      close();
    }
  });
  connect(&m_preferences, &Preferences::changed, this, &MainWindow::applySettings, Qt::QueuedConnection);
  connect(&m_preferences, &Preferences::problemsArose, this, &MainWindow::tellProblems);
  connect(&m_alarms.backUps, &BackUps::restoring, &m_preferences, [this](bool restores) {
    m_preferences.setKeeping(!restores);
    m_desk.book.setKeeping(!restores);
  });
  tellProblems();
  for (const base::Problem& problem : m_desk.book.refresh()) {
    m_machine.complain(problem);
  }
  showTitle();
}

MainWindow::~MainWindow() {
  m_preferences.keepRecipe(m_planner.recipe());
  delete takeCentralWidget();
}

void MainWindow::build() {
  const Unstyled quicker;
  m_strip = new ControlStrip(m_machine);
  m_banner = new AlarmBanner(m_machine);
  m_pages = new QStackedWidget;
  auto* job = new JobPage(m_planner, m_desk, m_wheelWalk);
  addPage(job, tr("Job"), QStringLiteral("pageJob"));
  addPage(new SetupPage(m_machine), tr("Setup"), QStringLiteral("pageSetup"));
  addPage(new RunPage(m_planner, m_machine), tr("Run"), QStringLiteral("pageRun"));
  addPage(new ProfilesPage(m_planner, m_profileFiles, m_profileSight), tr("Profiles"), QStringLiteral("pageProfiles"));
  auto* alarms = new AlarmsPage(m_machine, m_alarms);
  addPage(alarms, tr("Alarms"), QStringLiteral("pageAlarms"));
  addPage(new SettingsPage(m_preferences), tr("Settings"), QStringLiteral("pageSettings"));
  m_help = new HelpPage;
  addPage(m_help, tr("Help"), QStringLiteral("pageHelp"));
  m_cover = new WipeCover(m_pages);
  auto* all = new QWidget;
  auto* grid = new QGridLayout(all);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(0);
  grid->addWidget(m_banner, 0, 0, 1, 2);
  grid->addWidget(m_pages, 1, 0);
  grid->addWidget(m_cover, 1, 0);
  grid->addWidget(m_strip, 1, 1);
  grid->setRowStretch(1, 1);
  grid->setColumnStretch(0, 1);
  setCentralWidget(all);
  m_strip->showPage(0);
  connect(m_strip, &ControlStrip::pageChosen, m_pages, &QStackedWidget::setCurrentIndex);
  connect(m_banner, &AlarmBanner::tapped, this, [this, alarms] { showPage(m_pages->indexOf(alarms)); });
  connect(m_strip, &ControlStrip::lockRequested, this, [this] { setLocked(true); });
  connect(m_cover, &WipeCover::ended, this, [this] { setLocked(false); });
  connect(job, &JobPage::openRequested, this, &MainWindow::askForPattern);
  connect(&m_preferences, &Preferences::openChanged, job, [this, job] {
    job->setEngineeringEnabled(m_preferences.isOpen());
    m_desk.history.forget(); // undo must not change what is locked
  });
  job->setEngineeringEnabled(m_preferences.isOpen());
}

void MainWindow::addPage(QWidget* page, const QString& text, const QString& name) {
  page->setProperty("page", name);
  m_pages->addWidget(page);
  m_strip->addPage(text, name);
}

// They work in every dialog too: none of them is modal.
void MainWindow::addShortcuts() {
  const auto add = [this](Qt::Key key, const std::function<void()>& act) {
    auto* shortcut = new QShortcut(key, this);
    shortcut->setContext(Qt::ApplicationShortcut);
    shortcut->setAutoRepeat(false);
    connect(shortcut, &QShortcut::activated, this, act);
  };
  add(Qt::Key_F1, [this] { showHelp(); });
  for (int page = 0; page < m_pages->count(); ++page) {
    add(static_cast<Qt::Key>(Qt::Key_F2 + page), [this, page] { showPage(page); });
  }
  add(Qt::Key_F11, [this] { m_machine.hold(); });
  add(Qt::Key_F12, [this] { m_machine.stop(); });
}

void MainWindow::showPage(int page) {
  if (m_pages->isEnabled()) { // not while the screen is locked
    m_strip->showPage(page);
    m_pages->setCurrentIndex(page);
  }
}

void MainWindow::showHelp() {
  const QString page = m_pages->currentWidget()->property("page").toString();
  if (m_pages->currentWidget() != m_help) {
    m_help->showPart(page);
  }
  showPage(m_pages->indexOf(m_help));
}

void MainWindow::setLocked(bool locked) {
  m_pages->setEnabled(!locked);
  m_strip->setLocked(locked);
  m_banner->setLocked(locked);
  if (locked) {
    delete findChild<Keypad*>();
    for (QDialog* dialog : findChildren<QDialog*>()) { // wiping would tap on it
      dialog->close();
    }
    m_cover->begin();
  }
}

void MainWindow::applySettings() {
  const files::Settings& settings = m_preferences.settings();
  const bool speaksAnother = settings.language != m_shown.language;
  const bool looksOtherwise = settings.appearance != m_shown.appearance || settings.lengthUnit != m_shown.lengthUnit;
  m_shown = settings;
  if (!speaksAnother && !looksOtherwise) {
    showWith(settings);
    return;
  }
  const int page = m_pages->currentIndex();
  delete findChild<Keypad*>();
  delete takeCentralWidget(); // first: what is there would be styled and spoken to in vain
  showWith(settings);
  if (speaksAnother) {
    speak(QString::fromStdString(settings.language));
  }
  build();
  showPage(page);
  showTitle();
}

void MainWindow::tellProblems() {
  for (const base::Problem& problem : m_preferences.takeProblems()) {
    m_machine.complain(problem);
  }
}

void MainWindow::showTitle() {
  const PlanPointer& plan = m_planner.plan();
  setWindowTitle(plan ? tr("%1 – Arris").arg(nameOfFile(plan->import->file)) : QStringLiteral("Arris"));
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
  QPushButton* keeps = m_question->addButton(tr("Keep running"), QMessageBox::RejectRole);
  m_question->setDefaultButton(keeps);
  m_question->setEscapeButton(keeps);
  m_question->setIconPixmap(signIcon(base::Severity::Warning).pixmap(kQuestionSign));
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
  m_shelf.noteOpened(file);
  m_planner.openPattern(file);
}

void MainWindow::openLast() {
  const std::vector<std::filesystem::path> recent = stillThere(m_preferences.settings().recent);
  if (!recent.empty()) {
    openPattern(recent.front());
  } else if (const auto sample = firstSample(m_machine.folder())) {
    openPattern(*sample);
  } else {
    m_machine.complain(sample.error());
  }
}

void MainWindow::askForPattern() {
  delete findChild<PatternDialog*>();
  auto* dialog = new PatternDialog(m_shelf, *m_pages);
  m_shelf.begin(m_preferences.settings().recent, pattern::importOptions(m_planner.recipe()));
  dialog->show();
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
