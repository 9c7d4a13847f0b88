#pragma once

#include "ui/presenters/pattern_shelf.h"

#include <QDialog>
#include <QElapsedTimer>

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace arris::ui {

class BusyBar;
class PatternView;

/// Asks for a pattern: lists at the left, what is tapped there at the right, before it is opened. The shelf says what
/// was chosen. The dialog is not modal and lies within `place`: FEED HOLD and STOP stay within reach and in sight.
class PatternDialog : public QDialog {
  Q_OBJECT

public:
  PatternDialog(PatternShelf& shelf, QWidget& place);

private:
  QWidget* makeLists();
  QWidget* makeFolderRow();
  QWidget* makePreview();
  QLayout* makeButtons();
  void connectShelf();
  void addEntry(const ShelfEntry& entry);
  void showListing();
  void showPreview();
  void showFindings();
  void lookAtCurrent();
  void enter(const std::filesystem::path& folder);
  void goToTyped();
  void openCurrent();
  [[nodiscard]] const ShelfEntry* current() const;
  [[nodiscard]] QString words() const;
  [[nodiscard]] QString facts() const;

  PatternShelf& m_shelf;
  QWidget* m_folderRow = nullptr;
  QPushButton* m_up = nullptr;
  QLineEdit* m_path = nullptr;
  QLabel* m_message = nullptr;
  QListWidget* m_entries = nullptr;
  BusyBar* m_busy = nullptr;
  PatternView* m_view = nullptr;
  QLabel* m_name = nullptr;
  QLabel* m_facts = nullptr;
  QListWidget* m_findings = nullptr;
  QPushButton* m_open = nullptr;
  QElapsedTimer m_sinceEntered; // a folder
};

} // namespace arris::ui
