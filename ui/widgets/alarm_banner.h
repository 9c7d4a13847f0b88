#pragma once

#include "ui/presenters/machine_link.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace arris::ui {

/// The line above every page: what the machine does, and the alarm that is active, with its remedy and a button to
/// acknowledge it. Its height never changes.
class AlarmBanner : public QWidget {
  Q_OBJECT

public:
  explicit AlarmBanner(MachineLink& machine, QWidget* parent = nullptr);

  /// Nothing is acknowledged while the screen is locked.
  void setLocked(bool locked);

private:
  void showState();

  MachineLink& m_machine;
  QLabel* m_state;
  QLabel* m_sign;
  QLabel* m_text;
  QPushButton* m_acknowledge;
  bool m_isLocked = false;
};

} // namespace arris::ui
