#pragma once

#include "ui/figures/profile.h"
#include "ui/figures/style.h"

#include <qcustomplot.h>

namespace arris::ui {

/// The corners behind the panels of a profile plot: a band for each zone through all panels, and above the first one
/// the number and angle of each corner, left out where there is no room.
class CornerBands : public QCPLayerable {
  Q_OBJECT

public:
  /// `top` and `bottom`: the first and the last panel.
  CornerBands(QCPAxisRect* top, FigureStyle style);

  void show(std::vector<CornerBand> bands, std::vector<ProfileLimits::Corner> corners, const QCPAxisRect* bottom);
  void select(int corner);

  /// Height above the first panel that the labels need, device units.
  [[nodiscard]] int labelHeight() const;

protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;

private:
  void drawBand(QCPPainter* painter, const CornerBand& band, double from, double to) const;
  void drawLabels(QCPPainter* painter) const;

  QCPAxisRect* m_top;
  const QCPAxisRect* m_bottom;
  FigureStyle m_style;
  std::vector<CornerBand> m_bands;
  std::vector<ProfileLimits::Corner> m_corners;
  int m_selected = 0;
};

} // namespace arris::ui
