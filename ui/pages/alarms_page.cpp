#include "ui/pages/alarms_page.h"

#include "ui/pages/alarm_panel.h"
#include "ui/pages/back_up_panel.h"
#include "ui/pages/diagnosis_panel.h"
#include "ui/widgets/segments.h"

#include <QStackedWidget>
#include <QVBoxLayout>

namespace arris::ui {

AlarmsPage::AlarmsPage(MachineLink& machine, AlarmsState& state, QWidget* parent)
    : QWidget(parent), m_state(state), m_parts(new QStackedWidget) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 4);
  layout->setSpacing(6);
  auto* which = new Segments({{QStringLiteral("showAlarms"), tr("Alarms")},
                              {QStringLiteral("showSignals"), tr("Inputs and outputs")},
                              {QStringLiteral("showBackUp"), tr("Counters and back-up")}},
                             state.part);
  layout->addWidget(which);
  layout->addWidget(m_parts, 1);
  m_parts->addWidget(new AlarmPanel(machine, state.history));
  m_parts->addWidget(new DiagnosisPanel(machine));
  m_parts->addWidget(new BackUpPanel(machine, state.backUps));
  m_parts->setCurrentIndex(state.part);
  connect(which, &Segments::picked, this, [this](int part) {
    m_state.part = part;
    m_parts->setCurrentIndex(part);
  });
}

} // namespace arris::ui
