#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace arris::ui {

class WheelWalk;

/// Moves the wheel along the planned way by steps, and says where it is. Its height is always the same.
class WheelBar : public QWidget {
  Q_OBJECT

public:
  explicit WheelBar(WheelWalk& walk, QWidget* parent = nullptr);

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  static QPushButton* makeStep(const QString& text, const QString& name, const QString& what);
  void showPlace();

  WheelWalk& m_walk;
  QPushButton* m_back;
  QLabel* m_place;
  QPushButton* m_on;
};

} // namespace arris::ui
