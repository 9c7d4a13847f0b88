#pragma once

#include "ui/figures/pointed_plot.h"
#include "ui/figures/profile.h"

#include <optional>
#include <utility>
#include <vector>

namespace arris::ui {

class CornerBands;

/// Of a plot in the window, px per unit of figures.
inline constexpr double kPlotUnit = 0.5;

/// Velocity and acceleration of X and Y, path speed and distance to the corner (or the positions of X and Y) over one
/// time axis, with the corners marked and the limits drawn; after the paper's Figures 8, 9 and 10. The window shows it,
/// figures are printed from it.
class ProfilePlot : public PointedPlot {
  Q_OBJECT

public:
  explicit ProfilePlot(const FigureStyle& style, PlotContent content = PlotContent::Speeds, QWidget* parent = nullptr);

  /// Shows up to two profiles, the second drawn thin over the first (planned, then actual). `keepView` leaves the time
  /// range as it is; else the work fills the plot.
  void setProfiles(const std::vector<ProfileCurves>& profiles, const ProfileLimits& limits, bool keepView = false);

  void selectCorner(int corner) override;
  void showTimes(double from, double to);
  /// The times that are shown, s.
  [[nodiscard]] std::pair<double, double> shownTimes() const;
  void showWork() override;
  void showAll() override;
  void markInstant(std::optional<double> time) override; ///< a line through all panels

  /// What a panel shows and its unit on a second line, in words or as a symbol.
  [[nodiscard]] static QString axisTitle(Panel panel, bool inWords, LengthUnit unit);

  /// Reduces the curves to what shows on paper at this size, and cuts off what lies outside the panels.
  void prepareForPrint(const QSize& size);

protected:
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void zoomBy(double factor) override;
  void pointBeside(int steps) override;

private:
  [[nodiscard]] static QString titleInMillimetres(Panel panel, bool inWords);

  struct PanelParts {
    Panel kind = Panel::SpeedX;
    QCPAxisRect* rect = nullptr;
    std::vector<QCPGraph*> graphs; ///< curves and limits
    std::vector<QCPGraph*> curves;
    std::optional<double> travel; ///< mm: where that of the axis ends whose position is shown
    QCPItemStraightLine* instant = nullptr;
  };

  void addPanel(Panel panel, bool last);
  void addInstant(PanelParts& panel);
  void pointAt(double x);
  void addSpace(int row, int height);
  void setTimes(const std::vector<ProfileCurves>& profiles);
  void addCurve(PanelParts& panel, const ProfileCurves& curves, bool under);
  void setRange(const PanelParts& panel, const std::vector<ProfileCurves>& profiles, const ProfileLimits& limits) const;
  void fitPositions();
  void addLimits(PanelParts& panel, const ProfileLimits& limits);
  void addTravelLimits(PanelParts& panel);
  void addLimitLine(PanelParts& panel, double value, const QString& words);
  void addReliefLimits(PanelParts& panel, const ProfileLimits& limits);
  void setAxisTitles(double height);
  [[nodiscard]] QColor colorOf(Panel panel) const;

  std::vector<PanelParts> m_panels; // from top to bottom
  CornerBands* m_bands = nullptr;
  std::vector<CornerBand> m_cornerBands;
  double m_workFrom = 0, m_workTo = 1, m_duration = 1;
};

// For the legend.
[[nodiscard]] QPen overlaidPen(const FigureStyle& style, const QColor& color); ///< of the profile underneath
[[nodiscard]] QPen limitPen(const FigureStyle& style);
[[nodiscard]] QPen reliefPen(const FigureStyle& style);

} // namespace arris::ui
