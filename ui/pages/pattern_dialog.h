#pragma once

#include "ui/presenters/pattern_shelf.h"

#include <QDialog>
#include <QElapsedTimer>

class QLabel;
class QLineEdit;
class QPushButton;

namespace arris::ui {

class TouchList;

/// Asks for a pattern: lists at the left, what is tapped there at the right, before it is opened. The shelf says what
/// was chosen. The dialog is not modal and lies within `place`: FEED HOLD and STOP stay within reach and in sight.
class PatternDialog : public QDialog {
  Q_OBJECT

public:
  PatternDialog(PatternShelf& shelf, QWidget& place);
  ~PatternDialog() override;
  PatternDialog(const PatternDialog&) = delete;
  PatternDialog& operator=(const PatternDialog&) = delete;
  PatternDialog(PatternDialog&&) = delete;
  PatternDialog& operator=(PatternDialog&&) = delete;

private:
  QWidget* makeLists();
  QWidget* makeFolderRow();
  QLayout* makeButtons();
  void connectShelf();
  void addEntry(const ShelfEntry& entry);
  void showListing();
  void fillEntries();
  void enableOpen();
  void lookAtCurrent();
  void enterTapped();
  void goToTyped();
  void openCurrent();
  [[nodiscard]] const ShelfEntry* current() const;

  PatternShelf& m_shelf;
  QWidget* m_folderRow = nullptr;
  QPushButton* m_up = nullptr;
  QLineEdit* m_path = nullptr;
  QLabel* m_message = nullptr;
  TouchList* m_entries = nullptr;
  QPushButton* m_open = nullptr;
  QElapsedTimer m_sinceEntered; // a folder
};

} // namespace arris::ui
