#pragma once

#include "ui/presenters/diagnosis.h"

#include <QIcon>

namespace arris::ui {

/// The shape of a signal: a ring where it is off, a full disc where it is on, a triangle with ! where it is abnormal.
[[nodiscard]] QIcon signalIcon(SignalSign sign);

} // namespace arris::ui
