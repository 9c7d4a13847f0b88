#pragma once

#include "ui/presenters/alarm_history.h"
#include "ui/presenters/back_ups.h"

namespace arris::ui {

/// What stays of the page Alarms while pages come and go.
struct AlarmsState {
  /// Refers to the machine.
  explicit AlarmsState(MachineLink& machine) : history(machine), backUps(machine) {}

  AlarmHistory history;
  BackUps backUps;
  int part = 0; ///< of the page that is shown
};

} // namespace arris::ui
