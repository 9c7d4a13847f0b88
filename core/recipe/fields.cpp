#include "core/recipe/fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace arris::recipe {
namespace {

using base::Code;
using base::Problem;
using base::Problems;

constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};

// Shortest form that reads back as the same number: a value just outside its range must not look as if it were inside.
std::string exact(double value) {
  return fmt::format("{}", value);
}

template <auto Member> int chosen(const Recipe& recipe) {
  return static_cast<int>(recipe.*Member);
}

template <auto Member> void choose(Recipe& recipe, int index) {
  using Choice = std::remove_reference_t<decltype(recipe.*Member)>;
  recipe.*Member = static_cast<Choice>(index);
}

int chosenUnits(const Recipe& recipe) {
  return recipe.units ? static_cast<int>(*recipe.units) : -1;
}

void chooseUnits(Recipe& recipe, int index) {
  recipe.units = index < 0 ? std::nullopt : std::optional(static_cast<Units>(index));
}

void append(Problems& problems, std::optional<Problem> problem) {
  if (problem) {
    problems.push_back(std::move(*problem));
  }
}

std::optional<Problem> checkFinite(std::string_view name, double value, std::string_view unit) {
  if (std::isfinite(value)) {
    return std::nullopt;
  }
  return Problem(Code::ValueNotANumber,
                 {{"name", std::string(name)}, {"unit", std::string(unit)}, {"value", exact(value)}});
}

std::optional<Problem> checkAgainstMachine(std::string_view name, double value, double most, std::string_view unit) {
  if (!(value > most)) {
    return std::nullopt;
  }
  return Problem(
      Code::ValueAboveMachine,
      {{"name", std::string(name)}, {"value", exact(value)}, {"unit", std::string(unit)}, {"most", exact(most)}});
}

} // namespace

std::span<const NumberField> numberFields() {
  static const std::array kFields = {
      NumberField{"wheel_radius_mm", "wheel-radius", "mm", "Wheel radius", &Recipe::wheelRadius, 0.5, 500},
      NumberField{"wheel_height_mm", "wheel-height", "mm", "Thickness of the wheel", &Recipe::wheelHeight, 1, 200},
      NumberField{"wheel_z_mm", "wheel-z", "mm", "Fine adjustment of the grinding height", &Recipe::wheelZ, -100, 100},
      NumberField{"depth_mm", "depth", "mm", "Normal grinding depth", &Recipe::depth, 0, 5},
      NumberField{"thickness_mm", "thickness", "mm", "Thickness of the glass", &Recipe::thickness, 1, 100},
      NumberField{"support_mm", "support", "mm", "Underside of the glass above the table", &Recipe::support, 0, 1000},
      NumberField{"clearance_mm", "clearance", "mm", "Wheel's lower face above the glass when traversing",
                  &Recipe::clearance, 1, 500},
      NumberField{"feed_mm_min", "feed", "mm/min", "Feed", &Recipe::feed, 1, 60000},
      NumberField{"accel_x_mm_s2", "accel-x", "mm/s²", "Acceleration of the X axis", &Recipe::accelX, 0.1, 20000},
      NumberField{"accel_y_mm_s2", "accel-y", "mm/s²", "Acceleration of the Y axis", &Recipe::accelY, 0.1, 20000},
      NumberField{"accel_z_mm_s2", "accel-z", "mm/s²", "Acceleration of the Z axis", &Recipe::accelZ, 0.1, 20000},
      NumberField{"spindle_r_min", "spindle", "r/min", "Spindle speed", &Recipe::spindle, 0, 60000},
      NumberField{"corner_speed_percent", "corner-speed", "%", "Transition speed at sharp corners",
                  &Recipe::cornerSpeed, 10, 100},
      NumberField{"size_correction_mm", "size-correction", "mm", "Size correction (positive leaves the pane larger)",
                  &Recipe::sizeCorrection, -5, 5},
      NumberField{"lead_mm", "lead", "mm", "Radius of the lead-in and lead-out", &Recipe::lead, 1, 500},
      NumberField{"overlap_mm", "overlap", "mm", "Overlap past the start", &Recipe::overlap, 0, 1000},
      NumberField{"rotate_deg", "rotate", "°", "Rotation of the pattern", &Recipe::rotate, -360, 360},
      NumberField{"gap_mm", "gap", "mm", "Gaps up to this are closed", &Recipe::gap, 0, 1},
      NumberField{"smooth_mm", "smooth", "mm", "Tolerance of fitting chopped curves", &Recipe::smooth, 0, 1},
  };
  return kFields;
}

