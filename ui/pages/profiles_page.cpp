#include "ui/pages/profiles_page.h"

#include "core/files/run_record.h"
#include "ui/figures/path_plot.h"
#include "ui/figures/profile_plot.h"
#include "ui/text/file_texts.h"
#include "ui/text/problem_texts.h"
#include "ui/widgets/busy_bar.h"
#include "ui/widgets/file_question.h"
#include "ui/widgets/instant_values.h"
#include "ui/widgets/signs.h"

#include <QBoxLayout>
#include <QButtonGroup>
#include <QLabel>
#include <QStackedWidget>
#include <QToolButton>

#include <algorithm>

namespace arris::ui {
namespace {

constexpr int kProfileSignSize = 24;
constexpr double kRoomAtCorner = 0.1; // of its time, before and after

} // namespace

ProfilesPage::ProfilesPage(Planner& planner, ProfileFiles& files, ProfileSight& sight, QWidget* parent)
    : QWidget(parent), m_planner(planner), m_files(files), m_sight(sight), m_plan(planner.plan()),
      m_planned(planner.curves()), m_speeds(new ProfilePlot(screenStyle(kPlotUnit), PlotContent::Speeds)),
      m_positions(new ProfilePlot(screenStyle(kPlotUnit), PlotContent::Positions)),
      m_path(new PathPlot(screenStyle(kPlotUnit))), m_plots(new QStackedWidget), m_values(new InstantValues),
      m_contents(new QButtonGroup(this)), m_stateSign(new QLabel), m_state(new QLabel),
      m_busy(new BusyBar(tr("Reading"))) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 4);
  layout->setSpacing(4);
  layout->addWidget(makeFileButtons());
  layout->addWidget(makeViewButtons());
  layout->addWidget(makeTexts());
  layout->addWidget(m_busy);
  layout->addWidget(makePlots(), 1);
  connectPlanner();
  connectFiles();
  m_openIsRecord = m_files.lastOpened() && files::isRecord(m_files.lastOpened()->file);
  m_busy->setVisible(m_files.isBusy());
  const ProfileSight before = m_sight;
  showProfiles(View::Work);
  lookAgain(before);
}

ProfilesPage::~ProfilesPage() {
  m_sight.times.reset();
  const bool hasSpeeds = !m_anew.at(ProfileSight::Speeds);
  if (content() != ProfileSight::Positions && hasSpeeds) {
    m_sight.times = m_speeds->shownTimes();
  } else if (!m_anew.at(ProfileSight::Positions)) {
    m_sight.times = m_positions->shownTimes();
  }
}

void ProfilesPage::lookAgain(const ProfileSight& before) {
  showValuesOf(content());
  if (m_shown.empty()) {
    return;
  }
  if (before.pass && *before.pass < m_passes.size()) {
    m_sight.pass = before.pass;
    markCorner(m_passes[*before.pass].corner);
  }
  if (before.times) {
    for (const Content each : {ProfileSight::Speeds, ProfileSight::Positions}) {
      m_anew.at(each) = false;
    }
    m_speeds->showTimes(before.times->first, before.times->second);
    m_positions->showTimes(before.times->first, before.times->second);
  }
  pointAt(before.instant);
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

QWidget* ProfilesPage::makeFileButtons() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  addButton(*layout, tr("Open…"), "profilesOpen", tr("Open an exported profile or the record of a run"),
            [this] { askForFile(); });
  m_back = addButton(*layout, tr("Planned"), "profilesPlanned", tr("Back to the planned profile alone"),
                     [this] { showPlanned(); });
  m_overlay =
      addButton(*layout, tr("Over the plan"), "profilesOverlay", tr("Show the plan under the open file"), [this] {
        m_sight.isOverPlan = m_overlay->isChecked();
        showProfiles(View::Keep);
      });
  m_overlay->setCheckable(true);
  m_overlay->setChecked(m_sight.isOverPlan);
  layout->addStretch(1);
  QToolButton* save = addButton(*layout, tr("Picture…"), "profilesSave", tr("Save a picture as SVG, PNG or PDF"),
                                [this] { askForPicture(); });
  m_saveProfile = addButton(*layout, tr("Profile…"), "profilesSaveProfile", tr("Save the profile as a table (CSV)"),
                            [this] { askForProfile(); });
  m_saveSheet =
      addButton(*layout, tr("Job sheet…"), "profilesSaveSheet",
                tr("Save drawing, values, corners and times of the job as PDF"), [this] { askForJobSheet(); });
  m_forProfiles = {save};
  return row;
}

