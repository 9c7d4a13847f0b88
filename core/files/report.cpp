#include "core/files/report.h"

#include "core/base/numbers.h"
#include "core/base/window_thread.h"
#include "core/files/because.h"
#include "core/files/json.h"
#include "core/recipe/fields.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace arris::files {
namespace {

using job::Job;
using toolpath::Corner;
using toolpath::Treatment;

constexpr std::string_view kVersionKey = "arris_report";
constexpr int kVersion = 1;

// Words of the contract, in the order of the enumerations.
constexpr std::array<std::string_view, 4> kUnitsFrom{"option", "insunits", "measurement", "assumed"};
constexpr std::array<std::string_view, 2> kContourKinds{"outline", "cut-out"};
constexpr std::array<std::string_view, 3> kCornerKinds{"sharp", "blunt", "concave"};
constexpr std::array<std::string_view, 4> kTreatments{"transition", "roll", "arc", "stop"};
constexpr std::array<std::string_view, 4> kLimits{"angle", "axis-x", "axis-y", "corner-speed"};

template <typename Words, typename Choice> std::string_view word(const Words& words, Choice choice) {
  return words.at(static_cast<std::size_t>(choice));
}

// The word of a choice that recipes have too.
template <typename Choice> std::string_view recipeWord(std::string_view key, Choice choice) {
  const auto fields = recipe::choiceFields();
  const auto field = std::find_if(fields.begin(), fields.end(), [key](const auto& f) { return f.key == key; });
  return word(field->words, choice);
}

void writeBox(JsonWriter& json, std::string_view key, const geometry::Box& bounds) {
  const std::array<double, 4> corners{bounds.min().x(), bounds.min().y(), bounds.max().x(), bounds.max().y()};
  json.member(key, std::span<const double>(corners));
}

void writeContour(JsonWriter& json, const pattern::Contour& contour, std::optional<double> unground) {
  json.openObject();
  json.member("id", contour.id);
  json.member("kind", word(kContourKinds, contour.kind));
  json.member("length_mm", geometry::totalLength(contour.curves));
  json.member("area_mm2", std::abs(geometry::signedArea(contour.curves)));
  writeBox(json, "bounds_mm", geometry::bounds(contour.curves));
  json.member("fit_deviation_mm", contour.fitDeviation);
  if (unground) {
    json.member("untouched_mm", *unground);
  }
  if (contour.parent != 0) {
    json.member("parent", contour.parent);
  }
  json.close();
}

void writeRepair(JsonWriter& json, const base::Problem& repair, const Eigen::Isometry2d& placement) {
  json.openObject();
  json.member("code", base::info(repair.code).name);
  json.member("text", base::describe(repair));
  if (repair.where) {
    json.member("where_mm", Eigen::Vector2d(placement * *repair.where));
  }
  if (repair.line) {
    json.member("line", *repair.line);
  }
  for (const base::Value& value : repair.values) {
    json.member(value.name, value);
  }
  json.close();
}

void writeCounts(JsonWriter& json, std::string_view key, const pattern::EntityCounts& counts) {
  json.openObject(key);
  for (const auto& [entity, count] : counts) {
    json.member(entity, count);
  }
  json.close();
}

// Places are shown where `placement` puts them. `unground` is by contour, or empty where nothing was planned.
void writePattern(JsonWriter& json, const pattern::Pattern& pattern, const std::vector<pattern::Contour>& contours,
                  const std::vector<double>& unground, const Eigen::Isometry2d& placement, std::string_view file) {
  json.openObject("pattern");
  json.member("file", file);
  json.member("units", recipeWord("units", pattern.units));
  json.member("units_from", word(kUnitsFrom, pattern.unitsFrom));
  writeCounts(json, "entities", pattern.entities);
  json.openObject("layers");
  for (const auto& [layer, counts] : pattern.layers) {
    writeCounts(json, layer, counts);
  }
  json.close();
  json.openArray("contours");
  for (std::size_t i = 0; i < contours.size(); ++i) {
    writeContour(json, contours[i], i < unground.size() ? std::optional(unground[i]) : std::nullopt);
  }
  json.close();
  json.openArray("repairs");
  for (const base::Problem& repair : pattern.repairs) {
    writeRepair(json, repair, placement);
  }
  json.close();
  json.close();
}

void writePlacement(JsonWriter& json, const Job& job) {
  json.openObject("placement");
  json.member("x_mm", job.placement.place.x());
  json.member("y_mm", job.placement.place.y());
  json.member("rotation_deg", job.recipe.rotate); // as it was given, without a rounding on the way to radians
  json.member("mirror", recipeWord("mirror", job.placement.mirror));
  json.member("pattern_origin_mm", job.placement.patternOrigin);
  json.close();
}

void writeBecause(JsonWriter& json, const Corner& corner, const recipe::Recipe& recipe) {
  const Because reason = because(corner, recipe);
  json.openObject("because");
  json.member("code", reason.code);
  json.member("text", reason.text);
  for (const base::Value& figure : reason.figures) {
    json.member(figure.name, figure);
  }
  json.close();
}

void writeTransition(JsonWriter& json, const Corner& corner, const recipe::Recipe& recipe) {
  json.member("Q_mm", corner.q);
  json.member("v_trans_mm_s", corner.transitionSpeed);
  json.member("v_trans_limited_by", word(kLimits, corner.limitedBy));
  json.member("a_mm_s2", corner.blendAcceleration);
  json.member("t_m_s", corner.blendTime);
  json.member("widest_mm", corner.widest);
  json.member("relief_margin_mm", corner.widest - (recipe.wheelRadius + corner.tipDepth));
}

void writeResult(JsonWriter& json, const job::CornerResult& result) {
  json.member("planned_speed_mm_s", result.plannedSpeed);
  json.member("planned_time_s", result.plannedTime);
  json.member("L_d_mm", result.decelerationLength);
  json.member("L_a_mm", result.accelerationLength);
  json.member("P_d_mm", result.decelerationPoint);
  json.member("P_a_mm", result.accelerationPoint);
}

void writeCorner(JsonWriter& json, const Job& job, const Corner& corner) {
  json.openObject();
  json.member("id", corner.id);
  json.member("contour", corner.contour);
  json.member("kind", word(kCornerKinds, corner.kind));
  json.member("treatment", word(kTreatments, corner.treatment));
  json.member("S_mm", corner.s);
  json.member("angle_deg", base::degrees(corner.angle));
  writeBecause(json, corner, job.recipe);
  json.member("A_mm", corner.a);
  json.member("C_mm", corner.c);
  if (corner.kind == toolpath::CornerKind::Concave) {
    json.member("fillet_mm", corner.fillet);
    json.member("unground_mm", corner.unground);
  } else {
    json.member("tip_depth_mm", corner.tipDepth);
    json.member("relief", corner.relief);
    json.member("relief_eq13", corner.reliefEq13);
  }
  if (corner.treatment == Treatment::Transition) {
    writeTransition(json, corner, job.recipe);
  }
  const auto index = static_cast<std::size_t>(corner.id - 1);
  if (index < job.cornerResults.size()) {
    writeResult(json, job.cornerResults[index]);
  }
  json.close();
}

void writePath(JsonWriter& json, const toolpath::Toolpath& toolpath) {
  double length = 0;
  geometry::Box bounds;
  std::size_t segments = 0;
  for (const toolpath::Chain& chain : toolpath.chains) {
    for (const toolpath::PathSegment& segment : chain.segments) {
      length += geometry::arcLength(segment.shape);
      bounds.extend(geometry::bounds(segment.shape));
    }
    segments += chain.segments.size();
  }
  json.openObject("path");
  json.member("length_mm", length);
  writeBox(json, "bounds_mm", bounds);
  json.member("segments", segments);
  json.close();
}

// What only a job that can be ground has.
void writePlan(JsonWriter& json, const Job& job) {
  writePath(json, job.toolpath);
  json.member("duration_s", job.duration);
  json.member("working_s", job.working);
  json.openObject("duration_by_phase_s");
  for (std::size_t i = 0; i < job.byPhase.size(); ++i) {
    if (job.byPhase[i] > 0) {
      json.member(job::name(static_cast<job::Phase>(i)), job.byPhase[i]);
    }
  }
  json.close();
}

void writeProblem(JsonWriter& json, const base::Problem& problem) {
  json.openObject();
  json.member("severity", base::name(base::severityOf(problem)));
  json.member("code", base::info(problem.code).name);
  json.member("text", base::describe(problem));
  json.openObject("values");
  for (const base::Value& value : problem.values) {
    json.member(value.name, value);
  }
  json.close();
  const auto optionalMember = [&json](std::string_view key, const auto& value) {
    if (value) {
      json.member(key, *value);
    }
  };
  optionalMember("where_mm", problem.where);
  optionalMember("line", problem.line);
  optionalMember("contour", problem.contour);
  optionalMember("corner", problem.corner);
  optionalMember("largest_wheel_mm", problem.largestWheel);
  json.close();
}

void writeProblems(JsonWriter& json, const base::Problems& problems) {
  json.openArray("problems");
  for (const base::Problem& problem : problems) {
    writeProblem(json, problem);
  }
  json.close();
}

void openReport(JsonWriter& json) {
  json.openObject();
  json.member("arris", ARRIS_VERSION);
  json.member(kVersionKey, kVersion);
}

std::optional<double> numberAt(const Json& object, std::string_view key) {
  const auto value = object.find(key);
  return value != object.end() && value->is_number() ? std::optional(value->get<double>()) : std::nullopt;
}

Json childOf(const Json& object, std::string_view key, const Json& otherwise) {
  const auto child = object.find(key);
  return child != object.end() && child->type() == otherwise.type() ? *child : otherwise;
}

std::optional<ReportFigures::Corner> cornerFigures(const Json& object, std::optional<double> wheelRadius) {
  const auto id = numberAt(object, "id");
  const auto angle = numberAt(object, "angle_deg");
  if (!id || !angle) {
    return std::nullopt;
  }
  ReportFigures::Corner corner{static_cast<int>(std::clamp(*id, 0.0, 1e9)), base::radians(*angle), std::nullopt};
  const auto tipDepth = numberAt(object, "tip_depth_mm");
  if (tipDepth && wheelRadius && object.contains("widest_mm")) {
    corner.reliefRadius = *wheelRadius + *tipDepth;
  }
  return corner;
}

} // namespace

