#pragma once

class QAbstractScrollArea;
class QComboBox;
class QTableView;

namespace arris::ui {

/// Fingers scroll it.
void makeTouchable(QAbstractScrollArea& area);

/// Its list has rows for fingers.
void makeTouchable(QComboBox& box);

/// A table whose rows a finger in a glove chooses: one row at a time, tall rows, no grid.
void makeTouchTable(QTableView& table);

} // namespace arris::ui
