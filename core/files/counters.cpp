#include "core/files/counters.h"

#include "core/files/json_members.h"

#include <algorithm>
#include <array>
#include <limits>

namespace arris::files {
namespace {

constexpr std::string_view kCountersKey = "arris_counters";
constexpr int kCountersVersion = 1;
constexpr std::array<std::string_view, 7> kCounterKeys{kCountersKey, "since",     "drives_on_s", "spindle_on_s",
                                                       "grinding_s", "ground_mm", "panes"};

constexpr double kLongestLife = 1e10; ///< s, three hundred years
constexpr double kLongestWay = 1e14;  ///< mm
constexpr int kMostPanesOfLife = std::numeric_limits<int>::max();

} // namespace

std::string writeCounters(const Counters& counters) {
  JsonWriter json;
  json.openObject();
  json.member(kCountersKey, kCountersVersion);
  json.member("since", counters.since);
  json.member("drives_on_s", counters.drivesOn);
  json.member("spindle_on_s", counters.spindleOn);
  json.member("grinding_s", counters.grinding);
  json.member("ground_mm", counters.ground);
  json.member("panes", counters.panes);
  json.close();
  return json.take();
}

Read<Counters> readCounters(std::string_view text, std::string_view file) {
  Read<Counters> result;
  const auto object = parseVersioned(text, kCountersKey, kCountersVersion, file);
  if (!object) {
    result.problems.push_back(object.error());
    return result;
  }
  for (const auto& [key, value] : object->items()) {
    if (std::find(kCounterKeys.begin(), kCounterKeys.end(), key) == kCounterKeys.end()) {
      result.problems.push_back(base::Problem(base::Code::UnknownKey, {{"file", std::string(file)}, {"key", key}}));
    }
  }
  JsonMembers members(*object, result.problems);
  result.value.since = members.text("since");
  result.value.drivesOn = members.number("drives_on_s", 0, kLongestLife, "s");
  result.value.spindleOn = members.number("spindle_on_s", 0, kLongestLife, "s");
  result.value.grinding = members.number("grinding_s", 0, kLongestLife, "s");
  result.value.ground = members.number("ground_mm", 0, kLongestWay, "mm");
  result.value.panes = members.count("panes", 0, kMostPanesOfLife);
  return result;
}

} // namespace arris::files
