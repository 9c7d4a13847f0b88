#pragma once

class QAbstractScrollArea;
class QTableView;

namespace arris::ui {

/// Fingers scroll it.
void makeTouchable(QAbstractScrollArea& area);

/// A table whose rows a finger in a glove chooses: one row at a time, tall rows, no grid.
void makeTouchTable(QTableView& table);

} // namespace arris::ui
