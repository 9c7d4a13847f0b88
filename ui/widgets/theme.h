#pragma once

class QApplication;

namespace arris::ui {

/// A finger in a glove needs at least this, px.
inline constexpr int kTouch = 44;

/// Calm greys after ISA-101: colour is kept for what is abnormal or active; focus is a strong frame. Light or
/// dark as `appearance` says.
void applyTheme(QApplication& application);

} // namespace arris::ui
