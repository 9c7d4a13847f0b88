#include "ui/pages/run_page.h"

#include "ui/pages/order_panel.h"
#include "ui/pages/resume_bar.h"
#include "ui/text/machine_texts.h"
#include "ui/text/quantities.h"
#include "ui/views/drawing_view.h"
#include "ui/widgets/hold_button.h"
#include "ui/widgets/sign_button.h"

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include <array>
#include <cmath>

namespace arris::ui {

namespace {

constexpr int kColumnWidth = 324; // px
constexpr int kProgressSteps = 1000;
constexpr double kOverrideStep = 0.1;
constexpr double kStepLength = 10; // mm
constexpr int kPlaceDecimals = 3;
constexpr int kPlaceSize = 22; // px

QLabel* makeFigure(const QString& name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  return label;
}

} // namespace

RunPage::RunPage(Planner& planner, MachineLink& machine, QWidget* parent)
    : QWidget(parent), m_planner(planner), m_machine(machine), m_drawing(new DrawingView),
      m_speed(makeFigure(QStringLiteral("speed"))), m_override(makeFigure(QStringLiteral("override"))),
      m_services(new QLabel), m_progress(new QProgressBar), m_left(new QLabel), m_start(new HoldButton(QString())) {
  auto* column = new QVBoxLayout;
  column->setSpacing(6);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(makePlaces());
  column->addWidget(makeOverride());
  m_drawing->setEmptyText(tr("Open a pattern on the page Job, or drop one here."));
  m_services->setObjectName(QStringLiteral("services"));
  column->addWidget(m_services);
  m_progress->setRange(0, kProgressSteps);
  m_progress->setTextVisible(false);
  m_progress->setAccessibleName(tr("Progress"));
  column->addWidget(m_progress);
  m_left->setObjectName(QStringLiteral("timeLeft"));
  column->addWidget(m_left);
  column->addStretch(1);
  makeCommands(*column);
  auto* main = new QVBoxLayout;
  main->setSpacing(4);
  main->addWidget(new ResumeBar(machine));
  main->addWidget(m_drawing, 1);
  main->addWidget(new OrderPanel(planner, machine));
  auto* side = new QWidget;
  side->setFixedWidth(kColumnWidth);
  side->setLayout(column);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 4);
  layout->addLayout(main, 1);
  layout->addWidget(side);
  connect(&planner, &Planner::planned, this, [this] {
    showDrawing();
    showAllowed();
  });
  connect(&machine, &MachineLink::changed, this, [this] {
    showDrawing();
    showAllowed();
  });
  connect(&machine, &MachineLink::reported, this, [this] {
    if (isVisible()) {
      showReport();
    }
  });
  connect(&machine.resumeOffer(), &ResumeOffer::ready, this, &RunPage::openTakenUp);
  showDrawing();
  showAllowed();
  showReport();
}

// To go: to the end of the line, arc or transition that the wheel is on, axis by axis, as machine operators know it.
QWidget* RunPage::makePlaces() {
  auto* box = new QWidget;
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(2);
  grid->addWidget(new QLabel(inShownUnits(tr("mm"))), 0, 0);
  const std::array<QString, 3> captions{tr("Table"), tr("Machine"), tr("To go")};
  for (int i = 0; i < 3; ++i) {
    auto* caption = new QLabel(captions.at(static_cast<std::size_t>(i)));
    grid->addWidget(caption, 0, i + 1, Qt::AlignRight);
    grid->setColumnStretch(i + 1, 1);
  }
  QFont large = font();
  large.setPixelSize(kPlaceSize);
  for (int axis = 0; axis < control::kAxes; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const QString name(QStringLiteral("XYZ").at(axis));
    auto* caption = new QLabel(name);
    m_places[i] = makeFigure(QStringLiteral("place") + name);
    m_machinePlaces[i] = makeFigure(QStringLiteral("machine") + name);
    m_toGo[i] = makeFigure(QStringLiteral("toGo") + name);
    caption->setFont(large);
    m_places[i]->setFont(large);
    grid->addWidget(caption, axis + 1, 0);
    grid->addWidget(m_places[i], axis + 1, 1);
    grid->addWidget(m_machinePlaces[i], axis + 1, 2);
    grid->addWidget(m_toGo[i], axis + 1, 3);
  }
  grid->addWidget(new QLabel(tr("Speed")), control::kAxes + 1, 0, 1, 2);
  grid->addWidget(m_speed, control::kAxes + 1, 1, 1, 3);
  auto* toGo = new QLabel(tr("To go: to the end of the line or arc that the wheel is on."));
  toGo->setWordWrap(true);
  grid->addWidget(toGo, control::kAxes + 2, 0, 1, 4);
  return box;
}

