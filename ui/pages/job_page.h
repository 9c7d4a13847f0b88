#pragma once

#include "ui/presenters/planner.h"
#include "ui/presenters/recipe_desk.h"

#include <QWidget>

#include <vector>

class QButtonGroup;
class QLabel;
class QSplitter;
class QToolButton;

namespace arris::ui {

class BusyBar;
class BusyRow;
class DrawingView;
class FindingsPanel;
class ProfilePlot;
class RecipePanel;
class WheelWalk;

/// The paper's man–machine interface: values on the left, the drawing and the profile in the middle, what was found
/// beside or below. It shows what the planner yields and hands it what is typed; it keeps nothing of its own. The wheel
/// is moved along its path in the drawing.
class JobPage : public QWidget {
  Q_OBJECT

public:
  JobPage(Planner& planner, RecipeDesk& desk, WheelWalk& wheel, QWidget* parent = nullptr);

  /// Whether the values that a code can protect may be changed.
  void setEngineeringEnabled(bool enabled);

  [[nodiscard]] QSize minimumSizeHint() const override;

Q_SIGNALS:
  void openRequested();

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  QWidget* makeHeader();
  void makeBusyRow();
  void placeBusyRow();
  QWidget* makeViews();
  void connectPlanner();
  void connectViews();
  void connectWheel();
  void showPlan(const PlanPointer& plan);
  void showProfile(const CurvesPointer& curves);
  void showWheel();
  void showState();
  void showBusy(bool busy);
  [[nodiscard]] QString cancelledText() const;
  void selectCorner(int corner);
  void showProblem(const base::Problem& problem);
  void arrange();
  void showComplaint(const QString& complaint);
  void placeComplaint();

  Planner& m_planner;
  WheelWalk& m_wheel;
  PlanPointer m_plan;
  RecipePanel* m_recipe;
  DrawingView* m_drawing;
  ProfilePlot* m_profile;
  FindingsPanel* m_findings;
  QLabel* m_stateSign;
  QLabel* m_state;
  QLabel* m_complaint; // over the drawing, beside the field that it is about
  BusyBar* m_busy;
  BusyRow* m_busyRow; // over the drawing, so that nothing moves
  QButtonGroup* m_viewButtons;
  std::vector<QToolButton*> m_zooms;
  QSplitter* m_views;
  QSplitter* m_split;
  bool m_profileShown = false;
  bool m_beside = false; // the findings stand beside the views, not below them
};

} // namespace arris::ui
