#pragma once

#include "ui/presenters/alarm_history.h"

#include <QLocale>
#include <QString>

namespace arris::ui {

// An alarm of the log in the language of the window. Of a code that this Arris does not know it has the English of the
// log.

/// "active", "acknowledged", "not acknowledged".
[[nodiscard]] QString alarmStateText(const PastAlarm& past);

/// Day and time of the day, on two lines.
[[nodiscard]] QString alarmTimeText(const files::Alarm& alarm, const QLocale& locale);

/// Its code and, on a second line, axis and figure where it has them.
[[nodiscard]] QString alarmCodeText(const files::Alarm& alarm, const QLocale& locale);

/// The sentence.
[[nodiscard]] QString alarmText(const files::Alarm& alarm, const QLocale& locale);

/// All of it: what happened, its cause, what to do, when, and the record of the run that has more.
[[nodiscard]] QString alarmInFull(const PastAlarm& past, const QLocale& locale);

} // namespace arris::ui
