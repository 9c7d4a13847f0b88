#include "ui/pages/setup_page.h"

#include "ui/pages/by_hand_panel.h"
#include "ui/text/machine_texts.h"
#include "ui/text/problem_texts.h"
#include "ui/text/quantities.h"
#include "ui/widgets/segments.h"

#include <QButtonGroup>
#include <QCoreApplication>
#include <QEvent>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>

#include <array>

namespace arris::ui {
namespace {

constexpr int kJogEvery = 50;   // ms: the controller ends a jog that is not confirmed for 0.2 s
constexpr int kJogButton = 76;  // px
constexpr double kJogSlow = 5;  // mm/s
constexpr double kJogFast = 50; // mm/s
constexpr int kSimulationColumns = 2;

// The steps of a jog, in the unit that lengths are shown in; the first is none.
constexpr std::array<double, 5> kMillimetreSteps{0, 0.01, 0.1, 1, 10};
constexpr std::array<double, 5> kInchSteps{0, 0.001, 0.01, 0.1, 1};

// mm
double jogStep(int step) {
  const auto i = static_cast<std::size_t>(step);
  return lengthFromShown(lengthUnit() == LengthUnit::Inch ? kInchSteps.at(i) : kMillimetreSteps.at(i));
}

QString jogStepText(int step) {
  return lengthText(jogStep(step), 2, QLocale());
}

struct JogDirection {
  const char* name;
  const char* text;
  Eigen::Vector3d direction;
  int row, column;
};

// As they lie on the table, seen from above; Z beside them. ISO 841: the wheel relative to the glass, +Z away from it.
const std::array<JogDirection, 6>& jogDirections() {
  static const std::array<JogDirection, 6> kDirections = {{{"jogYPlus", "Y +", {0, 1, 0}, 0, 1},
                                                           {"jogXMinus", "X −", {-1, 0, 0}, 1, 0},
                                                           {"jogXPlus", "X +", {1, 0, 0}, 1, 2},
                                                           {"jogYMinus", "Y −", {0, -1, 0}, 2, 1},
                                                           {"jogZPlus", "Z +", {0, 0, 1}, 0, 3},
                                                           {"jogZMinus", "Z −", {0, 0, -1}, 2, 3}}};
  return kDirections;
}

struct SimulatedFaultText {
  control::SimulatedFault fault;
  const char* text;
};

constexpr std::array<SimulatedFaultText, 6> kSimulatedFaults = {
    {{control::SimulatedFault::CoolantLoss, QT_TRANSLATE_NOOP("SimulatedFault", "Coolant fails")},
     {control::SimulatedFault::SpindleLoss, QT_TRANSLATE_NOOP("SimulatedFault", "Spindle fails")},
     {control::SimulatedFault::VacuumLoss, QT_TRANSLATE_NOOP("SimulatedFault", "Vacuum fails")},
     {control::SimulatedFault::DriveFault, QT_TRANSLATE_NOOP("SimulatedFault", "Drive of X fails")},
     {control::SimulatedFault::StuckAxis, QT_TRANSLATE_NOOP("SimulatedFault", "X is stuck")},
     {control::SimulatedFault::EmergencyStop, QT_TRANSLATE_NOOP("SimulatedFault", "Emergency stop trips")}}};

} // namespace

SetupPage::SetupPage(MachineLink& machine, QWidget* parent)
    : QWidget(parent), m_machine(machine), m_guide(new QLabel), m_places(new QLabel), m_jogHint(new QLabel),
      m_parts(new QStackedWidget) {
  m_guide->setObjectName(QStringLiteral("guide"));
  m_guide->setWordWrap(true);
  m_guide->setMinimumHeight(2 * fontMetrics().lineSpacing());
  m_places->setObjectName(QStringLiteral("places"));
  m_jogHint->setObjectName(QStringLiteral("jogHint"));
  m_jogHint->setWordWrap(true);
  m_jogHint->setMinimumHeight(2 * fontMetrics().lineSpacing()); // nothing jumps
  m_parts->addWidget(makeMoving());
  m_parts->addWidget(new ByHandPanel(machine));
  if (machine.isSimulated()) {
    m_parts->addWidget(makeSimulation());
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 4);
  layout->addWidget(m_guide);
  layout->addWidget(makeParts());
  layout->addWidget(m_parts, 1);
  m_jogAgain.setInterval(kJogEvery);
  connect(&m_jogAgain, &QTimer::timeout, this, [this] { m_machine.jogAt(m_jogVelocity); });
  connect(&machine, &MachineLink::changed, this, &SetupPage::showAllowed);
  connect(&machine, &MachineLink::reported, this, &SetupPage::showReport);
  showPart(machine.setupChoices().part);
  showAllowed();
  showReport();
}

// Which part of the page is shown.
QWidget* SetupPage::makeParts() {
  std::vector<std::pair<QString, QString>> names{{QStringLiteral("showMoving"), tr("Drives and jog")},
                                                 {QStringLiteral("showByHand"), tr("Origin and by hand")}};
  if (m_machine.isSimulated()) {
    names.emplace_back(QStringLiteral("showSimulation"), tr("Simulation"));
  }
  auto* parts = new Segments(names, m_machine.setupChoices().part);
  connect(parts, &Segments::picked, this, &SetupPage::showPart);
  return parts;
}

void SetupPage::showPart(int part) {
  endJog();
  m_machine.setupChoices().part = part;
  m_parts->setCurrentIndex(part);
}

QWidget* SetupPage::makeMoving() {
  auto* part = new QWidget;
  auto* grid = new QGridLayout(part);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->addWidget(makeDrives(), 0, 0);
  grid->addWidget(makeWays(), 1, 0);
  grid->addWidget(makeJog(), 0, 1, 3, 1);
  grid->setRowStretch(2, 1);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
  return part;
}

QPushButton* SetupPage::add(QWidget& box, const QString& text, const QString& name, void (MachineLink::*act)()) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  connect(button, &QPushButton::clicked, &m_machine, act);
  box.layout()->addWidget(button);
  return button;
}

