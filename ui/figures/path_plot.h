#pragma once

#include "ui/figures/corner_labels.h"
#include "ui/figures/pointed_plot.h"
#include "ui/figures/profile_path.h"

#include <optional>
#include <vector>

namespace arris::ui {

/// The way of the wheel's centre in the plane, both axes in one scale: the glass, the planned way and the actual one
/// over it, the places of the method at a corner, and the wheel at the time that is pointed at; after the paper's
/// Figure 9a. The window shows it, figures are printed from it. Drag to pan, wheel or keys to zoom.
class PathPlot : public PointedPlot {
  Q_OBJECT

public:
  explicit PathPlot(const FigureStyle& style, QWidget* parent = nullptr);

  /// Shows up to two profiles, the second drawn thin over the first. `setting` is of the planned job; without one the
  /// glass is not known. `keepView` leaves the view as it is; else it shows everything.
  void setProfiles(const std::vector<ProfileCurves>& profiles, PathSetting setting, std::optional<double> wheelRadius,
                   bool keepView = false);

  /// Shows what a pass of a corner takes, with the places of its method.
  void showPass(const CornerPass& pass);
  void selectCorner(int corner) override; ///< names its places
  /// What the wheel goes along, and the table with what its centre reaches.
  void showWork() override;
  void showAll() override;
  /// The box and nothing round it but what the shape of the plot asks for.
  void showExactly(const QRectF& box); ///< mm
  /// What of the plane is shown, mm.
  [[nodiscard]] QRectF shownBox() const;

  /// Lays everything out for paper of this size.
  void prepareForPrint(const QSize& size);

protected:
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void zoomBy(double factor) override;
  void pointBeside(int steps) override;

private:
  void prepareAxis(QCPAxis& axis);
  void layOut();
  void showBox(const QRectF& box);
  void fitBox();
  void pointAt(const QPointF& place);
  void paintWay(QCPPainter& painter);
  void paintPath(QCPPainter& painter, const std::vector<PathPiece>& path, bool under) const;
  void paintTangents(QCPPainter& painter, const CornerPlaces& corner) const;
  void paintPlaces(QCPPainter& painter, const CornerPlaces& corner) const;
  void paintName(QCPPainter& painter, const PathPlace& place) const;
  void paintWheels(QCPPainter& painter) const;
  [[nodiscard]] const CornerPlaces* placesOfSelected() const;
  [[nodiscard]] QTransform toDevice() const;

  std::vector<ProfileCurves> m_profiles;
  std::vector<std::vector<PathPiece>> m_paths; // of each profile
  PathSetting m_setting;
  std::optional<CornerPlaces> m_fromProfile; // of the selected corner, where nothing is planned
  std::optional<double> m_wheelRadius;
  std::vector<CornerLabel> m_labels;
  int m_selected = 0;
  double m_step = 0.1;         // s, of an arrow
  double m_room = 0;           // round the box, of its size
  std::optional<QRectF> m_box; // mm, until somebody zooms or pans
};

} // namespace arris::ui
