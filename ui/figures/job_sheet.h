#pragma once

#include "core/job/job.h"
#include "ui/figures/drawing.h"
#include "ui/figures/figure.h"

#include <QLocale>
#include <QString>

#include <vector>

namespace arris::ui {

/// The sheet that goes with a job: the drawing with its numbered corners, recipe and machine, every corner, times by
/// phase, problems and repairs in words; as many standing pages of A4 as that takes. `file` is the pattern's name,
/// `date` stands beside it. Numbers in `locale`; lengths in mm, whatever the window shows.
[[nodiscard]] std::vector<Figure> jobSheet(const job::Job& job, const Drawing& drawing, const QString& file,
                                           const QString& date, const QLocale& locale);

} // namespace arris::ui