QWidget* RunPage::makeOverride() {
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(new QLabel(tr("Feed override")), 1);
  const auto add = [&](const QString& text, const QString& name, const QString& what, double by) {
    QPushButton* button = makeSignButton(text, name, what);
    connect(button, &QPushButton::clicked, this, [this, by] { changeOverride(by); });
    row->addWidget(button);
  };
  add(QStringLiteral("−"), QStringLiteral("overrideDown"), tr("Lower feed override"), -kOverrideStep);
  row->addWidget(m_override);
  add(QStringLiteral("+"), QStringLiteral("overrideUp"), tr("Higher feed override"), kOverrideStep);
  m_override->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("000 %")) + 4);
  return box;
}

QPushButton* RunPage::makeButton(const QString& text, const QString& name, void (RunPage::*act)()) const {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  connect(button, &QPushButton::clicked, this, act);
  return button;
}

void RunPage::makeCommands(QVBoxLayout& column) {
  m_back = makeButton(tr("◀ Back"), QStringLiteral("stepBack"), &RunPage::stepBack);
  m_on = makeButton(tr("Forward ▶"), QStringLiteral("stepOn"), &RunPage::stepOn);
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

// What the controller has, or else what it would get.
void RunPage::showDrawing() {
  const PlanPointer& plan = m_planner.plan();
  m_drawing->setPlan(m_machine.loaded() ? m_machine.loaded() : plan && plan->job.canBeGround() ? plan : nullptr);
}

void RunPage::showAllowed() {
  const Allowed allowed = m_machine.allowed();
  m_start->setEnabled(allowed.start);
  m_resume->setEnabled(allowed.resume);
  m_back->setEnabled(allowed.step);
  m_on->setEnabled(allowed.step);
  m_start->setText(m_machine.goesOnWithAPane() ? tr("CYCLE START\nwhere it was broken off")
                                               : tr("CYCLE START\nkeep pressed"));
}

void RunPage::showReport() {
  const control::Report& report = m_machine.report();
  showPlaces();
  m_override->setText(tr("%1 %").arg(std::lround(100 * report.overrideFactor)));
  m_services->setText(servicesText(report));
  showProgress();
  if (report.homed) {
    const bool shows = m_machine.loaded() && m_machine.jobState() != control::JobState::Initialized;
    m_drawing->setWheel(LiveWheel{report.measured.head<2>(), shows ? report.place : program::JobPlace()});
  } else {
    m_drawing->setWheel(std::nullopt);
  }
}

void RunPage::showPlaces() {
  const control::Report& report = m_machine.report();
  const QLocale locale;
  const QString unknown = QStringLiteral("–");
  const bool goes = report.homed && report.program != 0 && report.segment >= 0;
  const Eigen::Vector3d inMachine = report.measured + report.origin;
  const Eigen::Vector3d toGo = report.segmentEnd - report.measured;
  for (int axis = 0; axis < control::kAxes; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const auto text = [&](double value) { return fixedLengthText(value, kPlaceDecimals, locale); };
    m_places[i]->setText(report.homed ? text(report.measured[axis]) : unknown);
    m_machinePlaces[i]->setText(report.homed ? text(inMachine[axis]) : unknown);
    m_toGo[i]->setText(goes ? text(toGo[axis]) : unknown);
  }
  const auto feed = [&](double speed) { return fixedLengthText(60 * speed, 0, locale); };
  const double speed = report.velocity.norm();
  const bool backsOff = report.state == control::State::Held && speed > 0; // not with the programmed speed
  m_speed->setText(goes && !backsOff
                       ? inShownUnits(tr("%1 of %2 mm/min")).arg(feed(speed), feed(report.feed * report.overrideFactor))
                       : inShownUnits(tr("%1 mm/min")).arg(feed(speed)));
}

void RunPage::showProgress() {
  const QLocale locale;
  m_progress->setValue(static_cast<int>(std::lround(kProgressSteps * m_machine.progress())));
  m_left->setText(m_machine.loaded() ? inShownUnits(tr("Done: %1 %\nTo grind: %2 mm\nTime left: %3"))
                                           .arg(QString::number(std::floor(100 * m_machine.progress())),
                                                fixedLengthText(m_machine.wayLeft(), 1, locale),
                                                durationText(m_machine.timeLeft(), locale))
                                     : QStringLiteral(" \n \n "));
}

// The page Job shows what was taken up, so that it can be changed for the next pane.
void RunPage::openTakenUp(const TakenUp& job) {
  m_planner.setRecipe(job.point.recipe);
  m_planner.openPattern(job.plan->import->file);
}

void RunPage::changeOverride(double by) {
  m_machine.setOverride(std::round(10 * (m_machine.report().overrideFactor + by)) / 10);
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