const NumberField& numberField(double Recipe::*member) {
  const auto fields = numberFields();
  return *std::find_if(fields.begin(), fields.end(),
                       [member](const NumberField& field) { return field.member == member; });
}

std::span<const ChoiceField> choiceFields() {
  static const std::array kFields = {
      ChoiceField{"acceleration_rule",
                  "acceleration-rule",
                  "How the accelerations of X and Y bind the speed",
                  {"per-axis", "combined"},
                  chosen<&Recipe::accelerationRule>,
                  choose<&Recipe::accelerationRule>},
      ChoiceField{"direction",
                  "direction",
                  "Direction round outlines",
                  {"cw", "ccw"},
                  chosen<&Recipe::direction>,
                  choose<&Recipe::direction>},
      ChoiceField{"mirror",
                  "mirror",
                  "Coordinates of the pattern that are negated",
                  {"none", "x", "y"},
                  chosen<&Recipe::mirror>,
                  choose<&Recipe::mirror>},
      ChoiceField{"units",
                  "units",
                  "Unit of the drawing, over what the file says",
                  {"mm", "cm", "m", "inch", "foot"},
                  chosenUnits,
                  chooseUnits},
  };
  return kFields;
}

std::span<const PlaceField> placeFields() {
  static constexpr std::array kFields = {
      PlaceField{"start_mm", "start", "The contour point nearest to this place is the start", &Recipe::start},
      PlaceField{"place_mm", "place", "Lower-left corner of the pane on the table", &Recipe::place},
  };
  return kFields;
}

std::span<const ListField> listFields() {
  static constexpr std::array kFields = {
      ListField{"layers", "layer", "Only these layers of the drawing", &Recipe::layers},
  };
  return kFields;
}

std::span<const FlagField> flagFields() {
  static constexpr std::array kFields = {
      FlagField{"accept_unreached", "accept-unreached", "Accept that places which the wheel cannot reach stay unground",
                &Recipe::acceptUnreached},
  };
  return kFields;
}

std::vector<std::string_view> differences(const Recipe& a, const Recipe& b) {
  std::vector<std::string_view> keys;
  const auto compare = [&](const auto& fields) {
    for (const auto& field : fields) {
      if (a.*field.member != b.*field.member) {
        keys.push_back(field.key);
      }
    }
  };
  compare(numberFields());
  for (const ChoiceField& field : choiceFields()) {
    if (field.get(a) != field.get(b)) {
      keys.push_back(field.key);
    }
  }
  compare(placeFields());
  compare(listFields());
  compare(flagFields());
  return keys;
}

bool isEngineering(std::string_view key) {
  static constexpr std::array<std::string_view, 5> kEngineering{"accel_x_mm_s2", "accel_y_mm_s2", "accel_z_mm_s2",
                                                                "corner_speed_percent", "acceleration_rule"};
  return std::find(kEngineering.begin(), kEngineering.end(), key) != kEngineering.end();
}

std::span<const MachineNumberField> machineNumberFields() {
  static constexpr std::array kFields = {
      MachineNumberField{"plunge_feed_mm_min", "mm/min", "Feed of plunges", &Machine::plungeFeed, 1, 60000},
      MachineNumberField{"period_s", "s", "Servo period", &Machine::period, 0.00025, 0.02},
      MachineNumberField{"home_search_mm_min", "mm/min", "Homing: speed towards the switch", &Machine::homeSearch, 1,
                         60000},
      MachineNumberField{"home_latch_mm_min", "mm/min", "Homing: speed off the switch", &Machine::homeLatch, 1, 6000},
      MachineNumberField{"jog_mm_min", "mm/min", "Fastest jog", &Machine::jogSpeed, 1, 60000},
      MachineNumberField{"set_point_lead_s", "s", "Set-points ahead of time", &Machine::setPointLead, 0.001, 0.2},
      MachineNumberField{"following_error_mm", "mm", "Greatest following error", &Machine::followingError, 0.01, 50},
      MachineNumberField{"back_off_mm", "mm", "Backing off in a hold", &Machine::backOff, 0, 100},
      MachineNumberField{"back_off_after_s", "s", "At rest before backing off", &Machine::backOffAfter, 0, 60},
      MachineNumberField{"spindle_wait_s", "s", "Longest wait for spindle and coolant", &Machine::spindleWait, 0.1,
                         120},
  };
  return kFields;
}

