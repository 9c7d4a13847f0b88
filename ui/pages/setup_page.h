#pragma once

#include "ui/presenters/machine_link.h"

#include <QTimer>
#include <QWidget>

class QButtonGroup;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace arris::ui {

/// Switching on, homing, moving by hand; on further parts the table's origin with spindle and coolant by hand, and the
/// faults of the simulated machine, where it is simulated. Nothing here starts a job. A jog without steps is dead-man:
/// letting go, losing the focus, another page, a dialog, another window: each stops it.
class SetupPage : public QWidget {
  Q_OBJECT

public:
  explicit SetupPage(MachineLink& machine, QWidget* parent = nullptr);

protected:
  void hideEvent(QHideEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QWidget* makeParts();
  QWidget* makeMoving();
  QWidget* makeDrives();
  QWidget* makeWays();
  QWidget* makeJog();
  QWidget* makeJogSteps();
  QWidget* makeSimulation();
  QPushButton* add(QWidget& box, const QString& text, const QString& name, void (MachineLink::*act)());
  void beginJog(QPushButton& button, const Eigen::Vector3d& direction);
  void endJog();
  void chooseStep(int step);
  void showPart(int part);
  void showAllowed();
  [[nodiscard]] QString guide(const Allowed& allowed) const;
  void showJog(const Allowed& allowed);
  void showReport();

  MachineLink& m_machine;
  QLabel* m_guide;
  QLabel* m_places;
  QLabel* m_jogHint;
  QStackedWidget* m_parts;
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
