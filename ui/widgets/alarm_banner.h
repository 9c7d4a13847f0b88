#pragma once

#include "ui/presenters/machine_link.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace arris::ui {

/// The line above every page: what the machine does, and the alarm that is active, with its remedy and a button to
/// acknowledge it; a tap on it leads to more. Its height never changes.
class AlarmBanner : public QWidget {
  Q_OBJECT

public:
  explicit AlarmBanner(MachineLink& machine, QWidget* parent = nullptr);

  /// Nothing is acknowledged while the screen is locked.
  void setLocked(bool locked);

Q_SIGNALS:
  void tapped();

protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

private:
  [[nodiscard]] QString axesText() const;
  void showState();

  MachineLink& m_machine;
  QLabel* m_state;
  QLabel* m_sign;
  QLabel* m_text;
  QPushButton* m_acknowledge;
  bool m_isLocked = false;
};

} // namespace arris::ui
