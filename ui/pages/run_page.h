#pragma once

#include "ui/presenters/machine_link.h"

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace arris::ui {

class DrawingView;
class HoldButton;

/// Grinding: the drawing with the wheel moving, places and speeds, override, and the commands of a run.
class RunPage : public QWidget {
  Q_OBJECT

public:
  RunPage(Planner& planner, MachineLink& machine, QWidget* parent = nullptr);

private:
  QWidget* makePlaces();
  QWidget* makeOverride();
  QWidget* makePanes();
  [[nodiscard]] QPushButton* makeButton(const QString& text, const QString& name, void (RunPage::*act)()) const;
  void makeCommands(QVBoxLayout& column);
  void showReport();
  void showAllowed();
  void showPlan(const PlanPointer& plan);
  void showDrawing();
  void loadPlan();
  void changeOverride(double by);
  void changePanes(int by);
  void resumeRun();
  void stepBack();
  void stepOn();

  MachineLink& m_machine;
  PlanPointer m_plan; // the latest that can be ground; null where the latest cannot
  DrawingView* m_drawing;
  std::array<QLabel*, control::kAxes> m_places{}, m_machinePlaces{};
  QLabel* m_speed;
  QLabel* m_override;
  QLabel* m_services;
  QLabel* m_panes;
  QLabel* m_revision;
  QProgressBar* m_progress;
  QLabel* m_left;
  QPushButton* m_load = nullptr;
  QPushButton* m_resume = nullptr;
  QPushButton* m_back = nullptr;
  QPushButton* m_on = nullptr;
  QPushButton* m_fewer = nullptr;
  QPushButton* m_more = nullptr;
  HoldButton* m_start;
  int m_order = 1;
};

} // namespace arris::ui
