#include "ui/pages/pattern_panel.h"

#include "ui/figures/finding_rows.h"
#include "ui/figures/preview_figure.h"
#include "ui/text/file_texts.h"
#include "ui/text/job_texts.h"
#include "ui/views/pattern_view.h"
#include "ui/widgets/busy_bar.h"
#include "ui/widgets/signs.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/touch_list.h"

#include <QLabel>
#include <QVBoxLayout>

namespace arris::ui {
namespace {

constexpr int kFindingsHeight = 3 * kTouch;

QLabel* makeWords(const QString& name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  return label;
}

} // namespace

PatternPanel::PatternPanel(PatternShelf& shelf, QWidget* parent) : QWidget(parent), m_shelf(shelf) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  m_name = makeWords(QStringLiteral("patternName"));
  QFont bold = font();
  bold.setBold(true);
  m_name->setFont(bold);
  m_busy = new BusyBar(tr("Reading"));
  m_view = new PatternView;
  m_view->setObjectName(QStringLiteral("patternView"));
  m_facts = makeWords(QStringLiteral("patternFacts"));
  m_facts->setMinimumHeight(2 * fontMetrics().lineSpacing()); // nothing jumps when it fills
  m_findings = new TouchList;
  m_findings->setObjectName(QStringLiteral("patternFindings"));
  m_findings->setSelectionMode(QAbstractItemView::NoSelection);
  m_findings->setAccessibleName(tr("Problems"));
  m_findings->setFixedHeight(kFindingsHeight);
  column->addWidget(m_name);
  column->addWidget(m_busy);
  column->addWidget(m_view, 1);
  column->addWidget(m_facts);
  column->addWidget(m_findings);
  connect(&shelf, &PatternShelf::lookChanged, this, &PatternPanel::showLooked);
  showLooked();
}

QString PatternPanel::words() const {
  const PreviewPointer& preview = m_shelf.preview();
  if (preview) {
    return preview->drawing.box.isEmpty() ? tr("There is nothing to show.") : QString();
  }
  return m_shelf.isReading() ? QString() : tr("Tap a pattern to see it.");
}

QString PatternPanel::facts() const {
  const PreviewPointer& preview = m_shelf.preview();
  if (!preview) {
    return {};
  }
  const QLocale locale;
  QStringList lines;
  QStringList second;
  if (preview->canBeOpened()) {
    const pattern::Pattern& pattern = preview->import->pattern;
    const QString unit = toQString(pattern::name(pattern.units));
    lines << previewTitle(pattern, QString(), locale, lengthUnit()).lines.front();
    second << (pattern.unitsFrom == pattern::UnitsFrom::Assumed ? tr("Unit of the drawing: %1, assumed").arg(unit)
                                                                : tr("Unit of the drawing: %1").arg(unit));
  }
  if (preview->bytes > 0) {
    const auto bytes = static_cast<qint64>(preview->bytes);
    second << locale.formattedDataSize(bytes, 0, QLocale::DataSizeSIFormat);
  }
  lines << second.join(QStringLiteral(" · "));
  return lines.join(QLatin1Char('\n'));
}

void PatternPanel::showLooked() {
  const PreviewPointer& preview = m_shelf.preview();
  m_busy->setVisible(m_shelf.isReading());
  m_name->setText(nameOfFile(m_shelf.looked()));
  m_view->showDrawing(preview ? preview->drawing : Drawing(), words());
  m_facts->setText(facts());
  showFindings();
}

void PatternPanel::showFindings() {
  m_findings->clear();
  if (const PreviewPointer& preview = m_shelf.preview()) {
    for (const FindingRow& row : findingRows(preview->drawing, QLocale(), lengthUnit())) {
      new QListWidgetItem(signIcon(row.severity), breakableAtFolders(row.words), m_findings);
    }
  }
  m_findings->setVisible(m_findings->count() > 0);
}

} // namespace arris::ui
