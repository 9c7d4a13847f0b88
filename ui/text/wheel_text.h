#pragma once

#include "core/job/job.h"

#include <QLocale>
#include <QString>

namespace arris::ui {

/// Where the wheel is in a planned program of this duration (s), on two lines: its position and the time; the phase,
/// the speed and, at a corner, the distance to it. Lengths in the unit that is shown.
[[nodiscard]] QString wheelText(const job::Sample& sample, double duration, const QLocale& locale);

} // namespace arris::ui
