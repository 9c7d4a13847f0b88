#include "core/files/resume_point.h"

#include "core/files/json_members.h"
#include "core/files/run_record.h"
#include "core/recipe/fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>

namespace arris::files {
namespace {

using base::Code;
using base::Problem;
using base::Problems;

constexpr std::string_view kResumeKey = "arris_resume";
constexpr int kResumeVersion = 1;

/// In the order of the enumeration.
constexpr std::array<std::string_view, 6> kEndedWords{"running", "held",           "stopped",
                                                      "fault",   "emergency-stop", "interrupted"};

constexpr std::array<std::string_view, 14> kResumeKeys{kResumeKey,  "pattern", "segment", "lambda_mm", "position_mm",
                                                       "origin_mm", "contour", "t_s",     "pane",      "panes",
                                                       "ended",     "axes",    "recipe",  "machine"};

constexpr int kMostSegments = std::numeric_limits<int>::max() - 1;
constexpr double kLongestSegment = 1e7; ///< mm
constexpr double kLongestRun = 1e9;     ///< s

/// The first of the words where the text is none of them.
template <typename Choice, std::size_t Count>
Choice choiceFrom(const char* key, const std::array<std::string_view, Count>& words, const std::string& text,
                  Problems& problems) {
  const auto* const word = std::find(words.begin(), words.end(), text);
  if (word == words.end()) {
    problems.push_back(
        Problem(Code::ValueNotAChoice,
                {{"name", std::string(key)}, {"value", text}, {"choices", fmt::format("{}", fmt::join(words, ", "))}}));
    return Choice{};
  }
  return static_cast<Choice>(word - words.begin());
}

ResumePoint pointFrom(const Json& object, std::string_view file, Problems& problems) {
  JsonMembers members(object, problems);
  JsonMembers pattern(members.object("pattern"), problems);
  ResumePoint point;
  point.patternFile = pattern.text("file");
  point.patternHash = pattern.hash("hash");
  point.place.segment = members.count("segment", -1, kMostSegments);
  point.place.lambda = members.number("lambda_mm", 0, kLongestSegment, "mm");
  point.position = members.vector("position_mm", -recipe::kFarthestPlace, recipe::kFarthestPlace, "mm");
  if (object.contains("origin_mm")) { // points of the first version have none
    point.origin = members.vector("origin_mm", -recipe::kFarthestPlace, recipe::kFarthestPlace, "mm");
  }
  point.contour = members.count("contour", 0, kMostSegments);
  point.time = members.number("t_s", 0, kLongestRun, "s");
  point.pane = members.count("pane", 1, kMostPanes);
  point.panes = members.count("panes", point.pane, kMostPanes);
  point.ended = choiceFrom<Ended>("ended", kEndedWords, members.text("ended"), problems);
  if (object.contains("axes")) {
    point.axes = choiceFrom<Axes>("axes", kAxesWords, members.text("axes"), problems);
  }
  readMembers(members.object("recipe"), file, point.recipe, problems);
  readMembers(members.object("machine"), file, point.machine, problems);
  return point;
}

} // namespace

std::string writeResumePoint(const ResumePoint& point) {
  JsonWriter json;
  json.openObject();
  json.member(kResumeKey, kResumeVersion);
  json.openObject("pattern");
  json.member("file", point.patternFile);
  json.member("hash", point.patternHash);
  json.close();
  json.member("segment", point.place.segment);
  json.member("lambda_mm", point.place.lambda);
  json.member("position_mm", std::span<const double>(point.position.data(), 3));
  json.member("origin_mm", std::span<const double>(point.origin.data(), 3));
  json.member("contour", point.contour);
  json.member("t_s", point.time);
  json.member("pane", point.pane);
  json.member("panes", point.panes);
  json.member("ended", kEndedWords.at(static_cast<std::size_t>(point.ended)));
  if (point.axes) {
    json.member("axes", wordOf(*point.axes));
  }
  writeSettings(json, point.recipe, point.machine);
  json.close();
  return json.take();
}

Read<ResumePoint> readResumePoint(std::string_view text, std::string_view file) {
  Read<ResumePoint> result;
  const auto object = parseVersioned(text, kResumeKey, kResumeVersion, file);
  if (!object) {
    result.problems.push_back(object.error());
    return result;
  }
  for (const auto& [key, value] : object->items()) {
    if (std::find(kResumeKeys.begin(), kResumeKeys.end(), key) == kResumeKeys.end()) {
      result.problems.push_back(Problem(Code::UnknownKey, {{"file", std::string(file)}, {"key", key}}));
    }
  }
  result.value = pointFrom(*object, file, result.problems);
  return result;
}

} // namespace arris::files
