#pragma once

#include "ui/presenters/machine_link.h"

#include <QTimer>
#include <QWidget>

class QLabel;
class QPushButton;

namespace arris::ui {

/// Switching on, homing, moving by hand. Nothing here starts a job. Jog is dead-man: letting go, losing the focus,
/// another page, a dialog, another window: each stops it.
class SetupPage : public QWidget {
  Q_OBJECT

public:
  explicit SetupPage(MachineLink& machine, QWidget* parent = nullptr);

protected:
  void hideEvent(QHideEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QWidget* makeDrives();
  QWidget* makeJog();
  QWidget* makeWays();
  QWidget* makeSimulation();
  QPushButton* add(QWidget& box, const QString& text, const QString& name, void (MachineLink::*act)());
  void beginJog(QPushButton& button, const Eigen::Vector3d& direction);
  void endJog();
  void showAllowed();
  void showReport();

  MachineLink& m_machine;
  QLabel* m_guide;
  QLabel* m_places;
  QPushButton* m_enable = nullptr;
  QPushButton* m_disable = nullptr;
  QPushButton* m_home = nullptr;
  QPushButton* m_trace = nullptr;
  QPushButton* m_park = nullptr;
  QPushButton* m_fast = nullptr;
  std::vector<QPushButton*> m_jogs;
  Eigen::Vector3d m_jogVelocity{0, 0, 0};
  QTimer m_jogAgain;
};

} // namespace arris::ui
