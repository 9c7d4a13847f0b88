#pragma once

#include "ui/figures/corner_labels.h"
#include "ui/figures/profile_path.h"
#include "ui/figures/style.h"

#include <qcustomplot.h>

#include <optional>
#include <vector>

namespace arris::ui {

/// The way of the wheel's centre in the plane, both axes in one scale: the glass, the planned way and the actual one
/// over it, the places of the method at a corner, and the wheel at the time that is pointed at; after the paper's
/// Figure 9a. The window shows it, figures are printed from it. Drag to pan, wheel or keys to zoom; with the focus,
/// arrows move the time that is pointed at, plus and minus zoom, and Home shows everything.
class PathPlot : public QCustomPlot {
  Q_OBJECT

public:
  explicit PathPlot(const FigureStyle& style, QWidget* parent = nullptr);

  /// Shows up to two profiles, the second drawn thin over the first. `setting` is of the planned job; without one the
  /// glass is not known. `keepView` leaves the view as it is; else it shows everything.
  void setProfiles(const std::vector<ProfileCurves>& profiles, PathSetting setting, std::optional<double> wheelRadius,
                   bool keepView = false);

  /// Shows what a pass of a corner takes, with the places of its method.
  void showPass(const CornerPass& pass);
  /// Names a corner's places, without moving to it; 0 for none.
  void selectCorner(int corner);
  /// What the wheel goes along, and the table with what its centre reaches.
  void showWork();
  void showAll();
  /// The box and nothing round it but what the shape of the plot asks for.
  void showExactly(const QRectF& box); ///< mm
  /// What of the plane is shown, mm.
  [[nodiscard]] QRectF shownBox() const;
  void zoomIn();
  void zoomOut();

  /// The wheel at this time; none without one.
  void markInstant(std::optional<double> time);

  /// Lays everything out for paper of this size.
  void prepareForPrint(const QSize& size);

Q_SIGNALS:
  /// A corner's number was tapped.
  void cornerTapped(int corner);
  /// A place of the way was tapped, or arrows moved along it: its time, s.
  void instantPointed(double time);

protected:
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  void refresh();
  void prepareAxis(QCPAxis& axis);
  void layOut();
  void showBox(const QRectF& box);
  void fitBox();
  void zoomBy(double factor);
  void pointBeside(int steps);
  void pointAt(const QPointF& place);
  void paintWay(QCPPainter& painter);
  void paintPath(QCPPainter& painter, const std::vector<PathPiece>& path, bool under) const;
  void paintTangents(QCPPainter& painter, const CornerPlaces& corner) const;
  void paintPlaces(QCPPainter& painter, const CornerPlaces& corner) const;
  void paintName(QCPPainter& painter, const PathPlace& place) const;
  void paintWheels(QCPPainter& painter) const;
  [[nodiscard]] const CornerPlaces* placesOfSelected() const;
  [[nodiscard]] QTransform toDevice() const;
  [[nodiscard]] double shown(double millimetres) const;

  FigureStyle m_style;
  std::vector<ProfileCurves> m_profiles;
  std::vector<std::vector<PathPiece>> m_paths; // of each profile
  PathSetting m_setting;
  std::optional<CornerPlaces> m_fromProfile; // of the selected corner, where nothing is planned
  std::optional<double> m_wheelRadius;
  std::vector<CornerLabel> m_labels;
  int m_selected = 0;
  std::optional<double> m_instant;
  double m_step = 0.1;         // s, of an arrow
  double m_room = 0;           // round the box, of its size
  std::optional<QRectF> m_box; // mm, until somebody zooms or pans
};

} // namespace arris::ui
