#pragma once

#include "core/base/problem.h"
#include "ui/text/quantities.h"

#include <QLocale>
#include <QString>

#include <vector>

namespace arris::ui {

/// The sentence of a problem in the language of the window, with its numbers in `locale`.
[[nodiscard]] QString problemText(const base::Problem& problem, const QLocale& locale, LengthUnit unit = lengthUnit());

/// Where it is, in brackets: "(line 12 of the file, at X 10.5, Y 20.0 mm)"; empty where no place is known. It does not
/// break between lines.
[[nodiscard]] QString placeText(const base::Problem& problem, const QLocale& locale, LengthUnit unit = lengthUnit());

/// "error", "warning", "note" in the language of the window.
[[nodiscard]] QString severityText(base::Severity severity);

/// The English templates as the translators get them, in the order of the codes; equal to core's table.
[[nodiscard]] const std::vector<const char*>& problemTemplates();

/// The English words that core fills into the templates, as the translators get them; {} is a figure or a name.
[[nodiscard]] const std::vector<const char*>& problemWords();

} // namespace arris::ui
