#pragma once

#include "ui/presenters/pattern_shelf.h"

#include <QWidget>

class QLabel;

namespace arris::ui {

class BusyBar;
class PatternView;
class TouchList;

/// What the shelf looks at: its drawing, name, size, unit and contours, and in words what is wrong with it.
class PatternPanel : public QWidget {
  Q_OBJECT

public:
  explicit PatternPanel(PatternShelf& shelf, QWidget* parent = nullptr);

private:
  void showLooked();
  void showFindings();
  [[nodiscard]] QString words() const;
  [[nodiscard]] QString facts() const;

  PatternShelf& m_shelf;
  QLabel* m_name = nullptr;
  BusyBar* m_busy = nullptr;
  PatternView* m_view = nullptr;
  QLabel* m_facts = nullptr;
  TouchList* m_findings = nullptr;
};

} // namespace arris::ui
