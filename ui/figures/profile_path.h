#pragma once

#include "ui/figures/drawing.h"
#include "ui/figures/profile.h"

#include <QPointF>
#include <QRectF>

#include <optional>
#include <vector>

namespace arris::ui {

/// A stretch of the way of the wheel's centre in the plane, within a corner or outside of all of them.
struct PathPiece {
  bool inCorner = false;
  QPolygonF points;          ///< mm
  std::vector<double> times; ///< s, of each point
};

/// The way along the glass that a profile describes, without the ways from one contour to the next.
[[nodiscard]] std::vector<PathPiece> pathOf(const ProfileCurves& curves);

/// Where the wheel's centre is at a time, mm; nothing where the profile has no place then.
[[nodiscard]] std::optional<QPointF> placeAt(const ProfileCurves& curves, double time);

/// A place of the method with its name: "P" with the index "d".
struct PathPlace {
  QString name;
  QString index;
  QPointF place; ///< mm
  QPointF away;  ///< where its name goes from there, unit or null
};

/// The places of a corner: P_d, A, Q, C, P_a and S as far as it has them.
struct CornerPlaces {
  int corner = 0;
  std::vector<PathPlace> places;
};

/// What the path goes along: the glass with its numbered corners, and the places of the method.
struct PathSetting {
  Drawing glass;
  std::vector<CornerPlaces> corners;
};

/// `whole` is the drawing of the job.
[[nodiscard]] PathSetting pathSettingOf(const job::Job& job, const Drawing& whole);

/// Where nothing is planned: P_d, A, C and P_a by what the profile says about a pass.
[[nodiscard]] CornerPlaces placesOf(const ProfileCurves& curves, const CornerPass& pass);

/// What one pass of a corner takes of the plane, mm; null where it takes none.
[[nodiscard]] QRectF boxOf(const ProfileCurves& curves, const CornerPass& pass);

/// What all of the way takes, mm.
[[nodiscard]] QRectF boxOf(const std::vector<PathPiece>& path);

} // namespace arris::ui
