#include "ui/pages/job_page.h"

#include "ui/figures/profile_plot.h"
#include "ui/pages/findings_panel.h"
#include "ui/pages/recipe_panel.h"
#include "ui/presenters/wheel_walk.h"
#include "ui/text/job_texts.h"
#include "ui/text/problem_texts.h"
#include "ui/text/quantities.h"
#include "ui/views/drawing_view.h"
#include "ui/widgets/busy_bar.h"
#include "ui/widgets/busy_row.h"
#include "ui/widgets/corner_card.h"
#include "ui/widgets/signs.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/wheel_bar.h"

#include <QBoxLayout>
#include <QButtonGroup>
#include <QLabel>
#include <QResizeEvent>
#include <QShortcut>
#include <QSplitter>
#include <QToolButton>

#include <algorithm>
#include <array>
#include <functional>

namespace arris::ui {
namespace {

constexpr int kRecipeWidth = 236;
constexpr int kFindingsWidth = 540;
constexpr int kBesideFrom = 1500;   // px: from this width on the findings stand beside the drawing
constexpr int kNarrowestPage = 900; // px, in the smallest window
constexpr int kLowestPage = 624;    // px
constexpr int kStateSignSize = 24;
constexpr int kComplaintWidth = 520;
constexpr int kComplaintMargin = 10;
constexpr int kBusyRowWidth = 420;

enum View { DrawingOnly, ProfileOnly, Both };

QToolButton* makeButton(const QString& text, const QString& name) {
  auto* button = new QToolButton;
  button->setText(text);
  button->setObjectName(name);
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

} // namespace

JobPage::JobPage(Planner& planner, RecipeDesk& desk, WheelWalk& wheel, QWidget* parent)
    : QWidget(parent), m_planner(planner), m_wheel(wheel), m_recipe(new RecipePanel(planner, desk)),
      m_drawing(new DrawingView), m_profile(new ProfilePlot(screenStyle(kPlotUnit))), m_findings(new FindingsPanel),
      m_stateSign(new QLabel), m_state(new QLabel), m_complaint(new QLabel(this)), m_busy(new BusyBar(tr("Planning"))),
      m_busyRow(new BusyRow(this)), m_viewButtons(new QButtonGroup(this)), m_views(new QSplitter(Qt::Vertical)),
      m_split(new QSplitter(Qt::Vertical)) {
  m_recipe->setFixedWidth(kRecipeWidth);
  auto* middle = new QWidget;
  auto* middleLayout = new QVBoxLayout(middle);
  middleLayout->setContentsMargins(0, 0, 0, 0);
  middleLayout->setSpacing(2);
  middleLayout->addWidget(makeHeader());
  middleLayout->addWidget(m_busy);
  middleLayout->addWidget(makeViews(), 1);
  middleLayout->addWidget(new WheelBar(wheel));
  m_split->addWidget(middle);
  m_split->addWidget(m_findings);
  m_split->setChildrenCollapsible(false);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 4, 6, 4);
  layout->setSpacing(0);
  layout->addWidget(m_recipe);
  layout->addWidget(m_split, 1);
  m_complaint->setObjectName(QStringLiteral("complaint"));
  m_complaint->setWordWrap(true);
  m_complaint->setMargin(kComplaintMargin);
  m_complaint->hide();
  makeBusyRow();
  connectPlanner();
  connectViews();
  connectWheel();
  arrange();
  if (planner.plan()) {
    showPlan(planner.plan());
  }
  if (planner.curves()) {
    showProfile(planner.curves());
  }
  showWheel();
  showBusy(planner.isBusy());
}

void JobPage::setEngineeringEnabled(bool enabled) {
  m_recipe->setEngineeringEnabled(enabled);
}

QWidget* JobPage::makeHeader() {
  auto* header = new QWidget;
  auto* layout = new QHBoxLayout(header);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(6);
  const std::array<std::pair<QString, QString>, 3> views{{{tr("Drawing"), QStringLiteral("showDrawing")},
                                                          {tr("Profile"), QStringLiteral("showProfile")},
                                                          {tr("Both"), QStringLiteral("showBoth")}}};
  for (int i = 0; i < 3; ++i) {
    const auto& [text, name] = views.at(static_cast<std::size_t>(i));
    QToolButton* button = makeButton(text, name);
    button->setCheckable(true);
    button->setChecked(i == DrawingOnly);
    m_viewButtons->addButton(button, i);
    layout->addWidget(button);
  }
  m_stateSign->setFixedSize(kStateSignSize, kStateSignSize);
  m_state->setObjectName(QStringLiteral("state"));
  m_state->setWordWrap(true);
  layout->addSpacing(2);
  layout->addWidget(m_stateSign);
  layout->addWidget(m_state, 1);
  using Act = std::function<void()>;
  const auto addZoom = [&](const QString& text, const QString& name, const QString& what, const Act& drawing,
                           const Act& plot) {
    QToolButton* button = makeButton(text, name);
    button->setToolTip(what);
    button->setAccessibleName(what);
    button->setProperty("sign", text.size() == 1);
    layout->addWidget(button);
    m_zooms.push_back(button);
    connect(button, &QToolButton::clicked, this, [this, drawing, plot] {
      if (m_viewButtons->checkedId() != ProfileOnly) {
        drawing();
      }
      if (m_viewButtons->checkedId() != DrawingOnly) {
        plot();
      }
    });
  };
  addZoom(
      QStringLiteral("−"), QStringLiteral("zoomOut"), tr("Zoom out"), [this] { m_drawing->zoomOut(); },
      [this] { m_profile->zoomOut(); });
  addZoom(
      QStringLiteral("+"), QStringLiteral("zoomIn"), tr("Zoom in"), [this] { m_drawing->zoomIn(); },
      [this] { m_profile->zoomIn(); });
  addZoom(
      tr("Fit"), QStringLiteral("fit"), tr("Fit into the view"), [this] { m_drawing->fit(); },
      [this] { m_profile->showWork(); });
  return header;
}

void JobPage::makeBusyRow() {
  m_busyRow->setAutoFillBackground(true);
  m_busyRow->hide();
  connect(m_busyRow, &BusyRow::shownChanged, this, [this](bool shown) {
    m_busyRow->setVisible(shown);
    placeBusyRow();
  });
  connect(m_busyRow, &BusyRow::cancelled, &m_planner, &Planner::cancel);
  auto* escape = new QShortcut(Qt::Key_Escape, this);
  escape->setContext(Qt::WidgetWithChildrenShortcut);
  connect(escape, &QShortcut::activated, &m_planner, &Planner::cancel);
}

void JobPage::placeBusyRow() {
  const QPoint corner = m_split->mapTo(this, m_views->mapTo(m_split, QPoint(1, 1)));
  const int width = std::min(kBusyRowWidth, m_views->width() - 2);
  m_busyRow->setGeometry(QRect(corner, QSize(width, m_busyRow->sizeHint().height())));
  m_busyRow->raise();
}

QWidget* JobPage::makeViews() {
  m_views->addWidget(m_drawing);
  m_views->addWidget(m_profile);
  m_views->setChildrenCollapsible(false);
  return m_views;
}

void JobPage::connectPlanner() {
  connect(m_recipe, &RecipePanel::complaintChanged, this, &JobPage::showComplaint);
  connect(m_recipe, &RecipePanel::openRequested, this, &JobPage::openRequested);
  connect(&m_planner, &Planner::planned, this, &JobPage::showPlan);
  connect(&m_planner, &Planner::busyChanged, this, &JobPage::showBusy);
  connect(&m_planner, &Planner::profileReady, this, &JobPage::showProfile);
  connect(&m_planner, &Planner::openFailed, this, &JobPage::showState);
  connect(&m_planner, &Planner::progressed, this, [this](base::Stage stage) { m_busyRow->setText(stageText(stage)); });
}

void JobPage::connectViews() {
  connect(m_drawing, &DrawingView::cornerTapped, this, [this](int corner) {
    selectCorner(corner);
    m_findings->showCard();
    m_drawing->zoomToCorner(corner);
  });
  connect(m_drawing, &DrawingView::findingTapped, this, [this](const base::Problem& finding) {
    m_findings->selectProblem(finding);
    m_drawing->markPlace(*finding.where);
  });
  connect(m_profile, &ProfilePlot::cornerTapped, this, &JobPage::selectCorner);
  connect(m_findings, &FindingsPanel::cornerChosen, this, [this](int corner) {
    selectCorner(corner);
    m_drawing->zoomToCorner(corner);
  });
  connect(m_findings, &FindingsPanel::problemChosen, this, &JobPage::showProblem);
  connect(m_viewButtons, &QButtonGroup::idClicked, this, &JobPage::arrange);
}

// Beside its path a tap selects nothing.
void JobPage::connectWheel() {
  m_drawing->setWheelMovable(true);
  connect(&m_wheel, &WheelWalk::changed, this, &JobPage::showWheel);
  connect(&m_wheel, &WheelWalk::stepped, m_drawing, &DrawingView::bringWheelIntoView);
  connect(m_drawing, &DrawingView::wheelDragged, &m_wheel, &WheelWalk::dragTo);
  connect(m_drawing, &DrawingView::wheelStepped, this, [this](int step) {
    if (step > 0) {
      m_wheel.stepOn();
    } else {
      m_wheel.stepBack();
    }
  });
  connect(m_drawing, &DrawingView::placeTapped, this, [this](const geometry::Point& place, double reach) {
    if (!m_wheel.putTo(place, reach)) {
      selectCorner(0);
      m_findings->showCard();
    }
  });
}

void JobPage::showWheel() {
  const std::optional<job::Sample> place = m_wheel.place();
  if (place) {
    m_drawing->setWheel(LiveWheel{place->setPoint.position.head<2>(), {}});
    m_profile->markInstant(place->setPoint.time);
  } else {
    m_drawing->setWheel(std::nullopt);
    m_profile->markInstant(std::nullopt);
  }
}

void JobPage::showPlan(const PlanPointer& plan) {
  if (!m_plan || m_plan->import->file != plan->import->file) {
    m_profileShown = false; // another pattern: the profile is shown from the start
  }
  m_plan = plan;
  m_recipe->setPlan(*plan);
  m_drawing->setPlan(plan);
  m_findings->setPlan(plan);
  if (!plan->job.canBeGround()) {
    m_profile->setProfiles({}, {});
    m_profileShown = false;
  }
  showState();
}

void JobPage::showProfile(const CurvesPointer& curves) {
  m_profile->setProfiles({*curves}, limitsOf(m_plan->job), m_profileShown);
  m_profileShown = true;
}

void JobPage::showState() {
  std::optional<base::Severity> sign;
  if (const auto& problem = m_planner.openProblem()) {
    m_state->setText(problemText(*problem, QLocale()));
    sign = base::Severity::Error;
  } else if (m_planner.isCancelled()) {
    m_state->setText(cancelledText());
    sign = base::Severity::Warning;
  } else if (!m_plan) {
    m_state->setText(m_planner.isBusy() ? tr("Reading and planning…") : tr("No pattern is open."));
  } else if (const int corner = m_findings->selectedCorner();
             m_plan->job.canBeGround() && corner > 0 && m_findings->isHidden() &&
             corner <= static_cast<int>(m_plan->job.toolpath.corners.size())) {
    m_state->setText(CornerCard::inShort(m_plan->job, corner));
  } else if (m_plan->job.canBeGround()) {
    const auto unbroken = [](double time) {
      return durationText(time, QLocale()).replace(QLatin1Char(' '), QChar(QChar::Nbsp));
    };
    m_state->setText(
        tr("Grinding: %1\nProgram: %2").arg(unbroken(m_plan->job.working), unbroken(m_plan->job.duration)));
  } else {
    m_state->setText(tr("Cannot be ground: see the problems."));
    sign = base::Severity::Error;
  }
  for (QToolButton* zoom : m_zooms) {
    zoom->setEnabled(m_plan != nullptr);
  }
  m_stateSign->setVisible(sign.has_value());
  m_stateSign->setPixmap(sign ? signIcon(*sign).pixmap(kStateSignSize) : QPixmap());
}

// In as few words as a small window has room for.
QString JobPage::cancelledText() const {
  if (!m_plan) {
    return tr("Cancelled. Open a pattern.");
  }
  return m_planner.isPresent() ? tr("Cancelled: no profile.\nTo plan: change a value.")
                               : tr("Cancelled: values before.\nTo plan: change a value.");
}

void JobPage::showBusy(bool busy) {
  m_busy->setVisible(busy);
  m_busyRow->setText(stageText(m_planner.stage()));
  m_busyRow->setBusy(busy);
  showState();
}

void JobPage::selectCorner(int corner) {
  m_findings->selectCorner(corner);
  m_drawing->selectCorner(corner);
  m_profile->selectCorner(corner);
  showState();
}

void JobPage::showProblem(const base::Problem& problem) {
  if (problem.corner) {
    selectCorner(*problem.corner);
  }
  if (problem.where) {
    if (m_viewButtons->checkedId() == ProfileOnly) {
      m_viewButtons->button(DrawingOnly)->click();
    }
    m_drawing->zoomToPlace(*problem.where);
  }
}

// On a small window profile and findings take turns: either alone is readable, both are not.
void JobPage::arrange() {
  const int choice = m_viewButtons->checkedId();
  m_drawing->setVisible(choice != ProfileOnly);
  m_profile->setVisible(choice != DrawingOnly);
  m_findings->setVisible(m_beside || choice == DrawingOnly);
  m_findings->setWide(!m_beside);
  m_split->setOrientation(m_beside ? Qt::Horizontal : Qt::Vertical);
  m_split->setSizes(m_beside ? QList{width() - kRecipeWidth - kFindingsWidth, kFindingsWidth} : QList{5800, 4200});
  m_views->setOrientation(m_beside ? Qt::Vertical : Qt::Horizontal);
  m_views->setSizes({5000, 5000});
  showState(); // with the figures of a corner where these have no room below
}

// What stands side by side stands below each other in a narrower window; while the page is hidden it is not arranged
// anew, and must not hold the window large.
QSize JobPage::minimumSizeHint() const {
  const QSize now = QWidget::minimumSizeHint();
  return {std::min(now.width(), kNarrowestPage), std::min(now.height(), kLowestPage)};
}

void JobPage::showComplaint(const QString& complaint) {
  m_complaint->setText(complaint);
  m_complaint->setVisible(!complaint.isEmpty());
  placeComplaint();
}

void JobPage::placeComplaint() {
  const int width = std::min(kComplaintWidth, this->width() - kRecipeWidth - kComplaintMargin);
  const int height = m_complaint->heightForWidth(width);
  m_complaint->setGeometry(kRecipeWidth, this->height() - height - kComplaintMargin, width, height);
  m_complaint->raise();
}

void JobPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  placeComplaint();
  placeBusyRow();
  const bool beside = event->size().width() >= kBesideFrom;
  if (beside != m_beside) {
    m_beside = beside;
    arrange();
  }
}

} // namespace arris::ui
