#pragma once

#include <QTableView>

namespace arris::ui {

class SignalModel;

/// A table of signals or figures: to be looked at, not tapped. It is as high as its rows.
class SignalTable : public QTableView {
  Q_OBJECT

public:
  explicit SignalTable(SignalModel& model, const QString& name, QWidget* parent = nullptr);

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;
};

} // namespace arris::ui
