#pragma once

#include "ui/figures/style.h"

#include <qcustomplot.h>

#include <optional>

namespace arris::ui {

/// A plot of profiles in which a time is pointed at and corners are tapped. With the focus, arrows move the time that
/// is pointed at, plus and minus zoom, and Home shows the work.
class PointedPlot : public QCustomPlot {
  Q_OBJECT

public:
  PointedPlot(const FigureStyle& style, QWidget* parent);

  /// Marks a corner, without moving to it; 0 for none.
  virtual void selectCorner(int corner) = 0;
  virtual void showWork() = 0;
  virtual void showAll() = 0;

  void zoomIn();
  void zoomOut();

  /// Shows what belongs to this time; nothing without one.
  virtual void markInstant(std::optional<double> time);

Q_SIGNALS:
  void cornerTapped(int corner);
  /// A time was tapped, the mouse hovers over it, or arrows moved there, s.
  void instantPointed(double time);

protected:
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void showEvent(QShowEvent* event) override;

  virtual void zoomBy(double factor) = 0;
  virtual void pointBeside(int steps) = 0;

  void refresh();
  void styleAxis(QCPAxis& axis) const;
  [[nodiscard]] bool isTap(const QMouseEvent& release) const;

  /// In the unit that is shown.
  [[nodiscard]] double shown(double millimetres) const;

  FigureStyle m_style;
  std::optional<double> m_instant;
};

} // namespace arris::ui
