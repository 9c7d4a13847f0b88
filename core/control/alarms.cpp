#include "core/control/alarms.h"

#include <algorithm>
#include <utility>

namespace arris::control {
namespace {

constexpr std::string_view kAxisLetters = "XYZ";

const base::Value* valueNamed(const files::Alarm& alarm, std::string_view name) {
  const auto value = std::find_if(alarm.values.begin(), alarm.values.end(),
                                  [name](const base::Value& candidate) { return candidate.name == name; });
  return value != alarm.values.end() ? &*value : nullptr;
}

int axisOf(const files::Alarm& alarm) {
  const base::Value* value = valueNamed(alarm, "axis");
  const auto* letter = value != nullptr ? std::get_if<std::string>(&value->value) : nullptr;
  const bool isOne = letter != nullptr && letter->size() == 1;
  const std::size_t place = isOne ? kAxisLetters.find(*letter) : std::string_view::npos;
  return place != std::string_view::npos ? static_cast<int>(place) : -1;
}

double figureOf(const files::Alarm& alarm) {
  const base::Value* value = valueNamed(alarm, "value");
  if (value == nullptr) {
    return 0;
  }
  if (const auto* whole = std::get_if<std::int64_t>(&value->value)) {
    return static_cast<double>(*whole);
  }
  const auto* number = std::get_if<double>(&value->value);
  return number != nullptr ? *number : 0;
}

} // namespace

files::Alarm alarmOf(const FaultReport& fault, std::string time) {
  const FaultInfo& row = info(fault.fault);
  files::Alarm alarm;
  alarm.time = std::move(time);
  alarm.code = row.name;
  alarm.text = describe(fault);
  if (fault.axis >= 0) {
    alarm.values.push_back({"axis", std::string(kAxisLetters.substr(static_cast<std::size_t>(fault.axis), 1))});
  }
  if (row.text.find("{value}") != std::string_view::npos) {
    alarm.values.push_back({"value", fault.value});
  }
  return alarm;
}

std::optional<FaultReport> faultOf(const files::Alarm& alarm) {
  const auto& rows = allFaults();
  const auto* const row =
      std::find_if(rows.begin(), rows.end(), [&](const FaultInfo& candidate) { return candidate.name == alarm.code; });
  if (row == rows.end()) {
    return std::nullopt;
  }
  return FaultReport{0, row->fault, axisOf(alarm), figureOf(alarm)};
}

} // namespace arris::control
