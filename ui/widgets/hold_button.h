#pragma once

#include <QElapsedTimer>
#include <QPushButton>
#include <QTimer>

namespace arris::ui {

/// A button that acts only when it has been held down for 0.7 s; a ring fills meanwhile. Letting go, losing the focus
/// or being disabled before lets nothing happen.
class HoldButton : public QPushButton {
  Q_OBJECT

public:
  explicit HoldButton(const QString& text, QWidget* parent = nullptr);

  static constexpr int kHoldFor = 700; ///< ms

Q_SIGNALS:
  void held();

protected:
  void paintEvent(QPaintEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void begin();
  void tick();
  void giveUp();

  QElapsedTimer m_since;
  QTimer m_timer;
};

} // namespace arris::ui
