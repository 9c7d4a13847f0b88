#include "ui/pages/profiles_page.h"

#include "ui/figures/profile_figure.h"
#include "ui/figures/profile_plot.h"
#include "ui/text/problem_texts.h"
#include "ui/widgets/busy_bar.h"
#include "ui/widgets/instant_values.h"
#include "ui/widgets/signs.h"

#include <QBoxLayout>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QToolButton>

#include <algorithm>

namespace arris::ui {
namespace {

constexpr int kProfileSignSize = 24;
constexpr double kRoomAtCorner = 0.1; // of its time, before and after

QString nameOfFile(const std::filesystem::path& file) {
  return QString::fromStdString(file.filename().string());
}

// A path may break after each of its folders: it has no spaces.
QString breakable(QString text) {
  return text.replace(QLatin1Char('/'), QStringLiteral("/\u200b"));
}

} // namespace

ProfilesPage::ProfilesPage(Planner& planner, QWidget* parent)
    : QWidget(parent), m_planner(planner), m_plot(new ProfilePlot(screenStyle(kPlotUnit))), m_values(new InstantValues),
      m_stateSign(new QLabel), m_state(new QLabel), m_busy(new BusyBar(tr("Reading"))) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 4);
  layout->setSpacing(4);
  layout->addWidget(makeButtons());
  layout->addWidget(makeTexts());
  layout->addWidget(m_busy);
  layout->addWidget(m_plot, 1);
  connectPlanner();
  connectFiles();
  connect(m_plot, &ProfilePlot::instantPointed, this, &ProfilesPage::pointAt);
  connect(m_plot, &ProfilePlot::cornerTapped, this, &ProfilesPage::selectCorner);
  m_plot->setFocusPolicy(Qt::StrongFocus);
  m_plan = planner.plan();
  m_planned = planner.curves();
  showProfiles(View::Work);
}

QToolButton* ProfilesPage::addButton(QBoxLayout& layout, const QString& text, const char* name, const QString& what,
                                     const std::function<void()>& act) {
  auto* button = new QToolButton;
  button->setText(text);
  button->setObjectName(QString::fromLatin1(name));
  button->setToolTip(what);
  button->setAccessibleName(what);
  button->setProperty("sign", text.size() == 1);
  button->setFocusPolicy(Qt::StrongFocus);
  layout.addWidget(button);
  connect(button, &QToolButton::clicked, this, act);
  return button;
}

QWidget* ProfilesPage::makeButtons() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  addButton(*layout, tr("Open…"), "profilesOpen", tr("Open an exported profile or the record of a run"),
            [this] { askForFile(); });
  m_back = addButton(*layout, tr("Planned"), "profilesPlanned", tr("Back to the planned profile alone"),
                     [this] { showPlanned(); });
  m_overlay = addButton(*layout, tr("Over the plan"), "profilesOverlay", tr("Show the plan under the open file"),
                        [this] { showProfiles(View::Keep); });
  m_overlay->setCheckable(true);
  m_overlay->setChecked(true);
  QToolButton* save = addButton(*layout, tr("Picture…"), "profilesSave", tr("Save a picture as SVG, PNG or PDF"),
                                [this] { askForPicture(); });
  layout->addStretch(1);
  QToolButton* previous = addButton(*layout, QStringLiteral("◀"), "profilesPreviousCorner", tr("Previous corner"),
                                    [this] { goToNextCorner(-1); });
  QToolButton* next =
      addButton(*layout, QStringLiteral("▶"), "profilesNextCorner", tr("Next corner"), [this] { goToNextCorner(1); });
  layout->addSpacing(8);
  QToolButton* out =
      addButton(*layout, QStringLiteral("−"), "profilesZoomOut", tr("Zoom out"), [this] { m_plot->zoomOut(); });
  QToolButton* in =
      addButton(*layout, QStringLiteral("+"), "profilesZoomIn", tr("Zoom in"), [this] { m_plot->zoomIn(); });
  QToolButton* work = addButton(*layout, tr("Work"), "profilesWork", tr("From the first lead-in to the last lead-out"),
                                [this] { m_plot->showWork(); });
  QToolButton* all = addButton(*layout, tr("All"), "profilesAll", tr("From the start of the program to its end"),
                               [this] { m_plot->showAll(); });
  m_forCorners = {previous, next};
  m_forProfiles = {save, out, in, work, all};
  return row;
}

