#include "core/pattern/units.h"

namespace arris::pattern {
namespace {

using base::Code;
using base::Problem;
using recipe::Units;

std::optional<Units> fromInsUnits(std::int64_t number) {
  switch (number) {
  case 1:
    return Units::Inch;
  case 2:
    return Units::Foot;
  case 4:
    return Units::Millimetre;
  case 5:
    return Units::Centimetre;
  case 6:
    return Units::Metre;
  default:
    return std::nullopt;
  }
}

} // namespace

std::string_view name(Units units) {
  switch (units) {
  case Units::Millimetre:
    return "mm";
  case Units::Centimetre:
    return "cm";
  case Units::Metre:
    return "m";
  case Units::Inch:
    return "inch";
  case Units::Foot:
    return "foot";
  }
  return "mm";
}

double millimetresPer(Units units) {
  switch (units) {
  case Units::Millimetre:
    return 1;
  case Units::Centimetre:
    return 10;
  case Units::Metre:
    return 1000;
  case Units::Inch:
    return 25.4;
  case Units::Foot:
    return 304.8;
  }
  return 1;
}

FoundUnits findUnits(std::optional<Units> option, std::optional<std::int64_t> insUnits,
                     std::optional<std::int64_t> measurement) {
  if (option) {
    return {*option, UnitsFrom::Option, std::nullopt};
  }
  if (insUnits.value_or(0) != 0) {
    const std::optional<Units> units = fromInsUnits(*insUnits);
    if (units) {
      return {*units, UnitsFrom::InsUnits, std::nullopt};
    }
    return {Units::Millimetre, UnitsFrom::InsUnits, Problem(Code::UnitsUnknown, {{"number", *insUnits}})};
  }
  constexpr std::int64_t kImperial = 0;
  constexpr std::int64_t kMetric = 1;
  if (measurement && (*measurement == kImperial || *measurement == kMetric)) {
    return {*measurement == kImperial ? Units::Inch : Units::Millimetre, UnitsFrom::Measurement, std::nullopt};
  }
  return {Units::Millimetre, UnitsFrom::Assumed, Problem(Code::UnitsAssumed)};
}

} // namespace arris::pattern
