#pragma once

#include <QWidget>

class QLabel;
class QToolButton;

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
  static QToolButton* makeStep(const QString& text, const QString& name, const QString& what);
  void showPlace();

  WheelWalk& m_walk;
  QToolButton* m_back;
  QLabel* m_place;
  QToolButton* m_on;
};

} // namespace arris::ui
