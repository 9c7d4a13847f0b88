#include "ui/pages/help_page.h"

#include "ui/widgets/touch_table.h"

#include <QCoreApplication>
#include <QFile>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextDocument>

namespace arris::ui {
namespace {

constexpr int kManualMargin = 16; // px

// Each page has a heading of the second level, in this order.
constexpr const char* kParts[] = {"pageJob", "pageSetup", "pageRun", "pageProfiles", "pageAlarms", "pageSettings"};

// As it is written (Markdown); in English where the window speaks a language without one.
QString manualIn(const QString& language) {
  for (const QString& name : {language, QStringLiteral("en")}) {
    QFile file(QStringLiteral(":/manual/%1.md").arg(name));
    if (file.open(QIODevice::ReadOnly)) {
      return QString::fromUtf8(file.readAll());
    }
  }
  return {};
}

} // namespace

HelpPage::HelpPage(QWidget* parent) : QTextBrowser(parent) {
  setObjectName(QStringLiteral("manual"));
  setAccessibleName(tr("Manual"));
  setFrameShape(QFrame::NoFrame);
  document()->setDocumentMargin(kManualMargin);
  //: The language that the manual is read in: that of this translation, "de" or "zh_CN".
  setMarkdown(manualIn(tr("en", "language of the manual")));
  makeTouchable(*this);
}

void HelpPage::showPart(const QString& page) {
  m_part = page;
  scrollToPart();
}

void HelpPage::showEvent(QShowEvent* event) {
  QTextBrowser::showEvent(event);
  scrollToPart();
}

void HelpPage::scrollToPart() {
  int part = -1;
  for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
    part += block.blockFormat().headingLevel() == 2 ? 1 : 0;
    if (part >= 0 && part < static_cast<int>(std::size(kParts)) && m_part == QLatin1String(kParts[part])) {
      QTextCursor cursor(block);
      setTextCursor(cursor);
      verticalScrollBar()->setValue(verticalScrollBar()->value() + cursorRect(cursor).top());
      return;
    }
  }
}

} // namespace arris::ui
