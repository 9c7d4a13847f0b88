#include "ui/pages/pattern_dialog.h"

#include "ui/pages/pattern_panel.h"
#include "ui/text/file_texts.h"
#include "ui/text/problem_texts.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/touch_list.h"

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>

namespace arris::ui {
namespace {

constexpr QSize kLargestDialog(1240, 820); // px
constexpr int kDialogEdge = 6;
constexpr int kTitleBar = 36; // px, of the window manager
constexpr int kListsWidth = 336;
constexpr int kEntrySign = 24;

QRect within(const QWidget& place) {
  const QRect room(place.mapToGlobal(QPoint()), place.size());
  const QRect free = room.adjusted(kDialogEdge, kTitleBar, -kDialogEdge, -kDialogEdge);
  QRect dialog(QPoint(), free.size().boundedTo(kLargestDialog));
  dialog.moveCenter(free.center());
  return dialog;
}

} // namespace

PatternDialog::PatternDialog(PatternShelf& shelf, QWidget& place) : QDialog(&place), m_shelf(shelf) {
  setWindowTitle(tr("Open pattern"));
  setAttribute(Qt::WA_DeleteOnClose);
  setModal(false);
  auto* columns = new QHBoxLayout;
  columns->addWidget(makeLists());
  columns->addWidget(new PatternPanel(shelf), 1);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(8, 8, 8, 8);
  all->addLayout(columns, 1);
  all->addLayout(makeButtons());
  setGeometry(within(place));
  connectShelf();
  enableOpen();
  m_entries->setFocus();
}

// As it goes, the path loses the focus and would speak to what is no longer a dialog for patterns.
PatternDialog::~PatternDialog() {
  m_path->disconnect(this);
  m_entries->disconnect(this);
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
  m_message = new QLabel;
  m_message->setObjectName(QStringLiteral("patternsMessage"));
  m_message->setWordWrap(true);
  m_message->setTextFormat(Qt::PlainText);
  m_entries = new TouchList;
  m_entries->setObjectName(QStringLiteral("patterns"));
  m_entries->setAccessibleName(tr("Patterns"));
  column->addWidget(lists);
  column->addWidget(makeFolderRow());
  column->addWidget(m_message);
  column->addWidget(m_entries, 1);
  m_folderRow->setVisible(m_shelf.list() == ShelfList::Folder);
  connect(lists, &Segments::picked, this, [this](int list) { m_shelf.showList(static_cast<ShelfList>(list)); });
  connect(m_entries, &QListWidget::currentRowChanged, this, &PatternDialog::lookAtCurrent);
  connect(m_entries, &QListWidget::itemClicked, this, &PatternDialog::enterTapped);
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

QLayout* PatternDialog::makeButtons() {
  auto* cancel = new QPushButton(tr("Cancel"));
  cancel->setObjectName(QStringLiteral("patternCancel"));
  m_open = new QPushButton(tr("Open"));
  m_open->setObjectName(QStringLiteral("patternOpen"));
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
  connect(&m_shelf, &PatternShelf::lookChanged, this, &PatternDialog::enableOpen);
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
  auto* item = new QListWidgetItem(name + folder, m_entries);
  if (entry.isFolder) { // grey: colour is kept for what is abnormal or active
    item->setIcon(style()->standardIcon(QStyle::SP_DirIcon).pixmap(kEntrySign, QIcon::Disabled));
  }
}

// What is looked at stays so where the list has it; else the first entry is, as soon as the list is there.
void PatternDialog::showListing() {
  const ShelfListing& listing = m_shelf.listing();
  m_folderRow->setVisible(m_shelf.list() == ShelfList::Folder);
  m_path->setText(QString::fromStdString(listing.folder.string()));
  m_path->setToolTip(m_path->text());
  m_up->setEnabled(listing.folder.has_relative_path());
  fillEntries();
  const QString none = m_shelf.list() == ShelfList::Folder ? tr("Here are neither drawings (*.dxf) nor folders.")
                                                           : tr("No pattern was opened yet, or none is still there.");
  const QString message = listing.problem           ? problemText(*listing.problem, QLocale())
                          : listing.entries.empty() ? none
                                                    : QString();
  m_message->setText(breakableAtFolders(message));
  m_message->setVisible(!message.isEmpty());
  lookAtCurrent();
  if (m_path->hasFocus() && !listing.problem) {
    m_entries->setFocus(); // the path has led there
  }
}

void PatternDialog::fillEntries() {
  const ShelfListing& listing = m_shelf.listing();
  const std::filesystem::path& wanted = listing.chosen.empty() ? m_shelf.looked() : listing.chosen;
  const QSignalBlocker silent(m_entries);
  m_entries->clear();
  int chosen = 0;
  for (const ShelfEntry& entry : listing.entries) {
    addEntry(entry);
    chosen = entry.path == wanted ? m_entries->count() - 1 : chosen;
  }
  m_entries->setCurrentRow(chosen);
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
void PatternDialog::enterTapped() {
  const ShelfEntry* entry = current();
  const bool isSecond = m_sinceEntered.isValid() && !m_sinceEntered.hasExpired(QApplication::doubleClickInterval());
  if (entry != nullptr && entry->isFolder && !isSecond) {
    m_sinceEntered.start();
    m_shelf.showFolder(entry->path);
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
    m_shelf.showFolder(entry->path);
  } else if (entry->path == m_shelf.looked()) {
    m_shelf.choose();
  }
}

void PatternDialog::enableOpen() {
  const ShelfEntry* entry = current();
  m_open->setEnabled((entry != nullptr && entry->isFolder) || m_shelf.canChoose());
}

} // namespace arris::ui
