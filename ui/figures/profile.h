#pragma once

#include "core/files/profile_csv.h"
#include "core/job/job.h"

#include <QPolygonF>
#include <QString>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace arris::ui {

/// What a moment of a profile has to do with a corner; Away: on the way from one contour to the next.
enum class Zone : std::uint8_t { None, Slowing, Corner, Leaving, Away };

/// The zone of a `phase` as the profile files spell it.
[[nodiscard]] Zone zoneOf(std::string_view phase);

/// A profile as columns of equal length, from a job or from a file: mm, s.
struct ProfileColumns {
  std::vector<double> time, x, y, vx, vy, ax, ay, speed;
  std::vector<double> distance; ///< wheel centre to the corner; NaN where there is none
  std::vector<int> contour, corner;
  std::vector<Zone> zone;
};

/// One more row.
void append(ProfileColumns& columns, const files::ProfileRow& row);

/// Every row of the planned profile; fewer where it is no longer `wanted` meanwhile: a slow feed makes millions of
/// rows.
[[nodiscard]] ProfileColumns columnsOf(
    const job::Job& job, const std::function<bool()>& wanted = [] { return true; });

/// A profile that was read back from a file.
[[nodiscard]] ProfileColumns columnsOf(std::span<const files::ProfileRow> rows);

/// What the curves are held against; absent where it is not known.
struct ProfileLimits {
  struct Corner {
    int id = 0;
    double angle = 0;                   ///< β, rad
    std::optional<double> reliefRadius; ///< R + d, mm
  };

  std::optional<double> feed;                       ///< mm/s
  std::optional<double> accelX, accelY;             ///< mm/s²
  std::optional<double> wheelRadius;                ///< mm
  std::optional<double> travelX = {}, travelY = {}; ///< mm: the wheel's centre goes from 0 to these
  std::vector<Corner> corners = {};
};

[[nodiscard]] ProfileLimits limitsOf(const job::Job& job);

/// What can be plotted over time, each in a panel of its own.
enum class Panel { SpeedX, SpeedY, AccelerationX, AccelerationY, Speed, Distance, PositionX, PositionY };
inline constexpr int kPanelCount = 8;

/// What a plot shows: the paper's Figures 8 and 10, or 9b and 9c.
enum class PlotContent : std::uint8_t { Speeds, Positions };

/// Its panels from top to bottom.
[[nodiscard]] std::span<const Panel> panelsOf(PlotContent content);

/// The time over which one zone of one corner lasts, s; no time at all for a corner where the wheel only stops.
struct CornerBand {
  int corner = 0;
  Zone zone = Zone::None;
  double from = 0;
  double to = 0;
};

/// A profile made ready for plotting: curves over time, thinned to what a screen can show at any sensible zoom.
struct ProfileCurves {
  QString name;                              ///< for the legend: "planned", "actual"
  std::array<QPolygonF, kPanelCount> panels; ///< by Panel; x: s; y: mm/s, mm/s² or mm; NaN for gaps
  std::vector<CornerBand> bands;
  double duration = 0;             ///< s
  double workFrom = 0, workTo = 0; ///< s, from the first lead-in to the last lead-out; all where there is no contour
  std::array<std::pair<double, double>, kPanelCount> range{}; ///< least and greatest value within the work
};

/// Some of the curves stay empty where they are no longer `wanted` meanwhile.
[[nodiscard]] ProfileCurves curvesOf(
    const ProfileColumns& columns, const QString& name, const std::function<bool()>& wanted = [] { return true; });

/// Which panel of the curves.
[[nodiscard]] inline const QPolygonF& curveOf(const ProfileCurves& curves, Panel panel) {
  return curves.panels.at(static_cast<std::size_t>(panel));
}

/// The value of a curve at a time, between its points on a straight line; NaN before, after and in gaps.
[[nodiscard]] double curveValue(const QPolygonF& curve, double time);

/// One pass of a corner, from the first braking to the last accelerating for it, s.
struct CornerPass {
  int corner = 0;
  double from = 0;
  double to = 0;
  double middle = 0; ///< of the time in the corner itself; of all of it where the wheel never is there
};

/// The passes in the order of time. A hold does not divide them.
[[nodiscard]] std::vector<CornerPass> cornerPasses(const ProfileCurves& curves);

/// A curve over time as it looks where `xScale` and `yScale` are device units per s and per unit of value: dense
/// stretches are reduced to what the pen would draw, all within `tolerance` device units. NaN stays a gap.
[[nodiscard]] QPolygonF thinnedCurve(const QPolygonF& curve, double xScale, double yScale, double tolerance);

} // namespace arris::ui
