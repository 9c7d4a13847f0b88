#pragma once

#include "core/toolpath/toolpath.h"
#include "ui/figures/style.h"

#include <qcustomplot.h>

namespace arris::ui {

/// L(t), mm: from the wheel's centre to the corner S, `time` s after A on a transition with the radius `wheelRadius`,
/// mm. Source: the paper's Eq. (9) with Eq. (2) and (14), factored.
[[nodiscard]] double reliefDistance(const toolpath::Corner& corner, double wheelRadius, double time);

/// The distance L(t) of one corner over the time of its transition, from A to C, against R, where the wheel touches the
/// tip, and R + d, where it is clear of the glass before the tip too; the relief margin between R + d and the greatest
/// distance is marked. After the paper's Figure 10 and Eq. (10) to (12).
class ReliefPlot : public QCustomPlot {
  Q_OBJECT

public:
  explicit ReliefPlot(FigureStyle style, QWidget* parent = nullptr);

  /// For corners with a transition.
  void showCorner(const toolpath::Corner& corner, double wheelRadius);

private:
  void addMargin();
  void showLimits(double wheelRadius, double reliefRadius);
  void showMargin(const toolpath::Corner& corner, double reliefRadius);
  [[nodiscard]] double shown(double millimetres) const;

  FigureStyle m_style;
  QCPGraph* m_curve;
  QCPGraph* m_radius;
  QCPGraph* m_relief;
  QCPItemLine* m_margin;
  QCPItemText* m_marginText;
};

} // namespace arris::ui
