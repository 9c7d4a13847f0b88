#pragma once

#include "ui/presenters/planner.h"

#include <QWidget>

class QBoxLayout;
class QLabel;

namespace arris::ui {

class ReliefPlot;

/// The figures of one corner, why it is treated as it is, and how far the wheel lifts off its tip over time.
class CornerCard : public QWidget {
  Q_OBJECT

public:
  explicit CornerCard(QWidget* parent = nullptr);

  /// 0, or a corner that the plan does not have: says how to choose one.
  void show(const PlanPointer& plan, int corner);

  /// A corner of the job in two lines, where the card has no room.
  [[nodiscard]] static QString inShort(const job::Job& job, int corner);

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  struct Row {
    QString symbol; ///< rich text
    QString value;
  };

  [[nodiscard]] static QString title(const job::Job& job, const toolpath::Corner& corner);
  [[nodiscard]] static QString plannedText(const job::CornerResult& result, int speedDecimals, int timeDecimals);
  [[nodiscard]] static std::vector<Row> rowsOf(const job::Job& job, const toolpath::Corner& corner);

  QLabel* m_title;
  QLabel* m_reason;
  QLabel* m_figures;
  ReliefPlot* m_relief;
  QBoxLayout* m_beside; // the plot stands beside the figures where there is room, else below
};

} // namespace arris::ui
