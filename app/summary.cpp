#include "app/summary.h"

#include "core/base/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace arris::app {
namespace {

using Text = fmt::memory_buffer;
using toolpath::Corner;

template <typename... Values> void add(Text& text, fmt::format_string<Values...> format, Values&&... values) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Values>(values)...);
}

std::string duration(double seconds) {
  constexpr double kMinute = 60;
  if (seconds < kMinute) {
    return fmt::format("{:.3f} s", seconds);
  }
  const double minutes = std::floor(seconds / kMinute);
  return fmt::format("{:.3f} s ({:.0f} min {:.1f} s)", seconds, minutes, seconds - minutes * kMinute);
}

double lengthOf(const toolpath::Chain& chain) {
  double length = 0;
  for (const toolpath::PathSegment& segment : chain.segments) {
    length += geometry::arcLength(segment.shape);
  }
  return length;
}

std::string_view treatment(const Corner& corner) {
  switch (corner.treatment) {
  case toolpath::Treatment::Transition:
    return "transition";
  case toolpath::Treatment::Roll:
    return "roll";
  case toolpath::Treatment::Arc:
    return "arc";
  case toolpath::Treatment::Stop:
    return "stop";
  }
  return "";
}

std::string_view limit(toolpath::LimitedBy limitedBy) {
  switch (limitedBy) {
  case toolpath::LimitedBy::Angle:
    return "angle";
  case toolpath::LimitedBy::AxisX:
    return "X axis";
  case toolpath::LimitedBy::AxisY:
    return "Y axis";
  case toolpath::LimitedBy::CornerSpeed:
    return "corner speed";
  }
  return "";
}

void addCorner(Text& text, const Corner& corner, const job::CornerResult& result) {
  add(text, "{:6}  {:7}  {:7.2f}°  {:<10}", corner.id, corner.contour, base::degrees(corner.angle), treatment(corner));
  if (corner.treatment == toolpath::Treatment::Transition) {
    add(text, "  {:7.3f}  {:<12}  {:7.3f}  {:9.3f}  {}", corner.transitionSpeed, limit(corner.limitedBy),
        result.plannedTime, corner.widest, corner.relief ? "yes" : "no");
  } else {
    add(text, "  {:7.3f}  {:<12}  {:7.3f}", result.plannedSpeed, "", result.plannedTime);
  }
  add(text, "\n");
}

void addCorners(Text& text, const job::Job& job) {
  if (job.toolpath.corners.empty() || job.cornerResults.size() != job.toolpath.corners.size()) {
    return;
  }
  add(text, "\nCorner  Contour     Angle  Treatment     mm/s    limited by        s   widest mm  relief\n");
  for (std::size_t i = 0; i < job.toolpath.corners.size(); ++i) {
    addCorner(text, job.toolpath.corners[i], job.cornerResults[i]);
  }
}

std::string_view source(pattern::UnitsFrom from) {
  switch (from) {
  case pattern::UnitsFrom::Option:
    return "as told";
  case pattern::UnitsFrom::InsUnits:
    return "by $INSUNITS";
  case pattern::UnitsFrom::Measurement:
    return "by $MEASUREMENT";
  case pattern::UnitsFrom::Assumed:
    return "assumed";
  }
  return "";
}

std::string countsOf(const pattern::EntityCounts& counts) {
  std::string text;
  for (const auto& [kind, count] : counts) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, kind);
  }
  return text.empty() ? "none" : text;
}

std::string_view kindOf(const pattern::Contour& contour) {
  return contour.kind == pattern::ContourKind::Outline ? "outline" : "cut-out";
}

void addLayers(Text& text, const std::map<std::string, pattern::EntityCounts>& layers) {
  std::size_t widest = 0;
  for (const auto& [layer, counts] : layers) {
    widest = std::max(widest, layer.size());
  }
  for (const auto& [layer, counts] : layers) {
    add(text, "Layer     \"{}\"{:{}}  {}\n", layer, "", widest - layer.size(), countsOf(counts));
  }
}