QWidget* SetupPage::makeDrives() {
  auto* box = new QGroupBox(tr("Drives"));
  new QVBoxLayout(box);
  m_enable = add(*box, tr("Switch drives on"), QStringLiteral("enable"), &MachineLink::enable);
  m_home = add(*box, tr("Home all axes"), QStringLiteral("home"), &MachineLink::home);
  m_disable = add(*box, tr("Switch drives off"), QStringLiteral("disable"), &MachineLink::disable);
  return box;
}

QWidget* SetupPage::makeWays() {
  auto* box = new QGroupBox(tr("Ways above the glass"));
  new QVBoxLayout(box);
  m_trace = add(*box, tr("Trace the outline at height"), QStringLiteral("trace"), &MachineLink::trace);
  m_park = add(*box, tr("Go to the park position"), QStringLiteral("park"), &MachineLink::park);
  return box;
}

QWidget* SetupPage::makeJog() {
  auto* box = new QGroupBox(tr("Jog"));
  auto* grid = new QGridLayout(box);
  for (const JogDirection& jog : jogDirections()) {
    auto* button = new QPushButton(QString::fromUtf8(jog.text));
    button->setObjectName(QString::fromLatin1(jog.name));
    button->setStyleSheet(QStringLiteral("min-width: %1px; min-height: %1px").arg(kJogButton)); // of the theme's sheet
    button->installEventFilter(this);
    connect(button, &QPushButton::pressed, this,
            [this, button, direction = jog.direction] { beginJog(*button, direction); });
    connect(button, &QPushButton::released, this, &SetupPage::endJog);
    grid->addWidget(button, jog.row, jog.column);
    m_jogs.push_back(button);
  }
  m_fast = new QPushButton(tr("Fast"));
  m_fast->setObjectName(QStringLiteral("jogFast"));
  m_fast->setCheckable(true);
  m_fast->setChecked(m_machine.setupChoices().jogFast);
  connect(m_fast, &QPushButton::toggled, this, [this](bool on) { m_machine.setupChoices().jogFast = on; });
  grid->addWidget(m_fast, 1, 1);
  grid->addWidget(makeJogSteps(), 3, 0, 1, 4);
  grid->addWidget(m_jogHint, 4, 0, 1, 4);
  grid->addWidget(m_places, 5, 0, 1, 4);
  grid->setRowStretch(6, 1);
  return box;
}

QWidget* SetupPage::makeJogSteps() {
  auto* steps = new QWidget;
  auto* grid = new QGridLayout(steps);
  grid->setContentsMargins(0, 0, 0, 0);
  auto* group = new QButtonGroup(this);
  for (int i = 0; i < static_cast<int>(kMillimetreSteps.size()); ++i) {
    auto* button = new QPushButton(i == 0 ? tr("Continuous") : jogStepText(i));
    button->setObjectName(QStringLiteral("jogStep%1").arg(i));
    button->setAccessibleName(i == 0 ? tr("Jog as long as a button is pressed")
                                     : inShownUnits(tr("Jog by %1 mm")).arg(jogStepText(i)));
    button->setCheckable(true);
    button->setChecked(i == m_machine.setupChoices().jogStep);
    group->addButton(button, i);
    i == 0 ? grid->addWidget(button, 0, 0, 1, -1) : grid->addWidget(button, 1, i - 1);
  }
  grid->addWidget(new QLabel(inShownUnits(tr("mm"))), 1, static_cast<int>(kMillimetreSteps.size()) - 1);
  connect(group, &QButtonGroup::idClicked, this, &SetupPage::chooseStep);
  return steps;
}

void SetupPage::chooseStep(int step) {
  endJog();
  m_machine.setupChoices().jogStep = step;
  showAllowed();
}

