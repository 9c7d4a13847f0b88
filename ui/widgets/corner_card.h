#pragma once

#include "ui/presenters/planner.h"

#include <QWidget>

class QFormLayout;
class QLabel;

namespace arris::ui {

/// The figures of one corner and why it is treated as it is.
class CornerCard : public QWidget {
  Q_OBJECT

public:
  explicit CornerCard(QWidget* parent = nullptr);

  /// 0, or a corner that the plan does not have: says how to choose one.
  void show(const PlanPointer& plan, int corner);

private:
  struct Row {
    QString symbol; ///< rich text
    QString value;
  };

  [[nodiscard]] static std::vector<Row> rowsOf(const job::Job& job, const toolpath::Corner& corner);

  QLabel* m_title;
  QLabel* m_reason;
  QLabel* m_figures;
};

} // namespace arris::ui
