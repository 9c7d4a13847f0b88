#include "ui/pages/pattern_dialog.h"

#include "ui/figures/finding_rows.h"
#include "ui/figures/preview_figure.h"
#include "ui/text/file_texts.h"
#include "ui/text/job_texts.h"
#include "ui/text/problem_texts.h"
#include "ui/views/pattern_view.h"
#include "ui/widgets/busy_bar.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/signs.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/touch_delegate.h"

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScroller>
#include <QStyle>
#include <QVBoxLayout>

#include <algorithm>

namespace arris::ui {
namespace {

constexpr QSize kLargestDialog(1240, 820); // px
constexpr int kDialogEdge = 6;
constexpr int kTitleBar = 36; // px, of the window manager
constexpr int kListsWidth = 336;
constexpr int kFindingsHeight = 3 * kTouch;
constexpr int kOpenHeight = 64;

QRect within(const QWidget& place) {
  const QRect room(place.mapToGlobal(QPoint()), place.size());
  const QRect free = room.adjusted(kDialogEdge, kTitleBar, -kDialogEdge, -kDialogEdge);
  QRect dialog(QPoint(), free.size().boundedTo(kLargestDialog));
  dialog.moveCenter(free.center());
  return dialog;
}

QListWidget* makeTouchList(const QString& name) {
  auto* list = new QListWidget;
  list->setObjectName(name);
  list->setWordWrap(true);
  list->setTextElideMode(Qt::ElideMiddle);
  list->setIconSize(QSize(24, 24));
  list->setResizeMode(QListView::Adjust);
  list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list->setItemDelegate(new TouchDelegate(list));
  QScroller::grabGesture(list->viewport(), QScroller::TouchGesture);
  return list;
}

QLabel* makeWords(const QString& name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  return label;
}

} // namespace

PatternDialog::PatternDialog(PatternShelf& shelf, QWidget& place) : QDialog(&place), m_shelf(shelf) {
  setWindowTitle(tr("Open pattern"));
  setAttribute(Qt::WA_DeleteOnClose);
  setModal(false);
  auto* columns = new QHBoxLayout;
  columns->addWidget(makeLists());
  columns->addWidget(makePreview(), 1);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(8, 8, 8, 8);
  all->addLayout(columns, 1);
  all->addLayout(makeButtons());
  setGeometry(within(place));
  connectShelf();
  showPreview();
  m_entries->setFocus();
}

QWidget* PatternDialog::makeLists() {
  auto* box = new QWidget;
  box->setFixedWidth(kListsWidth);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  auto* lists = new Segments({{QStringLiteral("patternsRecent"), tr("Recent")},
                              {QStringLiteral("patternsSamples"), tr("Samples")},
                              {QStringLiteral("patternsFolder"), tr("Folder")}},
                             static_cast<int>(m_shelf.list()));
  m_message = makeWords(QStringLiteral("patternsMessage"));
  m_entries = makeTouchList(QStringLiteral("patterns"));
  m_entries->setAccessibleName(tr("Patterns"));
  column->addWidget(lists);
  column->addWidget(makeFolderRow());
  column->addWidget(m_message);
  column->addWidget(m_entries, 1);
  connect(lists, &Segments::picked, this, [this](int list) { m_shelf.showList(static_cast<ShelfList>(list)); });
  connect(m_entries, &QListWidget::itemSelectionChanged, this, &PatternDialog::lookAtCurrent);
  connect(m_entries, &QListWidget::itemClicked, this, [this] {
    if (const ShelfEntry* entry = current(); entry != nullptr && entry->isFolder) {
      enter(entry->path);
    }
  });
  connect(m_entries, &QListWidget::itemDoubleClicked, this, &PatternDialog::openCurrent);
  return box;
}

QWidget* PatternDialog::makeFolderRow() {
  m_folderRow = new QWidget;
  auto* row = new QHBoxLayout(m_folderRow);
  row->setContentsMargins(0, 0, 0, 0);
  m_up = new QPushButton(tr("Up"));
  m_up->setObjectName(QStringLiteral("folderUp"));
  m_up->setShortcut(Qt::ALT | Qt::Key_Up);
  m_path = new QLineEdit;
  m_path->setObjectName(QStringLiteral("folderPath"));
  m_path->setAccessibleName(tr("Folder"));
  row->addWidget(m_up);
  row->addWidget(m_path, 1);
  connect(m_up, &QPushButton::clicked, &m_shelf, &PatternShelf::goUp);
  connect(m_path, &QLineEdit::editingFinished, this, &PatternDialog::goToTyped);
  return m_folderRow;
}

QWidget* PatternDialog::makePreview() {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
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
  m_findings = makeTouchList(QStringLiteral("patternFindings"));
  m_findings->setSelectionMode(QAbstractItemView::NoSelection);
  m_findings->setAccessibleName(tr("Problems"));
  m_findings->setFixedHeight(kFindingsHeight);
  column->addWidget(m_name);
  column->addWidget(m_busy);
  column->addWidget(m_view, 1);
  column->addWidget(m_facts);
  column->addWidget(m_findings);
  return box;
}

QLayout* PatternDialog::makeButtons() {
  auto* cancel = new QPushButton(tr("Cancel"));
  cancel->setObjectName(QStringLiteral("patternCancel"));
  cancel->setMinimumHeight(kOpenHeight);
  m_open = new QPushButton(tr("Open"));
  m_open->setObjectName(QStringLiteral("patternOpen"));
  m_open->setMinimumHeight(kOpenHeight);
  m_open->setDefault(true);
  auto* row = new QHBoxLayout;
  row->addWidget(cancel, 1);
  row->addWidget(m_open, 2);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(m_open, &QPushButton::clicked, this, &PatternDialog::openCurrent);
  return row;
}

void PatternDialog::connectShelf() {
  connect(&m_shelf, &PatternShelf::listed, this, &PatternDialog::showListing);
  connect(&m_shelf, &PatternShelf::lookChanged, this, &PatternDialog::showPreview);
  connect(&m_shelf, &PatternShelf::chosen, this, &QDialog::accept);
  connect(this, &QDialog::finished, &m_shelf, &PatternShelf::lookAway);
}

const ShelfEntry* PatternDialog::current() const {
  const int row = m_entries->currentRow();
  const bool isThere = row >= 0 && row < static_cast<int>(m_shelf.listing().entries.size());
  return isThere ? &m_shelf.listing().entries[static_cast<std::size_t>(row)] : nullptr;
}

void PatternDialog::addEntry(const ShelfEntry& entry) {
  const QString name = nameOfFile(entry.path);
  const bool isFromAnywhere = m_shelf.list() == ShelfList::Recent;
  const QString folder = isFromAnywhere ? QLatin1Char('\n') + breakableAtFolders(folderOfFile(entry.path)) : QString();
  const auto icon = entry.isFolder ? QStyle::SP_DirIcon : QStyle::SP_FileIcon;
  new QListWidgetItem(style()->standardIcon(icon), name + folder, m_entries);
}

// The first entry is looked at as soon as the list is there.
void PatternDialog::showListing() {
  const ShelfListing& listing = m_shelf.listing();
  m_folderRow->setVisible(m_shelf.list() == ShelfList::Folder);
  m_path->setText(QString::fromStdString(listing.folder.string()));
  m_path->setToolTip(m_path->text());
  m_up->setEnabled(listing.folder.has_relative_path());
  m_entries->clear();
  int chosen = 0;
  for (const ShelfEntry& entry : listing.entries) {
    addEntry(entry);
    chosen = entry.path == listing.chosen ? m_entries->count() - 1 : chosen;
  }
  const QString none = m_shelf.list() == ShelfList::Folder ? tr("Here are neither drawings (*.dxf) nor folders.")
                                                           : tr("No pattern was opened yet, or none is still there.");
  const QString message = listing.problem           ? problemText(*listing.problem, QLocale())
                          : listing.entries.empty() ? none
                                                    : QString();
  m_message->setText(breakableAtFolders(message));
  m_message->setVisible(!message.isEmpty());
  m_entries->setCurrentRow(chosen);
  lookAtCurrent();
}

void PatternDialog::lookAtCurrent() {
  const ShelfEntry* entry = current();
  if (entry == nullptr || entry->isFolder) {
    m_shelf.lookAway();
  } else if (entry->path != m_shelf.looked()) {
    m_shelf.look(entry->path);
  }
}

// The second tap of a double one would meet a folder of the next list.
void PatternDialog::enter(const std::filesystem::path& folder) {
  if (!m_sinceEntered.isValid() || m_sinceEntered.hasExpired(QApplication::doubleClickInterval())) {
    m_sinceEntered.start();
    m_shelf.showFolder(folder);
  }
}

void PatternDialog::goToTyped() {
  const QString typed = m_path->text().trimmed();
  if (!typed.isEmpty() && typed.toStdString() != m_shelf.listing().folder) {
    m_shelf.showFolder(typed.toStdString());
  }
}

// Enter in the line of the path is for the path alone.
void PatternDialog::openCurrent() {
  const ShelfEntry* entry = current();
  if (m_path->hasFocus() || entry == nullptr) {
    return;
  }
  if (entry->isFolder) {
    enter(entry->path);
  } else if (entry->path == m_shelf.looked()) {
    m_shelf.choose();
  }
}

QString PatternDialog::words() const {
  const PreviewPointer& preview = m_shelf.preview();
  if (preview) {
    return preview->isTooLarge              ? tr("The file is large: it is read when it is opened.")
           : preview->drawing.box.isEmpty() ? tr("There is nothing to show.")
                                            : QString();
  }
  return m_shelf.isReading() ? QString() : tr("Tap a pattern to see it.");
}

QString PatternDialog::facts() const {
  const PreviewPointer& preview = m_shelf.preview();
  if (!preview) {
    return {};
  }
  const QLocale locale;
  QStringList lines;
  QStringList second;
  if (preview->canBeOpened() && preview->import) {
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

void PatternDialog::showPreview() {
  const PreviewPointer& preview = m_shelf.preview();
  m_busy->setVisible(m_shelf.isReading());
  m_name->setText(nameOfFile(m_shelf.looked()));
  m_view->show(preview ? preview->drawing : Drawing(), words());
  m_facts->setText(facts());
  showFindings();
  const ShelfEntry* entry = current();
  m_open->setEnabled((entry != nullptr && entry->isFolder) || m_shelf.canChoose());
}

void PatternDialog::showFindings() {
  m_findings->clear();
  if (const PreviewPointer& preview = m_shelf.preview()) {
    for (const FindingRow& row : findingRows(preview->drawing, QLocale(), lengthUnit())) {
      new QListWidgetItem(signIcon(row.severity), breakableAtFolders(row.words), m_findings);
    }
  }
  m_findings->setVisible(m_findings->count() > 0);
}

} // namespace arris::ui