// The simulated machine can be made to fail, to learn what to do then.
QWidget* SetupPage::makeSimulation() {
  auto* box = new QGroupBox(tr("Simulated machine"));
  box->setObjectName(QStringLiteral("simulation"));
  auto* grid = new QGridLayout(box);
  int place = 0;
  const auto put = [&](QPushButton* button) {
    grid->addWidget(button, place / kSimulationColumns, place % kSimulationColumns);
    ++place;
  };
  for (const SimulatedFaultText& row : kSimulatedFaults) {
    auto* button = new QPushButton(QCoreApplication::translate("SimulatedFault", row.text));
    button->setObjectName(QStringLiteral("inject%1").arg(static_cast<int>(row.fault)));
    connect(button, &QPushButton::clicked, this, [this, fault = row.fault] { m_machine.inject(fault); });
    put(button);
  }
  auto* mend = new QPushButton(tr("Clear all faults"));
  mend->setObjectName(QStringLiteral("mend"));
  connect(mend, &QPushButton::clicked, &m_machine, &MachineLink::clearFaults);
  put(mend);
  auto* jogEnable = new QPushButton(tr("Jog enable on the panel held"));
  jogEnable->setObjectName(QStringLiteral("simulateJogEnable"));
  jogEnable->setCheckable(true);
  jogEnable->setChecked(m_machine.report().inputs.jogEnable);
  connect(jogEnable, &QPushButton::toggled, this,
          [this](bool down) { m_machine.press(control::Button::JogEnable, down); });
  put(jogEnable);
  grid->setRowStretch(grid->rowCount(), 1);
  return box;
}

void SetupPage::beginJog(QPushButton& button, const Eigen::Vector3d& direction) {
  button.setFocus();
  if (const int step = m_machine.setupChoices().jogStep; step > 0) {
    m_machine.jogBy(jogStep(step) * direction);
    return;
  }
  m_jogVelocity = (m_fast->isChecked() ? kJogFast : kJogSlow) * direction;
  m_machine.jogAt(m_jogVelocity);
  m_jogAgain.start();
}

void SetupPage::endJog() {
  if (m_jogAgain.isActive()) {
    m_jogAgain.stop();
    m_machine.jogAt({0, 0, 0});
  }
}

bool SetupPage::eventFilter(QObject* watched, QEvent* event) {
  const QEvent::Type type = event->type();
  if (type == QEvent::FocusOut || type == QEvent::TouchCancel || type == QEvent::WindowDeactivate) {
    endJog();
  }
  return QWidget::eventFilter(watched, event);
}

void SetupPage::hideEvent(QHideEvent* event) {
  endJog();
  QWidget::hideEvent(event);
}

void SetupPage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::ActivationChange) {
    endJog();
  }
  QWidget::changeEvent(event);
}

void SetupPage::showAllowed() {
  const Allowed allowed = m_machine.allowed();
  m_enable->setEnabled(allowed.enable);
  m_disable->setEnabled(allowed.disable);
  m_home->setEnabled(allowed.home);
  m_trace->setEnabled(allowed.move && m_machine.loaded());
  m_park->setEnabled(allowed.move);
  showJog(allowed);
  m_guide->setText(guide(allowed));
}

// What comes next, or what is in the way of it.
QString SetupPage::guide(const Allowed& allowed) const {
  using control::State;
  const State state = m_machine.report().state;
  if (const auto& absence = m_machine.absence()) {
    return tr("Nothing can be moved: %1").arg(problemText(*absence, QLocale()));
  }
  if (allowed.acknowledge || state == State::Faulted || state == State::EmergencyStop) {
    return tr("Read the alarm above, remove its cause, acknowledge it.");
  }
  if (allowed.enable) {
    return tr("Next: switch the drives on.");
  }
  if (allowed.resume) {
    return tr("Held: go on with RESUME on the page Run, or STOP.");
  }
  if (allowed.stop && state != State::Jogging) {
    return tr("Something moves: until it ends nothing is moved from here.");
  }
  if (!m_machine.report().homed) {
    return tr("Next: home all axes, so that their places are known.");
  }
  return m_machine.loaded() ? tr("Ready for the cycle start on the page Run.")
                            : tr("Next: load the job on the page Run.");
}

void SetupPage::showJog(const Allowed& allowed) {
  for (QPushButton* button : m_jogs) {
    button->setEnabled(allowed.jog);
  }
  const int step = m_machine.setupChoices().jogStep;
  m_fast->setEnabled(step == 0);
  m_jogHint->setText(!m_machine.report().mayJog
                         ? tr("Press the jog enable on the panel and keep it pressed: without it no axis is jogged.")
                     : step == 0 ? tr("An axis moves as long as its button is pressed.")
                                 : inShownUnits(tr("Each press moves an axis by %1 mm.")).arg(jogStepText(step)));
}

void SetupPage::showReport() {
  if (!isVisible()) {
    return;
  }
  showJog(m_machine.allowed());
  const control::Report& report = m_machine.report();
  const Eigen::Vector3d& at = report.measured;
  const QLocale locale;
  m_places->setText(report.homed ? inShownUnits(tr("X %1   Y %2   Z %3 mm"))
                                       .arg(fixedLengthText(at.x(), 3, locale), fixedLengthText(at.y(), 3, locale),
                                            fixedLengthText(at.z(), 3, locale))
                                 : tr("The places are not known yet."));
}

} // namespace arris::ui
