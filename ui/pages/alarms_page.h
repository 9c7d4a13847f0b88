#pragma once

#include "ui/presenters/alarms_state.h"

#include <QWidget>

class QStackedWidget;

namespace arris::ui {

/// Alarms and diagnosis in three parts: alarms of now and before, inputs and outputs as they are, and the machine's
/// counters with back-ups.
class AlarmsPage : public QWidget {
  Q_OBJECT

public:
  AlarmsPage(MachineLink& machine, AlarmsState& state, QWidget* parent = nullptr);

private:
  AlarmsState& m_state;
  QStackedWidget* m_parts;
};

} // namespace arris::ui
