#include "ui/figures/profile.h"

#include "core/base/window_thread.h"
#include "ui/figures/polyline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arris::ui {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

// Curves are kept as if drawn this large, in pixels: a screen can be zoomed in twenty times before it shows.
constexpr double kDetailWidth = 60000;
constexpr double kDetailHeight = 6000;
constexpr double kDetail = 0.05; // their values are read too: to 0.05 mm/s where a rapid makes 5000 mm/s

const std::vector<double>& columnOf(const ProfileColumns& columns, Panel panel) {
  switch (panel) {
  case Panel::SpeedX:
    return columns.vx;
  case Panel::SpeedY:
    return columns.vy;
  case Panel::AccelerationX:
    return columns.ax;
  case Panel::AccelerationY:
    return columns.ay;
  case Panel::Speed:
    return columns.speed;
  case Panel::PositionX:
    return columns.x;
  case Panel::PositionY:
    return columns.y;
  case Panel::Distance:
    break;
  }
  return columns.distance;
}

std::pair<std::size_t, std::size_t> workRows(const ProfileColumns& columns) {
  const auto onContour = [](int contour) { return contour != 0; };
  const auto first = std::find_if(columns.contour.begin(), columns.contour.end(), onContour);
  const auto last = std::find_if(columns.contour.rbegin(), columns.contour.rend(), onContour);
  if (first == columns.contour.end()) {
    return {0, columns.time.size()};
  }
  return {static_cast<std::size_t>(first - columns.contour.begin()),
          static_cast<std::size_t>(columns.contour.rend() - last)};
}

// What a row of the profile belongs to: the zone of a corner, or the way from a contour to the next.
CornerBand bandAt(const ProfileColumns& columns, std::size_t row) {
  if (columns.contour[row] == 0) {
    return {0, Zone::Away};
  }
  return {columns.corner[row], columns.corner[row] != 0 ? columns.zone[row] : Zone::None};
}

// A stop has no time of its own: it lies where braking ends.
std::vector<CornerBand> withStops(const std::vector<CornerBand>& bands) {
  std::vector<CornerBand> result;
  for (std::size_t i = 0; i < bands.size(); ++i) {
    result.push_back(bands[i]);
    const bool stops = bands[i].zone == Zone::Slowing && i + 1 < bands.size() && bands[i + 1].zone == Zone::Leaving &&
                       bands[i + 1].corner == bands[i].corner;
    if (stops) {
      result.push_back({bands[i].corner, Zone::Corner, bands[i].to, bands[i].to});
    }
  }
  return result;
}

std::vector<CornerBand> bandsOf(const ProfileColumns& columns, std::size_t first, std::size_t end) {
  std::vector<CornerBand> bands;
  bool running = false;
  for (std::size_t i = first; i < end; ++i) {
    const CornerBand here = bandAt(columns, i);
    const bool same = running && bands.back().corner == here.corner && bands.back().zone == here.zone;
    if (running) {
      bands.back().to = columns.time[i]; // up to where the next begins
    }
    running = here.zone != Zone::None;
    if (running && !same) {
      bands.push_back({here.corner, here.zone, columns.time[i], columns.time[i]});
    }
  }
  return withStops(bands);
}

// The distance is of interest while the wheel passes the corner; the ways there and back would only stretch the axis.
bool countsForRange(const ProfileColumns& columns, Panel panel, std::size_t row) {
  return columns.contour[row] != 0 && (panel != Panel::Distance || columns.zone[row] == Zone::Corner);
}

std::pair<double, double> rangeOf(const ProfileColumns& columns, Panel panel) {
  const std::vector<double>& values = columnOf(columns, panel);
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i]) && countsForRange(columns, panel, i)) {
      least = std::min(least, values[i]);
      most = std::max(most, values[i]);
    }
  }
  return least <= most ? std::pair(least, most) : std::pair(0.0, 0.0);
}

QPolygonF thinnedColumn(const ProfileColumns& columns, Panel panel) {
  const std::vector<double>& values = columnOf(columns, panel);
  QPolygonF curve;
  curve.reserve(static_cast<qsizetype>(values.size()));
  double greatest = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    curve.append({columns.time[i], values[i]});
    if (std::isfinite(values[i])) {
      greatest = std::max(greatest, std::abs(values[i]));
    }
  }
  if (greatest == 0 || columns.time.back() == 0) {
    return curve.isEmpty() ? curve : QPolygonF{curve.front(), curve.back()};
  }
  return thinnedCurve(curve, kDetailWidth / columns.time.back(), kDetailHeight / greatest, kDetail);
}

/// A figure shows no more; a slow job of hours has a hundred times as many periods.
constexpr double kMostRows = 200000;

void reserve(ProfileColumns& columns, std::size_t rows) {
  for (std::vector<double>* column : {&columns.time, &columns.x, &columns.y, &columns.vx, &columns.vy, &columns.ax,
                                      &columns.ay, &columns.speed, &columns.distance}) {
    column->reserve(rows);
  }
  columns.contour.reserve(rows);
  columns.corner.reserve(rows);
  columns.zone.reserve(rows);
}

} // namespace

std::span<const Panel> panelsOf(PlotContent content) {
  static constexpr std::array kSpeeds{Panel::SpeedX,        Panel::SpeedY, Panel::AccelerationX,
                                      Panel::AccelerationY, Panel::Speed,  Panel::Distance};
  static constexpr std::array kPositions{Panel::PositionX, Panel::PositionY};
  return content == PlotContent::Speeds ? std::span<const Panel>(kSpeeds) : std::span<const Panel>(kPositions);
}

