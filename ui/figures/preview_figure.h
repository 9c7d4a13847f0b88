#pragma once

#include "ui/figures/drawing.h"
#include "ui/figures/figure.h"
#include "ui/text/quantities.h"

#include <QLocale>
#include <QString>

namespace arris::ui {

/// What stands in the title block beside the drawing.
struct PreviewTitle {
  QString file;               ///< the pattern's name
  std::vector<QString> lines; ///< what was made of it
};

/// With numbers in `locale`; lengths in mm.
[[nodiscard]] PreviewTitle previewTitle(const job::Job& job, const QString& file, const QLocale& locale = QLocale::c());

/// Of a pattern that is not planned; lengths in `unit`.
[[nodiscard]] PreviewTitle previewTitle(const pattern::Pattern& pattern, const QString& file,
                                        const QLocale& locale = QLocale::c(), LengthUnit unit = LengthUnit::Millimetre);

/// A page of A4 with the drawing true to a round scale: glass, wheel path, transitions, numbered corners, leads,
/// direction, findings at their places and in words; axes in mm, legend and title block. Numbers with a decimal point.
/// After the paper's Figure 9a.
[[nodiscard]] Figure previewFigure(Drawing drawing, PreviewTitle title);

} // namespace arris::ui
