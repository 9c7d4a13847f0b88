#pragma once

#include "core/control/report.h"

#include <QLocale>
#include <QString>

#include <vector>

namespace arris::ui {

// The words of the controller in the language of the window.

[[nodiscard]] QString stateText(control::State state);
[[nodiscard]] QString jobStateText(control::JobState state);

/// What spindle, coolant and vacuum do, a line each.
[[nodiscard]] QString servicesText(const control::Report& report);

/// The fault in a sentence, with its axis and figure.
[[nodiscard]] QString faultText(const control::FaultReport& fault, const QLocale& locale);

/// Its axis and figure alone, with the unit: "X, 1.25 mm"; empty where it has neither.
[[nodiscard]] QString faultFigures(const control::FaultReport& fault, const QLocale& locale);
[[nodiscard]] QString causeText(control::Fault fault);
[[nodiscard]] QString remedyText(control::Fault fault);

/// The English sentences of the table of faults as the translators get them: text, cause and remedy of each.
[[nodiscard]] const std::vector<const char*>& faultSentences();

} // namespace arris::ui