void ProfilesPage::addContent(QBoxLayout& layout, Content content, const QString& text, const char* name,
                              const QString& what) {
  QToolButton* button = addButton(layout, text, name, what, [this] { showContent(); });
  button->setCheckable(true);
  button->setChecked(content == m_sight.content);
  m_contents->addButton(button, content);
}

QWidget* ProfilesPage::makeViewButtons() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  addContent(*layout, ProfileSight::Speeds, tr("Speeds"), "profilesSpeeds",
             tr("Velocities, accelerations and distance to the corner over time"));
  addContent(*layout, ProfileSight::Positions, tr("Positions"), "profilesPositions", tr("X and Y over time"));
  addContent(*layout, ProfileSight::Path, tr("Path"), "profilesPath", tr("The way of the wheel in the plane"));
  layout->addStretch(1);
  QToolButton* previous = addButton(*layout, QStringLiteral("◀"), "profilesPreviousCorner", tr("Previous corner"),
                                    [this] { goToNextCorner(-1); });
  QToolButton* next =
      addButton(*layout, QStringLiteral("▶"), "profilesNextCorner", tr("Next corner"), [this] { goToNextCorner(1); });
  layout->addSpacing(8);
  using Act = std::function<void(PointedPlot&)>;
  const auto addView = [&](const QString& text, const char* name, const QString& what, const Act& act) {
    m_forProfiles.push_back(addButton(*layout, text, name, what, [this, act] { act(*plot()); }));
  };
  addView(QStringLiteral("−"), "profilesZoomOut", tr("Zoom out"), [](PointedPlot& plot) { plot.zoomOut(); });
  addView(QStringLiteral("+"), "profilesZoomIn", tr("Zoom in"), [](PointedPlot& plot) { plot.zoomIn(); });
  addView(tr("Work"), "profilesWork", tr("From the first lead-in to the last lead-out"),
          [](PointedPlot& plot) { plot.showWork(); });
  addView(tr("All"), "profilesAll", tr("From the start of the program to its end; of the path: all of the travel"),
          [](PointedPlot& plot) { plot.showAll(); });
  m_forCorners = {previous, next};
  return row;
}