std::string report(const pattern::Pattern& pattern, const Job& job, std::string_view file) {
  base::takesLong("report");
  JsonWriter json;
  openReport(json);
  writePattern(json, pattern, job.contours, job.toolpath.unground, job.placement.motion, file);
  writeSettings(json, job.recipe, job.machine);
  if (!job.contours.empty()) {
    writePlacement(json, job);
  }
  json.openArray("corners");
  for (const Corner& corner : job.toolpath.corners) {
    writeCorner(json, job, corner);
  }
  json.close();
  if (!job.pieces.empty()) {
    writePlan(json, job);
  }
  writeProblems(json, job.problems);
  json.close();
  return json.take();
}

std::string report(const pattern::Pattern& pattern, std::string_view file) {
  JsonWriter json;
  openReport(json);
  writePattern(json, pattern, pattern.contours, {}, Eigen::Isometry2d::Identity(), file);
  writeProblems(json, pattern.problems);
  json.close();
  return json.take();
}

base::Expected<ReportFigures> readReport(std::string_view text, std::string_view name) {
  const auto object = parseJson(text, name);
  if (!object) {
    return base::Unexpected(object.error());
  }
  if (const auto version = checkVersion(*object, kVersionKey, kVersion, name); !version) {
    return base::Unexpected(version.error());
  }
  const Json recipe = childOf(*object, "recipe", Json::object());
  ReportFigures figures;
  if (const auto feed = numberAt(recipe, "feed_mm_min")) {
    figures.feed = *feed / 60;
  }
  figures.accelX = numberAt(recipe, "accel_x_mm_s2");
  figures.accelY = numberAt(recipe, "accel_y_mm_s2");
  figures.wheelRadius = numberAt(recipe, "wheel_radius_mm");
  for (const Json& corner : childOf(*object, "corners", Json::array())) {
    if (const auto found = corner.is_object() ? cornerFigures(corner, figures.wheelRadius) : std::nullopt) {
      figures.corners.push_back(*found);
    }
  }
  return figures;
}

} // namespace arris::files
