#pragma once

#include <QWidget>

#include <utility>
#include <vector>

class QButtonGroup;

namespace arris::ui {

/// Buttons side by side of which one is chosen.
class Segments : public QWidget {
  Q_OBJECT

public:
  /// Object name and text of each.
  explicit Segments(const std::vector<std::pair<QString, QString>>& buttons, int chosen = 0, QWidget* parent = nullptr);

  void choose(int index); ///< without saying so
  [[nodiscard]] int chosen() const;

Q_SIGNALS:
  void picked(int index); ///< by a person

private:
  QButtonGroup* m_group;
};

} // namespace arris::ui
