#include "ui/figures/profile_path.h"

#include <algorithm>
#include <cmath>

namespace arris::ui {
namespace {

constexpr int kBoxSteps = 100;

void appendTimes(std::vector<double>& times, const QPolygonF& curve, double from, double to) {
  for (const QPointF& point : curve) {
    if (point.x() >= from && point.x() <= to) {
      times.push_back(point.x());
    }
  }
}

// Wherever either coordinate has a point or a band ends.
std::vector<double> timesOf(const ProfileCurves& curves) {
  std::vector<double> times;
  appendTimes(times, curveOf(curves, Panel::PositionX), curves.workFrom, curves.workTo);
  appendTimes(times, curveOf(curves, Panel::PositionY), curves.workFrom, curves.workTo);
  for (const CornerBand& band : curves.bands) {
    times.push_back(band.from);
    times.push_back(band.to);
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

QPointF unitOf(const geometry::Vector& way) {
  const double length = way.norm();
  return length > 0 ? QPointF(way.x(), way.y()) / length : QPointF();
}

// Away from the glass at A and P_d, at C and P_a, and at Q; into it at S.
CornerPlaces placesOf(const toolpath::Corner& corner, const job::CornerResult* result) {
  CornerPlaces places{corner.id, {}};
  const auto add = [&](const char* name, const char* index, const geometry::Point& place,
                       const geometry::Vector& away) {
    places.places.push_back({QString::fromLatin1(name), QString::fromLatin1(index), toQt(place), unitOf(away)});
  };
  const geometry::Vector before = corner.a - corner.s;
  const geometry::Vector after = corner.c - corner.s;
  if (result != nullptr) {
    add("P", "d", result->decelerationPoint, before);
  }
  add("A", "", corner.a, before);
  if (corner.treatment == toolpath::Treatment::Transition) {
    add("Q", "", corner.q, before + after);
  }
  if (corner.treatment != toolpath::Treatment::Stop) {
    add("C", "", corner.c, after);
  }
  if (result != nullptr) {
    add("P", "a", result->accelerationPoint, after);
  }
  add("S", "", corner.s, -(before + after));
  return places;
}

} // namespace

std::optional<QPointF> placeAt(const ProfileCurves& curves, double time) {
  const QPointF place(curveValue(curveOf(curves, Panel::PositionX), time),
                      curveValue(curveOf(curves, Panel::PositionY), time));
  const bool isKnown = std::isfinite(place.x()) && std::isfinite(place.y());
  return isKnown ? std::optional(place) : std::nullopt;
}

std::vector<PathPiece> pathOf(const ProfileCurves& curves) {
  std::vector<PathPiece> path;
  auto band = curves.bands.begin();
  Zone before = Zone::Away; // of what leads to a point
  for (const double time : timesOf(curves)) {
    const std::optional<QPointF> place = placeAt(curves, time);
    if (!place) {
      before = Zone::Away;
      continue;
    }
    while (band != curves.bands.end() && band->to <= time) {
      ++band;
    }
    const Zone after = band != curves.bands.end() && band->from <= time ? band->zone : Zone::None;
    if (before != Zone::Away) {
      path.back().points.append(*place);
      path.back().times.push_back(time);
    }
    const bool begins = before == Zone::Away || (before == Zone::Corner) != (after == Zone::Corner);
    if (after != Zone::Away && begins) {
      path.push_back({after == Zone::Corner, {*place}, {time}});
    }
    before = after;
  }
  path.erase(std::remove_if(path.begin(), path.end(), [](const PathPiece& piece) { return piece.points.size() < 2; }),
             path.end());
  return path;
}

PathSetting pathSettingOf(const job::Job& job, const Drawing& whole) {
  PathSetting setting;
  setting.glass.contours = whole.contours;
  setting.glass.corners = whole.corners;
  setting.glass.travel = whole.travel;
  setting.glass.box = whole.box;
  for (const Trace& trace : whole.traces) {
    if (trace.kind == TraceKind::Contour) {
      setting.glass.traces.push_back(trace);
    }
  }
  for (const toolpath::Corner& corner : job.toolpath.corners) {
    const auto at = static_cast<std::size_t>(corner.id - 1);
    setting.corners.push_back(placesOf(corner, at < job.cornerResults.size() ? &job.cornerResults[at] : nullptr));
  }
  return setting;
}

CornerPlaces placesOf(const ProfileCurves& curves, const CornerPass& pass) {
  CornerPlaces places{pass.corner, {}};
  const auto add = [&](const char* name, const char* index, double time) {
    if (const auto place = placeAt(curves, time)) {
      places.places.push_back({QString::fromLatin1(name), QString::fromLatin1(index), *place, {}});
    }
  };
  add("P", "d", pass.from);
  for (const CornerBand& band : curves.bands) {
    if (band.corner == pass.corner && band.zone == Zone::Corner && band.from >= pass.from && band.to <= pass.to) {
      add("A", "", band.from);
      add("C", "", band.to);
      break;
    }
  }
  add("P", "a", pass.to);
  return places;
}

QRectF boxOf(const ProfileCurves& curves, const CornerPass& pass) {
  QPolygonF places;
  for (int i = 0; i <= kBoxSteps; ++i) {
    if (const auto place = placeAt(curves, pass.from + (pass.to - pass.from) * i / kBoxSteps)) {
      places.append(*place);
    }
  }
  return places.boundingRect();
}

QRectF boxOf(const std::vector<PathPiece>& path) {
  QRectF box;
  for (const PathPiece& piece : path) {
    box = box.united(piece.points.boundingRect());
  }
  return box;
}

} // namespace arris::ui
