#include "ui/widgets/alarm_banner.h"

#include "ui/text/machine_texts.h"
#include "ui/text/problem_texts.h"
#include "ui/widgets/signs.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>

namespace arris::ui {
namespace {

constexpr int kBannerHeight = 76; // px: four lines of text
constexpr int kBannerSign = 24;   // px
constexpr int kStateWidth = 304;  // px

} // namespace

AlarmBanner::AlarmBanner(MachineLink& machine, QWidget* parent)
    : QWidget(parent), m_machine(machine), m_state(new QLabel), m_sign(new QLabel), m_text(new QLabel),
      m_acknowledge(new QPushButton(tr("Acknowledge"))) {
  setObjectName(QStringLiteral("banner"));
  setFixedHeight(kBannerHeight);
  m_state->setObjectName(QStringLiteral("machineState"));
  m_state->setFixedWidth(kStateWidth);
  m_text->setObjectName(QStringLiteral("alarmText"));
  m_text->setWordWrap(true);
  m_sign->setFixedSize(kBannerSign, kBannerSign);
  m_acknowledge->setObjectName(QStringLiteral("acknowledge"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 2, 8, 2);
  layout->addWidget(m_state);
  layout->addWidget(m_sign);
  layout->addWidget(m_text, 1);
  layout->addWidget(m_acknowledge);
  connect(m_acknowledge, &QPushButton::clicked, &machine, &MachineLink::acknowledge);
  connect(&machine, &MachineLink::changed, this, &AlarmBanner::showState);
  connect(&machine, &MachineLink::alarmRaised, this, &AlarmBanner::showState);
  showState();
}

void AlarmBanner::setLocked(bool locked) {
  m_isLocked = locked;
  showState();
}

// Also on its texts, which let a tap through.
void AlarmBanner::mousePressEvent(QMouseEvent* event) {
  event->accept();
}

void AlarmBanner::mouseReleaseEvent(QMouseEvent* event) {
  if (rect().contains(event->position().toPoint())) {
    Q_EMIT tapped();
  }
}

// Nobody takes the one machine for the other.
QString AlarmBanner::axesText() const {
  return m_machine.isSimulated() ? tr("Simulated axes")
         : m_machine.absence()   ? tr("LinuxCNC: no axes")
                                 : tr("Axes through LinuxCNC");
}

void AlarmBanner::showState() {
  const control::JobState job = m_machine.jobState();
  const QString panes = m_machine.loaded()
                            ? tr("%1 of %2 panes good").arg(m_machine.order().good()).arg(m_machine.order().wanted())
                            : tr("No job is loaded");
  m_state->setText(stateText(m_machine.report().state) + QLatin1Char('\n') +
                   (m_machine.loaded() ? jobStateText(job) + QStringLiteral(" · ") + panes : panes) +
                   QLatin1Char('\n') + axesText());
  const Alarm* active = nullptr;
  int others = -1;
  for (const Alarm& alarm : m_machine.alarms()) { // the first one says what came first
    active = active == nullptr && alarm.isActive ? &alarm : active;
    others += alarm.isActive ? 1 : 0;
  }
  const auto& complaint = m_machine.complaint();
  const QString more = others > 0 ? tr(" (+%1 on the page Alarms)").arg(others) : QString();
  m_text->setText(active != nullptr
                      ? faultText(active->fault, QLocale()) + more + QLatin1Char('\n') + remedyText(active->fault.fault)
                  : complaint ? problemText(*complaint, QLocale())
                              : QString());
  const bool tells = active != nullptr || complaint.has_value();
  m_sign->setPixmap(tells ? signIcon(base::Severity::Error).pixmap(kBannerSign) : QPixmap());
  m_acknowledge->setEnabled(m_machine.allowed().acknowledge && !m_isLocked);
}

} // namespace arris::ui
