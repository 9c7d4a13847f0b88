#pragma once

#include <QWidget>

#include <utility>
#include <vector>

namespace arris::ui {

/// Buttons side by side of which one is chosen.
class Segments : public QWidget {
  Q_OBJECT

public:
  /// Object name and text of each.
  explicit Segments(const std::vector<std::pair<QString, QString>>& buttons, int chosen = 0, QWidget* parent = nullptr);

Q_SIGNALS:
  void picked(int index); ///< by a person
};

} // namespace arris::ui
