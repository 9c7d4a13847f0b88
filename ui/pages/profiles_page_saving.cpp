#include "ui/figures/job_sheet.h"
#include "ui/figures/path_plot.h"
#include "ui/figures/profile_figure.h"
#include "ui/figures/profile_plot.h"
#include "ui/pages/profiles_page.h"
#include "ui/text/file_texts.h"
#include "ui/widgets/file_question.h"

#include <QDateTime>
#include <QLocale>

// What is shown, saved as pictures, tables and job sheets.

namespace arris::ui {

void ProfilesPage::beginSaving() {
  m_problem.reset();
  m_saved.reset();
}

// What is seen, on paper.
Figure ProfilesPage::picture() const {
  const CurvesPointer opened = actual();
  QString heading = opened ? opened->name : m_plan ? nameOfFile(m_plan->import->file) : QString();
  const QString values = m_planned ? profileSubheading(m_plan->job) : QString();
  const std::optional<CornerPass> pass = m_sight.pass ? std::optional(m_passes.at(*m_sight.pass)) : std::nullopt;
  if (pass) {
    heading = tr("%1, corner %2").arg(heading).arg(pass->corner);
  }
  if (content() == ProfileSight::Path) {
    const PathSetting setting = m_planned ? m_plan->pathSetting : PathSetting();
    return pathFigure(m_shown, setting, heading, values,
                      {m_path->shownBox(), pass, m_sight.instant, limits().wheelRadius});
  }
  const PlotContent panels = content() == ProfileSight::Positions ? PlotContent::Positions : PlotContent::Speeds;
  return profileFigure(m_shown, limits(), heading, values, {panels, timePlot().shownTimes(), pass ? pass->corner : 0});
}

void ProfilesPage::savePicture(const std::filesystem::path& file) {
  beginSaving();
  if (const auto format = formatFor(file)) {
    m_files.save(file, [figure = recorded(picture(), *format), format = *format] { return encoded(figure, format); });
  } else {
    tellProblem(format.error());
  }
}

void ProfilesPage::saveProfile(const std::filesystem::path& file) {
  beginSaving();
  if (m_openIsRecord) {
    m_files.exportRecord(m_files.lastOpened()->file, file);
  } else if (m_planned) {
    m_files.exportPlanned(m_plan, file);
  }
}

void ProfilesPage::saveJobSheet(const std::filesystem::path& file) {
  beginSaving();
  if (m_plan) {
    const QLocale locale;
    const QString date = locale.toString(QDateTime::currentDateTime(), QLocale::ShortFormat);
    m_files.save(file, [plan = m_plan, date, locale] {
      return encodedPdf(jobSheet(plan->job, plan->drawing, nameOfFile(plan->import->file), date, locale));
    });
  }
}

void ProfilesPage::askWhere(const QString& title, const QStringList& filters,
                            const std::function<void(const std::filesystem::path&)>& save) {
  ui::askForFile(*this, {title, m_folder, filters, true}, [this, save](const std::filesystem::path& file) {
    m_folder = folderOfFile(file);
    save(file);
  });
}

void ProfilesPage::askForPicture() {
  askWhere(tr("Save picture"),
           {QStringLiteral("SVG (*.svg)"), QStringLiteral("PNG (*.png)"), QStringLiteral("PDF (*.pdf)")},
           [this](const std::filesystem::path& file) { savePicture(file); });
}

void ProfilesPage::askForProfile() {
  askWhere(m_openIsRecord ? tr("Save the profile of the run %1").arg(actual()->name) : tr("Save the planned profile"),
           {QStringLiteral("CSV (*.csv)")}, [this](const std::filesystem::path& file) { saveProfile(file); });
}

void ProfilesPage::askForJobSheet() {
  askWhere(tr("Save job sheet"), {QStringLiteral("PDF (*.pdf)")},
           [this](const std::filesystem::path& file) { saveJobSheet(file); });
}

} // namespace arris::ui
