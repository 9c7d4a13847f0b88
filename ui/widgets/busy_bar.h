#pragma once

#include <QProgressBar>

namespace arris::ui {

/// Runs while something is under way whose end is not known; keeps its place while it is hidden.
class BusyBar : public QProgressBar {
  Q_OBJECT

public:
  /// `what` is under way, for those who cannot see it.
  explicit BusyBar(const QString& what, QWidget* parent = nullptr);
};

} // namespace arris::ui
