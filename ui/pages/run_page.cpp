#include "ui/pages/run_page.h"

#include "core/files/run_record.h"
#include "ui/text/quantities.h"
#include "ui/views/drawing_view.h"
#include "ui/widgets/hold_button.h"

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace arris::ui {

using control::State;

namespace {

constexpr int kColumnWidth = 324; // px
constexpr int kProgressSteps = 1000;
constexpr double kOverrideStep = 0.1;
constexpr double kStepLength = 10; // mm
constexpr int kPlaceDecimals = 3;

QLabel* makeFigure(const QString& name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  return label;
}

} // namespace

RunPage::RunPage(Planner& planner, MachineLink& machine, QWidget* parent)
    : QWidget(parent), m_machine(machine), m_drawing(new DrawingView), m_speed(makeFigure(QStringLiteral("speed"))),
      m_override(makeFigure(QStringLiteral("override"))), m_services(new QLabel), m_panes(new QLabel),
      m_revision(new QLabel), m_progress(new QProgressBar), m_left(new QLabel),
      m_start(new HoldButton(tr("CYCLE START"))) {
  auto* column = new QVBoxLayout;
  column->setSpacing(6);
  column->addWidget(makePlaces());
  column->addWidget(makeOverride());
  m_services->setObjectName(QStringLiteral("services"));
  column->addWidget(m_services);
  m_progress->setRange(0, kProgressSteps);
  m_progress->setTextVisible(false);
  m_progress->setAccessibleName(tr("Progress"));
  column->addWidget(m_progress);
  m_left->setObjectName(QStringLiteral("timeLeft"));
  column->addWidget(m_left);
  column->addStretch(1);
  column->addWidget(makePanes());
  makeCommands(*column);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 4);
  layout->addWidget(m_drawing, 1);
  auto* side = new QWidget;
  side->setFixedWidth(kColumnWidth);
  side->setLayout(column);
  column->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(side);
  connect(&planner, &Planner::planned, this, &RunPage::showPlan);
  connect(&machine, &MachineLink::changed, this, [this] {
    showDrawing();
    showAllowed();
  });
  connect(&machine, &MachineLink::reported, this, &RunPage::showReport);
  showPlan(planner.plan());
  showReport();
}

QWidget* RunPage::makePlaces() {
  auto* box = new QWidget;
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(2);
  grid->addWidget(new QLabel(tr("Table, mm")), 0, 1, Qt::AlignRight);
  grid->addWidget(new QLabel(tr("Machine, mm")), 0, 2, Qt::AlignRight);
  QFont large = font();
  large.setPixelSize(24);
  for (int axis = 0; axis < control::kAxes; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const QString name(QStringLiteral("XYZ").at(axis));
    auto* caption = new QLabel(name);
    m_places[i] = makeFigure(QStringLiteral("place") + name);
    m_machinePlaces[i] = makeFigure(QStringLiteral("machine") + name);
    caption->setFont(large);
    m_places[i]->setFont(large);
    grid->addWidget(caption, axis + 1, 0);
    grid->addWidget(m_places[i], axis + 1, 1);
    grid->addWidget(m_machinePlaces[i], axis + 1, 2);
  }
  grid->addWidget(new QLabel(tr("Speed, mm/s")), control::kAxes + 1, 0, 1, 2);
  grid->addWidget(m_speed, control::kAxes + 1, 2);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(2, 1);
  return box;
}

QWidget* RunPage::makeOverride() {
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(new QLabel(tr("Feed override")), 1);
  const auto add = [&](const QString& text, const QString& name, const QString& what, double by) {
    auto* button = new QPushButton(text);
    button->setObjectName(name);
    button->setAccessibleName(what);
    button->setProperty("sign", true);
    connect(button, &QPushButton::clicked, this, [this, by] { changeOverride(by); });
    row->addWidget(button);
  };
  add(QStringLiteral("−"), QStringLiteral("overrideDown"), tr("Lower feed override"), -kOverrideStep);
  row->addWidget(m_override);
  add(QStringLiteral("+"), QStringLiteral("overrideUp"), tr("Higher feed override"), kOverrideStep);
  m_override->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("000 %")) + 4);
  return box;
}

QWidget* RunPage::makePanes() {
  auto* box = new QWidget;
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  m_fewer = new QPushButton(QStringLiteral("−"));
  m_more = new QPushButton(QStringLiteral("+"));
  m_fewer->setProperty("sign", true);
  m_more->setProperty("sign", true);
  m_fewer->setAccessibleName(tr("Fewer panes"));
  m_more->setAccessibleName(tr("More panes"));
  m_fewer->setObjectName(QStringLiteral("panesFewer"));
  m_more->setObjectName(QStringLiteral("panesMore"));
  connect(m_fewer, &QPushButton::clicked, this, [this] { changePanes(-1); });
  connect(m_more, &QPushButton::clicked, this, [this] { changePanes(1); });
  m_panes->setAlignment(Qt::AlignCenter);
  m_load = makeButton(tr("Load job"), QStringLiteral("loadJob"), &RunPage::loadPlan);
  m_revision->setWordWrap(true);
  m_revision->setObjectName(QStringLiteral("revision"));
  m_revision->setMinimumHeight(2 * fontMetrics().lineSpacing()); // nothing jumps when it fills
  grid->addWidget(m_revision, 0, 0, 1, 5);
  grid->addWidget(new QLabel(tr("Panes")), 1, 0);
  grid->addWidget(m_fewer, 1, 1);
  grid->addWidget(m_panes, 1, 2);
  grid->addWidget(m_more, 1, 3);
  grid->addWidget(m_load, 1, 4);
  changePanes(0);
  return box;
}

