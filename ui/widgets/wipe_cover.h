#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QTimer>

namespace arris::ui {

/// Lies over the pages while the screen is wiped, for 30 s, and says how long it still does: nothing under it can be
/// touched.
class WipeCover : public QLabel {
  Q_OBJECT

public:
  explicit WipeCover(QWidget* parent);

  static constexpr int kLasts = 30; ///< s

  void begin();

Q_SIGNALS:
  void ended();

private:
  void tick();

  QElapsedTimer m_since;
  QTimer m_timer;
};

} // namespace arris::ui
