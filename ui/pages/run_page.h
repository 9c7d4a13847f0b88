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
  [[nodiscard]] QPushButton* makeButton(const QString& text, const QString& name, void (RunPage::*act)()) const;
  void makeCommands(QVBoxLayout& column);
  void showReport();
  void showPlaces();
  void showProgress();
  void showAllowed();
  void showDrawing();
  void openTakenUp(const TakenUp& job);
  void changeOverride(double by);
  void resumeRun();
  void stepBack();
  void stepOn();

  Planner& m_planner;
  MachineLink& m_machine;
  DrawingView* m_drawing;
  std::array<QLabel*, control::kAxes> m_places{}, m_machinePlaces{}, m_toGo{};
  QLabel* m_speed;
  QLabel* m_override;
  QLabel* m_services;
  QProgressBar* m_progress;
  QLabel* m_left;
  QPushButton* m_resume = nullptr;
  QPushButton* m_back = nullptr;
  QPushButton* m_on = nullptr;
  HoldButton* m_start;
};

} // namespace arris::ui