QPushButton* RunPage::makeButton(const QString& text, const QString& name, void (RunPage::*act)()) const {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  connect(button, &QPushButton::clicked, this, act);
  return button;
}

void RunPage::makeCommands(QVBoxLayout& column) {
  m_back = makeButton(tr("◀ Step back"), QStringLiteral("stepBack"), &RunPage::stepBack);
  m_on = makeButton(tr("Step on ▶"), QStringLiteral("stepOn"), &RunPage::stepOn);
  auto* steps = new QHBoxLayout;
  steps->addWidget(m_back);
  steps->addWidget(m_on);
  column.addLayout(steps);
  m_resume = makeButton(tr("RESUME"), QStringLiteral("resume"), &RunPage::resumeRun);
  column.addWidget(m_resume);
  m_start->setObjectName(QStringLiteral("cycleStart"));
  m_start->setToolTip(tr("Keep it pressed until the ring is full."));
  connect(m_start, &HoldButton::held, &m_machine, &MachineLink::start);
  column.addWidget(m_start);
}

void RunPage::showPlan(const PlanPointer& plan) {
  m_plan = plan && plan->job.canBeGround() ? plan : nullptr;
  showDrawing();
  showAllowed();
}

// What the controller has, or else what it would get.
void RunPage::showDrawing() {
  const PlanPointer& shown = m_machine.loaded() ? m_machine.loaded() : m_plan;
  m_drawing->setPlan(shown);
  m_revision->setText(m_machine.loaded() && m_plan && m_plan != m_machine.loaded()
                          ? tr("Changed since it was loaded: load the job again for the next pane.")
                          : QString());
}

void RunPage::showAllowed() {
  const Allowed allowed = m_machine.allowed();
  m_load->setEnabled(allowed.load && m_plan);
  m_start->setEnabled(allowed.start);
  m_resume->setEnabled(allowed.resume);
  m_back->setEnabled(allowed.step);
  m_on->setEnabled(allowed.step);
  m_start->setText(m_machine.jobState() == control::JobState::Aborted ? tr("CYCLE START\nwhere it was broken off")
                                                                      : tr("CYCLE START"));
}

void RunPage::showReport() {
  if (!isVisible()) {
    return;
  }
  const control::Report& report = m_machine.report();
  const QLocale locale;
  const Eigen::Vector3d inMachine = report.measured + report.origin;
  for (int axis = 0; axis < control::kAxes; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    m_places[i]->setText(report.homed ? fixedText(report.measured[axis], kPlaceDecimals, locale) : QStringLiteral("–"));
    m_machinePlaces[i]->setText(report.homed ? fixedText(inMachine[axis], kPlaceDecimals, locale)
                                             : QStringLiteral("–"));
  }
  m_speed->setText(fixedText(report.velocity.norm(), 1, locale));
  m_override->setText(tr("%1 %").arg(std::lround(100 * report.overrideFactor)));
  m_services->setText(tr("Spindle: %1\nCoolant: %2\nVacuum: %3")
                          .arg(report.outputs.spindleSpeed == 0 ? tr("off")
                               : report.inputs.spindleAtSpeed   ? tr("at speed")
                                                                : tr("comes up to speed"),
                               report.inputs.coolantFlows ? tr("flows") : tr("off"),
                               report.inputs.vacuumHolds ? tr("holds the glass") : tr("off")));
  m_progress->setValue(m_machine.loaded() && report.runTick >= 0
                           ? static_cast<int>(std::lround(kProgressSteps * m_machine.progress()))
                           : 0);
  m_left->setText(report.runTick >= 0 ? tr("Time left: %1").arg(durationText(m_machine.timeLeft(), locale))
                                      : QStringLiteral(" "));
  if (report.homed) {
    const bool shows = m_machine.loaded() && m_machine.jobState() != control::JobState::Initialized;
    m_drawing->setWheel(LiveWheel{report.measured.head<2>(), shows ? report.place : program::JobPlace()});
  } else {
    m_drawing->setWheel(std::nullopt);
  }
}

void RunPage::loadPlan() {
  if (m_plan) {
    m_machine.load(m_plan, m_order);
  }
}

void RunPage::changeOverride(double by) {
  m_machine.setOverride(std::round(10 * (m_machine.report().overrideFactor + by)) / 10);
}

void RunPage::changePanes(int by) {
  m_order = std::clamp(m_order + by, 1, files::kMostPanes);
  m_panes->setText(QString::number(m_order));
  m_fewer->setEnabled(m_order > 1);
}

void RunPage::resumeRun() {
  m_machine.resume();
}

void RunPage::stepBack() {
  m_machine.step(-kStepLength);
}

void RunPage::stepOn() {
  m_machine.step(kStepLength);
}

} // namespace arris::ui