void addContours(Text& text, const std::vector<pattern::Contour>& contours) {
  if (contours.empty()) {
    return;
  }
  add(text,
      "\nContour  Kind     In    Curves    Length mm     Area mm²        X from       X to     Y from       Y to\n");
  for (const pattern::Contour& contour : contours) {
    const geometry::Box box = geometry::bounds(contour.curves);
    add(text, "{:7}  {:<7}  {:<4}  {:6}  {:11.3f}  {:11.0f}    {:10.3f} {:10.3f} {:10.3f} {:10.3f}\n", contour.id,
        kindOf(contour), contour.parent == 0 ? std::string("-") : std::to_string(contour.parent), contour.curves.size(),
        geometry::totalLength(contour.curves), std::abs(geometry::signedArea(contour.curves)), box.min().x(),
        box.max().x(), box.min().y(), box.max().y());
  }
}

void addRepairs(Text& text, base::Problems repairs) {
  if (repairs.empty()) {
    return;
  }
  add(text, "\nRepaired ({})\n", repairs.size());
  base::keepFirstOfEachCode(repairs);
  for (const base::Problem& repair : repairs) {
    add(text, "  {}\n", base::describeWithPlace(repair));
  }
}

// In which order the wheel goes round the contours; one that it leaves and comes back to has several ways.
void addWays(Text& text, const job::Job& job) {
  if (job.toolpath.chains.size() < 2) {
    return;
  }
  add(text, "\n   Way  Contour  Kind       Length mm  Starts at X          Y\n");
  for (std::size_t i = 0; i < job.toolpath.chains.size(); ++i) {
    const toolpath::Chain& chain = job.toolpath.chains[i];
    const auto contour = std::find_if(job.contours.begin(), job.contours.end(),
                                      [&](const pattern::Contour& c) { return c.id == chain.contour; });
    if (chain.segments.empty() || contour == job.contours.end()) {
      continue;
    }
    const geometry::Point start = geometry::startPoint(chain.segments.front().shape);
    add(text, "{:6}  {:7}  {:<7}  {:11.3f}   {:10.3f} {:10.3f}\n", i + 1, chain.contour, kindOf(*contour),
        lengthOf(chain), start.x(), start.y());
  }
}

// What stays as it was cut.
void addUnground(Text& text, const job::Job& job) {
  constexpr double kWorthTelling = 1e-3; // mm
  for (std::size_t i = 0; i < std::min(job.contours.size(), job.toolpath.unground.size()); ++i) {
    if (job.toolpath.unground[i] > kWorthTelling) {
      add(text, "Not ground: {:.3f} of {:.3f} mm of contour {} ({})\n", job.toolpath.unground[i],
          geometry::totalLength(job.contours[i].curves), job.contours[i].id, kindOf(job.contours[i]));
    }
  }
}

} // namespace

std::string summaryOf(const job::Job& job) {
  Text text;
  double pathLength = 0;
  for (const toolpath::Chain& chain : job.toolpath.chains) {
    pathLength += lengthOf(chain);
  }
  const geometry::Point& place = job.placement.place;
  add(text, "Pane with its lower left corner at X {:.3f} Y {:.3f} mm; wheel path {:.3f} mm\n", place.x(), place.y(),
      pathLength);
  addWays(text, job);
  addCorners(text, job);
  add(text, "\n");
  addUnground(text, job);
  add(text, "Working time {}; whole program {}\n", duration(job.working), duration(job.duration));
  return fmt::to_string(text);
}

std::string summaryOf(const pattern::Pattern& pattern) {
  Text text;
  add(text, "Unit      {} ({})\nEntities  {}\n", pattern::name(pattern.units), source(pattern.unitsFrom),
      countsOf(pattern.entities));
  addLayers(text, pattern.layers);
  addContours(text, pattern.contours);
  addRepairs(text, pattern.repairs);
  return fmt::to_string(text);
}

} // namespace arris::app
