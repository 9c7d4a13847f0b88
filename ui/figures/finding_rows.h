#pragma once

#include "ui/figures/drawing.h"
#include "ui/text/quantities.h"

#include <QLocale>
#include <QString>

#include <vector>

namespace arris::ui {

/// A line of words about findings of one code.
struct FindingRow {
  base::Severity severity = base::Severity::Note;
  QString words; ///< the first of them with its place, and how many more there are
};

/// What was found and repaired, one row for each code, errors first, so that none is crowded out by another.
[[nodiscard]] std::vector<FindingRow> findingRows(const Drawing& drawing, const QLocale& locale,
                                                  LengthUnit unit = LengthUnit::Millimetre);

} // namespace arris::ui