QWidget* ProfilesPage::makeTexts() {
  m_stateSign->setFixedSize(kProfileSignSize, kProfileSignSize);
  m_state->setObjectName(QStringLiteral("profilesState"));
  m_state->setWordWrap(true);
  m_busy->hide();
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  layout->addWidget(m_stateSign);
  layout->addWidget(m_state, 1);
  layout->addWidget(m_values);
  return row;
}

void ProfilesPage::connectPlanner() {
  connect(&m_planner, &Planner::planned, this, &ProfilesPage::showPlan);
  connect(&m_planner, &Planner::busyChanged, this, &ProfilesPage::showState);
  connect(&m_planner, &Planner::profileReady, this, [this](const CurvesPointer& curves) {
    const View view = m_shown.empty() ? View::Work : View::Keep;
    m_planned = curves;
    showProfiles(view);
  });
}

void ProfilesPage::connectFiles() {
  connect(&m_files, &ProfileFiles::busyChanged, this, [this](bool busy) {
    m_busy->setVisible(busy);
    showState();
  });
  connect(&m_files, &ProfileFiles::opened, this, [this](const CurvesPointer& curves, const base::Problems& damage) {
    m_actual = curves;
    m_damage = damage;
    m_instant.reset();
    showProfiles(View::Work);
  });
  connect(&m_files, &ProfileFiles::saved, this, [this](const std::filesystem::path& file) {
    m_saved = file;
    showState();
  });
  connect(&m_files, &ProfileFiles::failed, this, &ProfilesPage::tellProblem);
}

// The profile follows a moment later; until then that of the plan before stays, but none of another pattern.
void ProfilesPage::showPlan(const PlanPointer& plan) {
  const bool another = !m_plan || m_plan->import->file != plan->import->file;
  m_plan = plan;
  if (m_planned && (another || !plan->job.canBeGround())) {
    m_planned.reset();
    m_instant.reset();
    showProfiles(View::Work);
  }
  showState();
}

void ProfilesPage::showProfiles(View view) {
  const std::vector<CornerPass> before = m_passes;
  m_shown.clear();
  if (m_planned && (!m_actual || m_overlay->isChecked())) {
    m_shown.push_back(*m_planned);
    m_shown.back().name = tr("Plan");
  }
  if (m_actual) {
    m_shown.push_back(*m_actual);
  }
  m_plot->setProfiles(m_shown, m_planned ? limitsOf(m_plan->job) : ProfileLimits(), view == View::Keep);
  m_passes = m_shown.empty() ? std::vector<CornerPass>() : cornerPasses(m_shown.front());
  const bool same = std::equal(m_passes.begin(), m_passes.end(), before.begin(), before.end(),
                               [](const CornerPass& a, const CornerPass& b) { return a.corner == b.corner; });
  if (!same || view == View::Work) {
    m_pass.reset();
    m_plot->selectCorner(0);
  }
  pointAt(m_shown.empty() ? std::nullopt : m_instant);
  showState();
}

void ProfilesPage::showState() {
  std::optional<base::Severity> sign;
  if (m_problem) {
    m_state->setText(
        breakable(tr("%1 %2").arg(problemText(*m_problem, QLocale()), placeText(*m_problem, QLocale())).trimmed()));
    sign = base::Severity::Error;
  } else if (m_files.isBusy()) {
    m_state->setText(tr("Reading or writing…"));
  } else if (m_saved) {
    m_state->setText(tr("Saved: %1").arg(nameOfFile(*m_saved)));
  } else if (m_actual && !m_damage.empty()) {
    m_state->setText(breakable(problemText(m_damage.front(), QLocale())));
    sign = base::Severity::Warning;
  } else if (m_shown.size() > 1) {
    m_state->setText(tr("%1, drawn thin over the plan, which is wide and pale").arg(m_actual->name));
  } else if (m_actual) {
    m_state->setText(m_actual->name);
  } else if (m_planned) {
    m_state->setText(tr("Planned: %1").arg(nameOfFile(m_plan->import->file)));
  } else if (m_planner.isBusy()) {
    m_state->setText(tr("Planning…"));
  } else if (m_plan && !m_plan->job.canBeGround()) {
    m_state->setText(tr("The pattern cannot be ground: there is no planned profile."));
  } else {
    m_state->setText(tr("No pattern is open. Profiles and records of runs can be opened all the same."));
  }
  m_stateSign->setPixmap(sign ? signIcon(*sign).pixmap(kProfileSignSize) : QPixmap());
  m_back->setEnabled(m_actual || m_files.isBusy());
  m_overlay->setEnabled(m_actual && m_planned);
  for (QToolButton* button : m_forProfiles) {
    button->setEnabled(!m_shown.empty());
  }
  for (QToolButton* button : m_forCorners) {
    button->setEnabled(!m_passes.empty());
  }
}