QWidget* ProfilesPage::makePlots() {
  for (PointedPlot* plot : plots()) {
    m_plots->addWidget(plot);
    plot->setFocusPolicy(Qt::StrongFocus);
    connect(plot, &PointedPlot::instantPointed, this, &ProfilesPage::pointAt);
  }
  for (const ProfilePlot* plot : {m_speeds, m_positions}) {
    connect(plot, &PointedPlot::cornerTapped, this, &ProfilesPage::selectCorner);
  }
  connect(m_path, &PathPlot::cornerTapped, this, [this](int corner) {
    const auto pass = std::find_if(m_passes.begin(), m_passes.end(),
                                   [corner](const CornerPass& candidate) { return candidate.corner == corner; });
    if (pass != m_passes.end()) {
      goToPass(static_cast<std::size_t>(pass - m_passes.begin()));
    }
  });
  m_speeds->setObjectName(QStringLiteral("speedsPlot"));
  m_positions->setObjectName(QStringLiteral("positionsPlot"));
  m_path->setObjectName(QStringLiteral("pathPlot"));
  m_plots->setCurrentIndex(m_sight.content);
  return m_plots;
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
  connect(&m_files, &ProfileFiles::opened, this, [this] {
    m_openIsRecord = files::isRecord(m_files.lastOpened()->file);
    m_sight.instant.reset();
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
    m_sight.instant.reset();
    showProfiles(View::Work);
  }
  showState();
}

CurvesPointer ProfilesPage::actual() const {
  return m_files.lastOpened() ? m_files.lastOpened()->curves : nullptr;
}

ProfileLimits ProfilesPage::limits() const {
  return m_planned ? limitsOf(m_plan->job) : ProfileLimits();
}

ProfilesPage::Content ProfilesPage::content() const {
  return static_cast<Content>(m_contents->checkedId());
}

std::array<PointedPlot*, ProfileSight::ContentCount> ProfilesPage::plots() const {
  return {m_speeds, m_positions, m_path};
}

PointedPlot* ProfilesPage::plot() const {
  return plots().at(content());
}

void ProfilesPage::markCorner(int corner) {
  for (PointedPlot* plot : plots()) {
    plot->selectCorner(corner);
  }
}

ProfilePlot& ProfilesPage::timePlot() const {
  return content() == ProfileSight::Positions ? *m_positions : *m_speeds;
}

void ProfilesPage::showProfiles(View view) {
  const std::vector<CornerPass> before = m_passes;
  m_shown.clear();
  const CurvesPointer opened = actual();
  if (m_planned && (!opened || m_sight.isOverPlan)) {
    m_shown.push_back(*m_planned);
    m_shown.back().name = tr("Plan");
  }
  if (opened) {
    m_shown.push_back(*opened);
  }
  m_passes = m_shown.empty() ? std::vector<CornerPass>() : cornerPasses(m_shown.front());
  const bool same = std::equal(m_passes.begin(), m_passes.end(), before.begin(), before.end(),
                               [](const CornerPass& a, const CornerPass& b) { return a.corner == b.corner; });
  const bool anew = !same || view == View::Work;
  if (anew) {
    m_sight.pass.reset();
  }
  m_stale.fill(true);
  for (bool& each : m_anew) {
    each = each || view == View::Work;
  }
  feed();
  if (anew) {
    markCorner(0);
  }
  pointAt(m_shown.empty() ? std::nullopt : m_sight.instant);
  showState();
}

void ProfilesPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  feed();
}

// Only the plot that is seen, and only while it is: profiles are long, and plans change with every value.
void ProfilesPage::feed() {
  const Content now = content();
  if (!isVisible() || !m_stale.at(now)) {
    return;
  }
  const bool isAnew = m_anew.at(now);
  feedPlot(now, !isAnew);
  m_stale.at(now) = m_anew.at(now) = false;
  if (isAnew && m_sight.pass) {
    if (now == ProfileSight::Path) { // times may have been zoomed since
      m_path->showPass(m_passes.at(*m_sight.pass));
    } else {
      showPass(*m_sight.pass);
    }
  }
}

void ProfilesPage::feedPlot(Content content, bool keepView) {
  if (content != ProfileSight::Path) {
    timePlot().setProfiles(m_shown, limits(), keepView);
    return;
  }
  m_path->setProfiles(m_shown, m_planned ? m_plan->pathSetting : PathSetting(), limits().wheelRadius, keepView);
}

// The time that was shown stays, and the corner.
void ProfilesPage::showContent() {
  const Content now = content();
  const Content before = m_sight.content;
  const std::pair<double, double> times = (before == ProfileSight::Positions ? m_positions : m_speeds)->shownTimes();
  m_sight.content = now;
  m_plots->setCurrentIndex(now);
  feed();
  if (now != ProfileSight::Path && before != ProfileSight::Path && now != before) {
    timePlot().showTimes(times.first, times.second);
  }
  showValuesOf(now);
  pointAt(m_sight.instant);
}

void ProfilesPage::showValuesOf(Content content) {
  static constexpr std::array kPlaces{Panel::PositionX, Panel::PositionY, Panel::Speed, Panel::Distance};
  m_values->setPanels(content == ProfileSight::Speeds ? panelsOf(PlotContent::Speeds)
                                                      : std::span<const Panel>(kPlaces));
}

