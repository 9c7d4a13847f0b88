#pragma once

#include <QPushButton>

namespace arris::ui {

/// A button with one sign on it; `what` it does is said by its tool tip and to a screen reader.
[[nodiscard]] QPushButton* makeSignButton(const QString& sign, const QString& name, const QString& what);

} // namespace arris::ui
