#pragma once

#include "core/recipe/recipe.h"

#include <span>
#include <string_view>
#include <vector>

namespace arris::recipe {

// The recipe and the machine as tables: key, option, unit and range of every field stand here once. JSON, command line,
// window and checks all iterate over them, so a new field cannot be forgotten in one of them.

/// A number of the recipe.
struct NumberField {
  std::string_view key;    ///< JSON key, with the unit
  std::string_view option; ///< command line option, without the dashes
  std::string_view unit;   ///< "mm", "mm/min", "mm/s²", "r/min", "%", "°"
  std::string_view what;   ///< what it is, in English
  double Recipe::*member;
  double least;
  double most;
};

/// A choice of the recipe between words.
struct ChoiceField {
  std::string_view key;
  std::string_view option;
  std::string_view what;
  std::vector<std::string_view> words;
  int (*get)(const Recipe&); ///< index into words; −1: not chosen (units only)
  void (*set)(Recipe&, int); ///< index into words; −1 where `get` can give it
};

/// A place on the table: X and Y, each within ±`kFarthestPlace`. Not given: chosen by the program.
struct PlaceField {
  std::string_view key;
  std::string_view option;
  std::string_view what;
  std::optional<Eigen::Vector2d> Recipe::*member;
};

/// A list of names; on the command line the option is repeated.
struct ListField {
  std::string_view key;
  std::string_view option;
  std::string_view what;
  std::vector<std::string> Recipe::*member;
};

/// Yes or no; on the command line the option alone means yes.
struct FlagField {
  std::string_view key;
  std::string_view option;
  std::string_view what;
  bool Recipe::*member;
};

inline constexpr double kFarthestPlace = 100000; ///< mm

[[nodiscard]] std::span<const NumberField> numberFields();
[[nodiscard]] const NumberField& numberField(double Recipe::*member); ///< every number of the recipe has one
[[nodiscard]] std::span<const ChoiceField> choiceFields();
[[nodiscard]] std::span<const PlaceField> placeFields();
[[nodiscard]] std::span<const ListField> listFields();
[[nodiscard]] std::span<const FlagField> flagFields();

/// Keys of what two recipes differ in, in the order of the tables.
[[nodiscard]] std::vector<std::string_view> differences(const Recipe& a, const Recipe& b);

/// Whether a value is the technologist's, which a code can protect: accelerations and how corners are taken.
[[nodiscard]] bool isEngineering(std::string_view key);

/// A number of the machine.
struct MachineNumberField {
  std::string_view key;
  std::string_view unit;
  std::string_view what;
  double Machine::*member;
  double least;
  double most;
};

/// Three numbers of the machine, for X, Y and Z.
struct MachineAxesField {
  std::string_view key;
  std::string_view unit;
  std::string_view what;
  Eigen::Vector3d Machine::*member;
  double least;
  double most;
};

/// Yes or no of the machine.
struct MachineFlagField {
  std::string_view key;
  std::string_view what;
  bool Machine::*member;
};

[[nodiscard]] std::span<const MachineNumberField> machineNumberFields();
[[nodiscard]] std::span<const MachineAxesField> machineAxesFields();
[[nodiscard]] std::span<const MachineFlagField> machineFlagFields();

/// An error for a value that is not finite or outside its range: it names the field, value, unit and range.
[[nodiscard]] std::optional<base::Problem> checkRange(std::string_view name, double value, double least, double most,
                                                      std::string_view unit);

/// Every wrong value of a recipe, named by its key, as far as a recipe alone shows it.
[[nodiscard]] base::Problems check(const Recipe& recipe);

/// Every wrong value of a recipe for this machine: accelerations are not above the machine's.
[[nodiscard]] base::Problems check(const Recipe& recipe, const Machine& machine);

/// Every wrong value of a machine; the park position lies inside the travel.
[[nodiscard]] base::Problems check(const Machine& machine);

} // namespace arris::recipe
