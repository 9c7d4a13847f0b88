#include "ui/pages/setup_page.h"

#include "ui/text/machine_texts.h"
#include "ui/text/quantities.h"

#include <QCoreApplication>
#include <QEvent>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>

#include <array>

namespace arris::ui {
namespace {

constexpr int kJogEvery = 50;   // ms: the controller ends a jog that is not confirmed for 0.2 s
constexpr int kJogButton = 84;  // px
constexpr double kJogSlow = 5;  // mm/s
constexpr double kJogFast = 50; // mm/s
constexpr int kSimulationColumns = 3;

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
    : QWidget(parent), m_machine(machine), m_guide(new QLabel), m_places(new QLabel) {
  m_guide->setObjectName(QStringLiteral("guide"));
  m_guide->setWordWrap(true);
  m_guide->setMinimumHeight(2 * fontMetrics().lineSpacing());
  m_places->setObjectName(QStringLiteral("places"));
  auto* layout = new QGridLayout(this);
  layout->addWidget(m_guide, 0, 0, 1, 2);
  layout->addWidget(makeDrives(), 1, 0);
  layout->addWidget(makeWays(), 2, 0);
  layout->addWidget(makeJog(), 1, 1, 2, 1);
  layout->addWidget(makeSimulation(), 3, 0, 1, 2);
  layout->setRowStretch(4, 1);
  layout->setColumnStretch(0, 1);
  layout->setColumnStretch(1, 1);
  m_jogAgain.setInterval(kJogEvery);
  connect(&m_jogAgain, &QTimer::timeout, this, [this] { m_machine.jogAt(m_jogVelocity); });
  connect(&machine, &MachineLink::changed, this, &SetupPage::showAllowed);
  connect(&machine, &MachineLink::reported, this, &SetupPage::showReport);
  showAllowed();
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
  auto* box = new QGroupBox(tr("Jog: moves as long as a button is pressed"));
  auto* grid = new QGridLayout(box);
  for (const JogDirection& jog : jogDirections()) {
    auto* button = new QPushButton(QString::fromUtf8(jog.text));
    button->setObjectName(QString::fromLatin1(jog.name));
    button->setMinimumSize(kJogButton, kJogButton);
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
  grid->addWidget(m_fast, 1, 1);
  grid->addWidget(m_places, 3, 0, 1, 4);
  grid->setRowStretch(4, 1);
  return box;
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
  auto* mend = new QPushButton(tr("Mend everything"));
  mend->setObjectName(QStringLiteral("mend"));
  connect(mend, &QPushButton::clicked, &m_machine, &MachineLink::clearFaults);
  put(mend);
  return box;
}

void SetupPage::beginJog(QPushButton& button, const Eigen::Vector3d& direction) {
  button.setFocus();
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
  for (QPushButton* button : m_jogs) {
    button->setEnabled(allowed.jog);
  }
  const control::Report& report = m_machine.report();
  m_guide->setText(allowed.acknowledge   ? tr("Read the alarm above, mend its cause, acknowledge it.")
                   : allowed.enable      ? tr("Next: switch the drives on.")
                   : !report.homed       ? tr("Next: home all axes, so that their places are known.")
                   : !m_machine.loaded() ? tr("Next: load the job on the page Run.")
                                         : tr("Ready for the cycle start on the page Run."));
}

void SetupPage::showReport() {
  const control::Report& report = m_machine.report();
  const Eigen::Vector3d& at = report.measured;
  const QLocale locale;
  m_places->setText(
      report.homed ? tr("X %1   Y %2   Z %3 mm")
                         .arg(fixedText(at.x(), 3, locale), fixedText(at.y(), 3, locale), fixedText(at.z(), 3, locale))
                   : tr("The places are not known yet."));
}

} // namespace arris::ui
