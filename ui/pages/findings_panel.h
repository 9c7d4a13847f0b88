#pragma once

#include "ui/presenters/planner.h"

#include <QTabWidget>

class QBoxLayout;
class QListView;
class QTableView;

namespace arris::ui {

class CornerCard;
class CornerModel;
class ProblemModel;
class TimeModel;

/// What was found and planned: corners with the figures of the chosen one, problems in words, times by phase.
class FindingsPanel : public QTabWidget {
  Q_OBJECT

public:
  explicit FindingsPanel(QWidget* parent = nullptr);

  void setPlan(const PlanPointer& plan);

  /// Shows a corner in table and card; 0 for none.
  void selectCorner(int corner);

  /// Shows a problem of the plan in the list.
  void selectProblem(const base::Problem& problem);

  [[nodiscard]] int selectedCorner() const {
    return m_selected;
  }

  /// Where the panel stands below the drawing it is wide, where beside it tall.
  void setWide(bool wide);

  /// Brings the figures of the corner that is selected to the front, where they have no room beside the table.
  void showCard();

Q_SIGNALS:
  void cornerChosen(int corner);
  void problemChosen(const arris::base::Problem& problem);

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  void placeCard();
  QWidget* makeCorners();
  QWidget* makeProblems();
  QWidget* makeTimes();
  void showProblemCount();

  PlanPointer m_plan;
  int m_selected = 0;
  CornerModel* m_cornerModel;
  ProblemModel* m_problemModel;
  TimeModel* m_timeModel;
  QTableView* m_corners = nullptr;
  QListView* m_problems = nullptr;
  QBoxLayout* m_cornersLayout = nullptr;
  CornerCard* m_card = nullptr;
  QWidget* m_cardArea = nullptr;
  bool m_wide = true;
};

} // namespace arris::ui
