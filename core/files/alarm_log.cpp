#include "core/files/alarm_log.h"

#include "core/base/window_thread.h"
#include "core/files/json_members.h"
#include "core/files/lines.h"
#include "core/files/whole_file.h"

#include <map>
#include <optional>
#include <system_error>
#include <tuple>
#include <utility>

namespace arris::files {
namespace {

using base::Code;
using base::Expected;
using base::Unexpected;
using std::filesystem::path;

std::string lineOf(const Alarm& alarm) {
  Json object;
  object["time"] = alarm.time;
  object["code"] = alarm.code;
  object["text"] = alarm.text;
  object["values"] = valuesToJson(alarm.values);
  object["acknowledged"] = alarm.acknowledged;
  return oneLine(object);
}

std::optional<Alarm> alarmFrom(std::string_view line) {
  const auto object = parseJson(line, "");
  if (!object) {
    return std::nullopt;
  }
  base::Problems problems;
  JsonMembers members(*object, problems);
  Alarm alarm{members.text("time"), members.text("code"), members.text("text"),
              valuesFromJson(members.object("values")), members.flag("acknowledged")};
  return problems.empty() ? std::optional(std::move(alarm)) : std::nullopt;
}

// The younger half, from the beginning of a line on.
Expected<void> dropOlderHalf(const path& log) {
  return readFile(log).and_then([&](const std::string& text) {
    const std::size_t lineEnd = text.find('\n', text.size() / 2);
    return writeWholeFile(log, lineEnd == std::string::npos ? std::string_view()
                                                            : std::string_view(text).substr(lineEnd + 1));
  });
}

} // namespace

Expected<void> appendAlarm(const path& log, const Alarm& alarm, std::size_t largest) {
  std::string line = lineOf(alarm);
  std::error_code none;
  if (const auto size = std::filesystem::file_size(log, none); !none && size + line.size() + 1 >= largest) {
    if (auto dropped = dropOlderHalf(log); !dropped) {
      return dropped;
    }
  }
  return appendLine(log, std::move(line));
}

Expected<AlarmLog> readAlarmLog(const path& log) {
  base::takesLong("readAlarmLog");
  AlarmLog result;
  std::error_code none;
  if (!std::filesystem::exists(log, none)) {
    return result;
  }
  const auto text = readFile(log);
  if (!text) {
    return Unexpected(text.error());
  }
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> places;
  eachLine(*text, [&](std::string_view line) {
    if (auto alarm = alarmFrom(line)) {
      const auto [place, isNew] = places.try_emplace({alarm->time, alarm->code, alarm->text}, result.alarms.size());
      if (isNew) {
        result.alarms.push_back(*std::move(alarm));
      } else {
        result.alarms[place->second] = *std::move(alarm);
      }
    } else if (!line.empty()) {
      ++result.brokenLines;
    }
  });
  return result;
}

Expected<std::vector<Alarm>> readAlarms(const path& log) {
  return readAlarmLog(log).map([](AlarmLog read) { return std::move(read.alarms); });
}

} // namespace arris::files
