#pragma once

#include <QListWidget>

namespace arris::ui {

/// A list whose rows a finger can hit and pull; long texts wrap.
class TouchList : public QListWidget {
  Q_OBJECT

public:
  explicit TouchList(QWidget* parent = nullptr);
};

} // namespace arris::ui