Zone zoneOf(std::string_view phase) {
  if (phase == "decelerate") {
    return Zone::Slowing;
  }
  if (phase == "transition" || phase == "roll" || phase == "stop") {
    return Zone::Corner;
  }
  return phase == "accelerate" ? Zone::Leaving : Zone::None;
}

void append(ProfileColumns& columns, const files::ProfileRow& row) {
  columns.time.push_back(row.time);
  columns.x.push_back(row.position.x());
  columns.y.push_back(row.position.y());
  columns.vx.push_back(row.velocity.x());
  columns.vy.push_back(row.velocity.y());
  columns.ax.push_back(row.acceleration.x());
  columns.ay.push_back(row.acceleration.y());
  columns.speed.push_back(row.speed);
  columns.distance.push_back(row.corner != 0 ? row.distance : kNothing);
  columns.contour.push_back(row.contour);
  columns.corner.push_back(row.corner);
  columns.zone.push_back(zoneOf(row.phase));
}

ProfileColumns columnsOf(const job::Job& job, const std::function<bool()>& wanted) {
  base::takesLong("columnsOf");
  ProfileColumns columns;
  if (job.pieces.empty()) {
    return columns;
  }
  job::Sampler sampler(job, std::max(job.machine.period, job.duration / kMostRows));
  reserve(columns, sampler.count());
  while (!sampler.done() && wanted()) {
    const job::Sample row = sampler.next();
    append(columns, {row.setPoint.time, row.setPoint.position, row.setPoint.velocity, row.setPoint.axisAcceleration,
                     row.speed, row.path, row.contour, row.segment, job::name(row.phase), row.corner, row.distance});
  }
  return columns;
}

ProfileColumns columnsOf(std::span<const files::ProfileRow> rows) {
  ProfileColumns columns;
  reserve(columns, rows.size());
  for (const files::ProfileRow& row : rows) {
    append(columns, row);
  }
  return columns;
}

ProfileLimits limitsOf(const job::Job& job) {
  ProfileLimits limits;
  limits.feed = job.recipe.feedPerSecond();
  limits.accelX = job.recipe.accelX; // under the combined rule too, which does not keep them: then it shows
  limits.accelY = job.recipe.accelY;
  limits.wheelRadius = job.recipe.wheelRadius;
  limits.travelX = job.machine.travel.x();
  limits.travelY = job.machine.travel.y();
  for (const toolpath::Corner& corner : job.toolpath.corners) {
    limits.corners.push_back({corner.id, corner.angle, std::nullopt});
    if (corner.treatment == toolpath::Treatment::Transition) { // a roll lifts nothing
      limits.corners.back().reliefRadius = job.recipe.wheelRadius + corner.tipDepth;
    }
  }
  return limits;
}

ProfileCurves curvesOf(const ProfileColumns& columns, const QString& name, const std::function<bool()>& wanted) {
  base::takesLong("curvesOf");
  ProfileCurves curves;
  curves.name = name;
  if (columns.time.empty()) {
    return curves;
  }
  curves.duration = columns.time.back();
  const auto [first, end] = workRows(columns);
  curves.workFrom = columns.time[first];
  curves.workTo = columns.time[end - 1];
  curves.bands = bandsOf(columns, first, end);
  for (int i = 0; i < kPanelCount && wanted(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    curves.panels[at] = thinnedColumn(columns, static_cast<Panel>(i));
    curves.range[at] = rangeOf(columns, static_cast<Panel>(i));
  }
  return curves;
}

double curveValue(const QPolygonF& curve, double time) {
  const auto after = std::lower_bound(curve.begin(), curve.end(), time,
                                      [](const QPointF& point, double sought) { return point.x() < sought; });
  if (after == curve.end()) {
    return kNothing;
  }
  if (after->x() == time || after == curve.begin()) {
    return after->x() == time ? after->y() : kNothing;
  }
  const QPointF& a = *std::prev(after);
  return a.y() + (after->y() - a.y()) * (time - a.x()) / (after->x() - a.x());
}

std::vector<CornerPass> cornerPasses(const ProfileCurves& curves) {
  std::vector<CornerPass> passes;
  Zone before = Zone::None;
  std::optional<double> entered;
  for (const CornerBand& band : curves.bands) {
    if (band.corner == 0) {
      continue;
    }
    if (passes.empty() || passes.back().corner != band.corner || band.zone < before) {
      passes.push_back({band.corner, band.from, band.to, 0});
      entered.reset();
    }
    if (band.zone == Zone::Corner && !entered) {
      entered = band.from;
    }
    CornerPass& pass = passes.back();
    pass.to = band.to;
    if (band.zone == Zone::Corner || !entered) {
      pass.middle = (entered.value_or(pass.from) + band.to) / 2;
    }
    before = band.zone;
  }
  return passes;
}

QPolygonF thinnedCurve(const QPolygonF& curve, double xScale, double yScale, double tolerance) {
  QPolygonF result;
  const auto isGap = [](const QPointF& point) { return !std::isfinite(point.y()); };
  for (auto first = curve.begin(); first != curve.end();) {
    const auto end = std::find_if(first, curve.end(), isGap);
    QPolygonF device;
    for (auto point = first; point != end; ++point) {
      device.append({point->x() * xScale, point->y() * yScale});
    }
    for (const QPointF& point : thinned(columnExtremes(device, 1), tolerance)) {
      result.append({point.x() / xScale, point.y() / yScale});
    }
    first = std::find_if_not(end, curve.end(), isGap);
    if (first != end) {
      result.append({end->x(), kNothing});
    }
  }
  return result;
}

} // namespace arris::ui