std::span<const MachineAxesField> machineAxesFields() {
  static constexpr std::array kFields = {
      MachineAxesField{"travel_mm", "mm", "Travel of the axes", &Machine::travel, 1, kFarthestPlace},
      MachineAxesField{"max_speed_mm_min", "mm/min", "Greatest speeds of the axes", &Machine::maxSpeed, 1, 600000},
      MachineAxesField{"max_accel_mm_s2", "mm/s²", "Greatest accelerations of the axes", &Machine::maxAccel, 0.1,
                       20000},
      MachineAxesField{"park_mm", "mm", "Park position", &Machine::park, 0, kFarthestPlace},
      MachineAxesField{"home_at_mm", "mm", "Reference switches", &Machine::homeAt, 0, kFarthestPlace},
  };
  return kFields;
}

std::span<const MachineFlagField> machineFlagFields() {
  static constexpr std::array kFields = {
      MachineFlagField{"jog_enable_required", "Jog only while the panel's jog enable is held",
                       &Machine::jogEnableRequired},
  };
  return kFields;
}

std::optional<Problem> checkRange(std::string_view name, double value, double least, double most,
                                  std::string_view unit) {
  if (auto problem = checkFinite(name, value, unit)) {
    return problem;
  }
  if (value >= least && value <= most) {
    return std::nullopt;
  }
  return Problem(Code::ValueOutOfRange, {{"name", std::string(name)},
                                         {"value", exact(value)},
                                         {"unit", std::string(unit)},
                                         {"least", exact(least)},
                                         {"most", exact(most)}});
}

Problems check(const Recipe& recipe) {
  Problems problems;
  for (const NumberField& field : numberFields()) {
    append(problems, checkRange(field.key, recipe.*field.member, field.least, field.most, field.unit));
  }
  for (const PlaceField& field : placeFields()) {
    if (const auto& place = recipe.*field.member) {
      for (int axis = 0; axis < 2; ++axis) {
        append(problems, checkRange(fmt::format("{} ({})", field.key, kAxes.at(static_cast<std::size_t>(axis))),
                                    (*place)[axis], -kFarthestPlace, kFarthestPlace, "mm"));
      }
    }
  }
  return problems;
}

Problems check(const Recipe& recipe, const Machine& machine) {
  Problems problems = check(recipe);
  constexpr std::array kAccelerations{&Recipe::accelX, &Recipe::accelY, &Recipe::accelZ};
  for (const NumberField& field : numberFields()) {
    const auto axis = std::find(kAccelerations.begin(), kAccelerations.end(), field.member) - kAccelerations.begin();
    if (axis < 3 && recipe.*field.member <= field.most) {
      append(problems, checkAgainstMachine(field.key, recipe.*field.member, machine.maxAccel[axis], field.unit));
    }
  }
  return problems;
}

Problems check(const Machine& machine) {
  Problems problems;
  for (const MachineNumberField& field : machineNumberFields()) {
    append(problems, checkRange(field.key, machine.*field.member, field.least, field.most, field.unit));
  }
  for (const MachineAxesField& field : machineAxesFields()) {
    const bool insideTravel = field.member == &Machine::park || field.member == &Machine::homeAt;
    for (int axis = 0; axis < 3; ++axis) {
      const double most = insideTravel ? std::min(field.most, machine.travel[axis]) : field.most;
      append(problems, checkRange(fmt::format("{} ({})", field.key, kAxes.at(static_cast<std::size_t>(axis))),
                                  (machine.*field.member)[axis], field.least, most, field.unit));
    }
  }
  return problems;
}

} // namespace arris::recipe
