#pragma once

#include <QString>

class QApplication;

namespace arris::ui {

/// A finger in a glove needs at least this, px.
inline constexpr int kTouch = 44;

/// Calm greys after ISA-101: colour is kept for what is abnormal or active; focus is a strong frame. Light or
/// dark as `appearance` says.
void applyTheme(QApplication& application);

/// For as long as many widgets are made: they get the theme at the end, all at once. A style sheet is matched anew for
/// a widget and all within it whenever its parent changes, which is the greater part of the time to make a window.
class Unstyled {
public:
  Unstyled();
  ~Unstyled();
  Unstyled(const Unstyled&) = delete;
  Unstyled& operator=(const Unstyled&) = delete;

private:
  QString m_styleSheet;
};

} // namespace arris::ui
