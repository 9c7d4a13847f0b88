#include "app/summary.h"

#include "core/base/numbers.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

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
  add(text, "{:6}  {:7.2f}°  {:<10}", corner.id, base::degrees(corner.angle), treatment(corner));
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
  add(text, "\nCorner     Angle  Treatment     mm/s    limited by        s   widest mm  relief\n");
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

void addCounts(Text& text, const pattern::EntityCounts& counts) {
  const char* separator = "";
  for (const auto& [kind, count] : counts) {
    add(text, "{}{} {}", separator, count, kind);
    separator = ", ";
  }
  add(text, "\n");
}

} // namespace

std::string summaryOf(const job::Job& job) {
  Text text;
  double pathLength = 0;
  for (const toolpath::Chain& chain : job.toolpath.chains) {
    for (const toolpath::PathSegment& segment : chain.segments) {
      pathLength += geometry::arcLength(segment.shape);
    }
  }
  const geometry::Point& place = job.placement.place;
  add(text, "Pane with its lower left corner at X {:.3f} Y {:.3f} mm; wheel path {:.3f} mm\n", place.x(), place.y(),
      pathLength);
  addCorners(text, job);
  add(text, "\nWorking time {}; whole program {}\n", duration(job.working), duration(job.duration));
  return fmt::to_string(text);
}

std::string summaryOf(const pattern::Pattern& pattern) {
  Text text;
  add(text, "Unit      {} ({})\nEntities  ", pattern::name(pattern.units), source(pattern.unitsFrom));
  addCounts(text, pattern.entities);
  for (const auto& [layer, counts] : pattern.layers) {
    add(text, "Layer     \"{}\": ", layer);
    addCounts(text, counts);
  }
  for (const pattern::Contour& contour : pattern.contours) {
    const geometry::Box box = geometry::bounds(contour.curves);
    add(text, "Contour {} {} of {} curves, {:.3f} mm long, {:.0f} mm², X {:.3f} to {:.3f}, Y {:.3f} to {:.3f} mm\n",
        contour.id, contour.kind == pattern::ContourKind::Outline ? "outline" : "cut-out", contour.curves.size(),
        geometry::totalLength(contour.curves), std::abs(geometry::signedArea(contour.curves)), box.min().x(),
        box.max().x(), box.min().y(), box.max().y());
  }
  for (const base::Problem& repair : pattern.repairs) {
    add(text, "Repaired  {}\n", base::describeWithPlace(repair));
  }
  return fmt::to_string(text);
}

} // namespace arris::app