void ProfilesPage::openFile(const std::filesystem::path& file) {
  m_problem.reset();
  m_saved.reset();
  m_folder = QFileInfo(QString::fromStdString(file.string())).absolutePath();
  m_files.open(file);
  showState();
}

void ProfilesPage::showPlanned() {
  m_files.abandon();
  m_problem.reset();
  m_saved.reset();
  m_actual.reset();
  m_damage.clear();
  showProfiles(View::Work);
}

void ProfilesPage::savePicture(const std::filesystem::path& file) {
  m_problem.reset();
  m_saved.reset();
  const QString pattern = m_plan ? nameOfFile(m_plan->import->file) : QString();
  const Figure figure = profileFigure(m_shown, m_planned ? limitsOf(m_plan->job) : ProfileLimits(),
                                      m_actual ? m_actual->name : pattern, {});
  if (const auto bytes = encodedFor(figure, file)) {
    m_files.save(file, *bytes);
  } else {
    tellProblem(bytes.error());
  }
}

void ProfilesPage::tellProblem(const base::Problem& problem) {
  m_problem = problem;
  showState();
}

void ProfilesPage::askForFile() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Open profile or record"), m_folder,
                                                    tr("Records and profiles (*.arrisrun *.csv *.CSV);;All files (*)"));
  if (!file.isEmpty()) {
    openFile(file.toStdString());
  }
}

void ProfilesPage::askForPicture() {
  QFileDialog dialog(this, tr("Save picture"), m_folder);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setNameFilters({QStringLiteral("SVG (*.svg)"), QStringLiteral("PNG (*.png)"), QStringLiteral("PDF (*.pdf)")});
  dialog.setDefaultSuffix(QStringLiteral("svg"));
  connect(&dialog, &QFileDialog::filterSelected, &dialog,
          [&dialog](const QString& filter) { dialog.setDefaultSuffix(filter.left(3).toLower()); });
  if (dialog.exec() == QDialog::Accepted && !dialog.selectedFiles().isEmpty()) {
    savePicture(dialog.selectedFiles().front().toStdString());
  }
}

// From the last corner on to the first again.
void ProfilesPage::goToNextCorner(int step) {
  const auto count = static_cast<int>(m_passes.size());
  if (count > 0) {
    const int from = m_pass ? static_cast<int>(*m_pass) : (step > 0 ? -1 : count);
    goToPass(static_cast<std::size_t>((from + step + count) % count));
  }
}

// A run that was held comes to the corner later than planned: both are in view.
void ProfilesPage::goToPass(std::size_t at) {
  const CornerPass& pass = m_passes.at(at);
  double from = pass.from;
  double to = pass.to;
  for (const ProfileCurves& curves : m_shown) {
    const std::vector<CornerPass> others = cornerPasses(curves);
    if (at < others.size() && others[at].corner == pass.corner) {
      from = std::min(from, others[at].from);
      to = std::max(to, others[at].to);
    }
  }
  m_pass = at;
  m_plot->selectCorner(pass.corner);
  m_plot->showTimes(from - kRoomAtCorner * (to - from), to + kRoomAtCorner * (to - from));
  pointAt(pass.middle);
}

// Tapped: it comes after the time that was pointed at. A corner can be passed more than once.
void ProfilesPage::selectCorner(int corner) {
  const auto pass = std::find_if(m_passes.begin(), m_passes.end(), [&](const CornerPass& candidate) {
    return candidate.corner == corner && m_instant && *m_instant >= candidate.from && *m_instant <= candidate.to;
  });
  if (pass != m_passes.end()) {
    m_pass = static_cast<std::size_t>(pass - m_passes.begin());
    m_plot->selectCorner(corner);
  }
}

void ProfilesPage::pointAt(std::optional<double> time) {
  m_instant = time;
  m_plot->markInstant(time);
  m_values->showValues(m_shown, time);
}

} // namespace arris::ui
