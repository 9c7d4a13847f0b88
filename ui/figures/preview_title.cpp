#include "ui/figures/preview_figure.h"
#include "ui/text/quantities.h"

#include <QCoreApplication>

#include <algorithm>

namespace arris::ui {
namespace {

QString sizeText(const geometry::Box& box, const QLocale& locale, LengthUnit unit = LengthUnit::Millimetre) {
  return inShownUnits(QStringLiteral("%1 × %2 mm"), unit)
      .arg(lengthText(box.sizes().x(), 1, locale, unit), lengthText(box.sizes().y(), 1, locale, unit));
}

geometry::Box paneBox(const std::vector<pattern::Contour>& contours) {
  geometry::Box box;
  for (const pattern::Contour& contour : contours) {
    box.extend(geometry::bounds(contour.curves));
  }
  return box;
}

qsizetype countOf(const std::vector<pattern::Contour>& contours, pattern::ContourKind kind) {
  return std::count_if(contours.begin(), contours.end(),
                       [kind](const pattern::Contour& contour) { return contour.kind == kind; });
}

class TitleLines {
  Q_DECLARE_TR_FUNCTIONS(PreviewPage)

public:
  static QString contours(const std::vector<pattern::Contour>& contours);
  static QString pane(const job::Job& job, const QLocale& locale);
  static QString parts(const job::Job& job);
  static QString values(const job::Job& job, const QLocale& locale);
  static QString times(const job::Job& job, const QLocale& locale);
  static QString imported(const pattern::Pattern& pattern, const QLocale& locale, LengthUnit unit);
};

QString TitleLines::contours(const std::vector<pattern::Contour>& contours) {
  if (contours.size() < 2) {
    return tr("Contours: %1").arg(contours.size());
  }
  return tr("Contours: %1 (outlines %2, cut-outs %3)")
      .arg(contours.size())
      .arg(countOf(contours, pattern::ContourKind::Outline))
      .arg(countOf(contours, pattern::ContourKind::CutOut));
}

QString TitleLines::pane(const job::Job& job, const QLocale& locale) {
  const geometry::Box box = paneBox(job.contours);
  if (box.isEmpty()) {
    return tr("No contour");
  }
  QString line =
      tr("Pane %1, lower left at X %2, Y %3")
          .arg(sizeText(box, locale), numberText(box.min().x(), 1, locale), numberText(box.min().y(), 1, locale));
  line += QStringLiteral(" · ") + tr("glass %1 mm").arg(numberText(job.recipe.thickness, 2, locale));
  return line;
}

QString TitleLines::parts(const job::Job& job) {
  return contours(job.contours) + QStringLiteral(" · ") + tr("corners: %1").arg(job.toolpath.corners.size());
}

QString TitleLines::values(const job::Job& job, const QLocale& locale) {
  const recipe::Recipe& r = job.recipe;
  return tr("Wheel R %1 mm · depth %2 mm · feed %3 mm/min · acceleration X %4, Y %5 mm/s²")
      .arg(numberText(r.wheelRadius, 3, locale), numberText(r.depth, 3, locale), numberText(r.feed, 1, locale),
           numberText(r.accelX, 2, locale), numberText(r.accelY, 2, locale));
}

QString TitleLines::times(const job::Job& job, const QLocale& locale) {
  if (job.pieces.empty()) {
    return tr("Cannot be ground");
  }
  double length = 0;
  for (const toolpath::Chain& chain : job.toolpath.chains) {
    for (const toolpath::PathSegment& segment : chain.segments) {
      length += geometry::arcLength(segment.shape);
    }
  }
  return tr("Grinding %1 · whole program %2 · wheel path %3 mm")
      .arg(durationText(job.working, locale), durationText(job.duration, locale), numberText(length, 1, locale));
}

QString TitleLines::imported(const pattern::Pattern& pattern, const QLocale& locale, LengthUnit unit) {
  const geometry::Box box = paneBox(pattern.contours);
  QString line = contours(pattern.contours);
  if (!box.isEmpty()) {
    line += QStringLiteral(" · ") + sizeText(box, locale, unit);
  }
  if (!pattern.loose.empty()) {
    line += QStringLiteral(" · ") + tr("pieces in no contour: %1").arg(pattern.loose.size());
  }
  return line;
}

} // namespace

PreviewTitle previewTitle(const job::Job& job, const QString& file, const QLocale& locale) {
  return {file,
          {TitleLines::pane(job, locale), TitleLines::parts(job), TitleLines::values(job, locale),
           TitleLines::times(job, locale)}};
}

PreviewTitle previewTitle(const pattern::Pattern& pattern, const QString& file, const QLocale& locale,
                          LengthUnit unit) {
  return {file, {TitleLines::imported(pattern, locale, unit)}};
}

} // namespace arris::ui