void ProfilesPage::showState() {
  const CurvesPointer opened = actual();
  std::optional<base::Severity> sign;
  if (m_problem) {
    m_state->setText(breakableAtFolders(
        tr("%1 %2").arg(problemText(*m_problem, QLocale()), placeText(*m_problem, QLocale())).trimmed()));
    sign = base::Severity::Error;
  } else if (m_files.isBusy()) {
    m_state->setText(tr("Reading or writing…"));
  } else if (m_saved) {
    m_state->setText(tr("Saved: %1").arg(nameOfFile(*m_saved)));
  } else if (opened && !m_files.lastOpened()->damage.empty()) {
    m_state->setText(breakableAtFolders(problemText(m_files.lastOpened()->damage.front(), QLocale())));
    sign = base::Severity::Warning;
  } else if (m_shown.size() > 1) {
    m_state->setText(tr("%1, drawn thin over the plan, which is wide and pale").arg(opened->name));
  } else if (opened) {
    m_state->setText(opened->name);
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
  showEnabled();
}

void ProfilesPage::showEnabled() {
  const bool isOpen = actual() != nullptr;
  m_back->setEnabled(isOpen || m_files.isBusy());
  m_overlay->setVisible(isOpen);
  m_overlay->setEnabled(isOpen && m_planned);
  m_saveProfile->setEnabled(m_openIsRecord || m_planned);
  m_saveSheet->setEnabled(m_plan != nullptr);
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
  m_folder = folderOfFile(file);
  m_files.open(file);
  showState();
}

void ProfilesPage::showPlanned() {
  m_files.close();
  m_openIsRecord = false;
  m_problem.reset();
  m_saved.reset();
  showProfiles(View::Work);
}

void ProfilesPage::tellProblem(const base::Problem& problem) {
  m_problem = problem;
  showState();
}

void ProfilesPage::askForFile() {
  ui::askForFile(*this,
                 {tr("Open profile or record"), m_folder,
                  tr("Records and profiles (*.arrisrun *.csv *.CSV);;All files (*)").split(QStringLiteral(";;"))},
                 [this](const std::filesystem::path& file) { openFile(file); });
}

// From the last corner on to the first again.
void ProfilesPage::goToNextCorner(int step) {
  const auto count = static_cast<int>(m_passes.size());
  if (count > 0) {
    const int from = m_sight.pass ? static_cast<int>(*m_sight.pass) : (step > 0 ? -1 : count);
    goToPass(static_cast<std::size_t>((from + step + count) % count));
  }
}

void ProfilesPage::goToPass(std::size_t at) {
  m_sight.pass = at;
  showPass(at);
  pointAt(m_passes.at(at).middle);
}

// A run that was held comes to the corner later than planned: both are in view.
void ProfilesPage::showPass(std::size_t at) {
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
  for (ProfilePlot* plot : {m_speeds, m_positions}) {
    plot->selectCorner(pass.corner);
    plot->showTimes(from - kRoomAtCorner * (to - from), to + kRoomAtCorner * (to - from));
  }
  m_path->showPass(pass);
}

// Tapped: it comes after the time that was pointed at. A corner can be passed more than once.
void ProfilesPage::selectCorner(int corner) {
  const auto pass = std::find_if(m_passes.begin(), m_passes.end(), [&](const CornerPass& candidate) {
    return candidate.corner == corner && m_sight.instant && *m_sight.instant >= candidate.from &&
           *m_sight.instant <= candidate.to;
  });
  if (pass != m_passes.end()) {
    m_sight.pass = static_cast<std::size_t>(pass - m_passes.begin());
    markCorner(corner);
  }
}

void ProfilesPage::pointAt(std::optional<double> time) {
  m_sight.instant = time;
  for (PointedPlot* plot : plots()) {
    plot->markInstant(time);
  }
  m_values->showValues(m_shown, time);
}

} // namespace arris::ui
