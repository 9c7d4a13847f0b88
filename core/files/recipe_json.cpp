#include "core/files/recipe_json.h"

#include "core/files/json.h"
#include "core/recipe/fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>

namespace arris::files {
namespace {

using base::Code;
using base::Problem;
using base::Problems;
using recipe::Machine;
using recipe::Recipe;

constexpr std::string_view kRecipeKey = "arris_recipe";
constexpr std::string_view kMachineKey = "arris_machine";
constexpr int kRecipeVersion = 1;
constexpr int kMachineVersion = 1;

template <typename Field> const Field* find(std::span<const Field> fields, std::string_view key) {
  const auto field = std::find_if(fields.begin(), fields.end(), [key](const Field& f) { return f.key == key; });
  return field == fields.end() ? nullptr : &*field;
}

/// Sets the members of a recipe or machine from JSON values and gathers what is wrong.
class Setter {
public:
  explicit Setter(Problems& problems) : m_problems(problems) {}

  void number(double& member, std::string_view key, std::string_view unit, const Json& value) {
    if (value.is_number()) {
      member = value.get<double>();
    } else {
      m_problems.push_back(notANumber(key, unit, value));
    }
  }

  template <int Size>
  void numbers(Eigen::Matrix<double, Size, 1>& member, std::string_view key, std::string_view unit,
               std::string_view form, const Json& value) {
    const auto isNumber = [](const Json& element) { return element.is_number(); };
    if (!value.is_array() || value.size() != Size || !std::all_of(value.begin(), value.end(), isNumber)) {
      m_problems.push_back(wrongType(key, fmt::format("{} in {}", form, unit), value));
      return;
    }
    for (int i = 0; i < Size; ++i) {
      member[i] = value[static_cast<std::size_t>(i)].get<double>();
    }
  }

  void choice(Recipe& recipe, const recipe::ChoiceField& field, const Json& value) {
    const std::string choices = fmt::format("{}", fmt::join(field.words, ", "));
    if (!value.is_string()) {
      m_problems.push_back(wrongType(field.key, "one of: " + choices, value));
      return;
    }
    const auto word = std::find(field.words.begin(), field.words.end(), value.get<std::string>());
    if (word == field.words.end()) {
      m_problems.push_back(Problem(Code::ValueNotAChoice,
                                   {{"name", std::string(field.key)}, {"value", bare(value)}, {"choices", choices}}));
      return;
    }
    field.set(recipe, static_cast<int>(word - field.words.begin()));
  }

  void list(std::vector<std::string>& member, std::string_view key, const Json& value) {
    const auto isString = [](const Json& element) { return element.is_string(); };
    if (!value.is_array() || !std::all_of(value.begin(), value.end(), isString)) {
      m_problems.push_back(wrongType(key, "a list of names", value));
      return;
    }
    member = value.get<std::vector<std::string>>();
  }

  void flag(bool& member, std::string_view key, const Json& value) {
    if (value.is_boolean()) {
      member = value.get<bool>();
    } else {
      m_problems.push_back(wrongType(key, "true or false", value));
    }
  }

private:
  Problems& m_problems;
};

// False for a key that is not of a recipe.
bool setRecipe(Recipe& recipe, std::string_view key, const Json& value, Problems& problems) {
  Setter set(problems);
  if (const auto* number = find(recipe::numberFields(), key)) {
    set.number(recipe.*number->member, key, number->unit, value);
  } else if (const auto* choice = find(recipe::choiceFields(), key)) {
    set.choice(recipe, *choice, value);
  } else if (const auto* place = find(recipe::placeFields(), key)) {
    Eigen::Vector2d point(0, 0);
    set.numbers<2>(point, key, "mm", "[x, y]", value);
    recipe.*place->member = point;
  } else if (const auto* list = find(recipe::listFields(), key)) {
    set.list(recipe.*list->member, key, value);
  } else if (const auto* flag = find(recipe::flagFields(), key)) {
    set.flag(recipe.*flag->member, key, value);
  } else {
    return false;
  }
  return true;
}

// False for a key that is not of a machine.
bool setMachine(Machine& machine, std::string_view key, const Json& value, Problems& problems) {
  Setter set(problems);
  if (const auto* number = find(recipe::machineNumberFields(), key)) {
    set.number(machine.*number->member, key, number->unit, value);
  } else if (const auto* axes = find(recipe::machineAxesFields(), key)) {
    set.numbers<3>(machine.*axes->member, key, axes->unit, "[x, y, z]", value);
  } else if (const auto* flag = find(recipe::machineFlagFields(), key)) {
    set.flag(machine.*flag->member, key, value);
  } else {
    return false;
  }
  return true;
}

void append(Problems& problems, Problems more) {
  std::move(more.begin(), more.end(), std::back_inserter(problems));
}

template <typename T, typename SetMember>
void setMembers(const Json& object, std::string_view file, T& value, Problems& problems, std::string_view versionKey,
                SetMember setMember) {
  for (const auto& [key, member] : object.items()) {
    if (key != versionKey && !setMember(value, key, member, problems)) {
      problems.push_back(Problem(Code::UnknownKey, {{"file", std::string(file)}, {"key", key}}));
    }
  }
  append(problems, recipe::check(value));
}

template <typename T>
Read<T> read(std::string_view text, std::string_view file, const T& defaults, std::string_view versionKey, int known) {
  Read<T> result{defaults, {}};
  const auto object = parseVersioned(text, versionKey, known, file);
  if (!object) {
    result.problems.push_back(object.error());
    return result;
  }
  readMembers(*object, file, result.value, result.problems, versionKey);
  return result;
}

template <typename T> std::string write(std::string_view versionKey, int version, const T& value) {
  JsonWriter json;
  json.openObject();
  json.member(versionKey, version);
  writeMembers(json, value);
  json.close();
  return json.take();
}

} // namespace

void writeMembers(JsonWriter& json, const Recipe& recipe) {
  for (const auto& field : recipe::numberFields()) {
    json.member(field.key, recipe.*field.member);
  }
  for (const auto& field : recipe::choiceFields()) {
    if (const int index = field.get(recipe); index >= 0) {
      json.member(field.key, field.words[static_cast<std::size_t>(index)]);
    }
  }
  for (const auto& field : recipe::placeFields()) {
    if (const auto& place = recipe.*field.member) {
      json.member(field.key, *place);
    }
  }
  for (const auto& field : recipe::listFields()) {
    if (const auto& list = recipe.*field.member; !list.empty()) {
      json.member(field.key, std::span(list));
    }
  }
  for (const auto& field : recipe::flagFields()) {
    json.member(field.key, recipe.*field.member);
  }
}

void writeMembers(JsonWriter& json, const Machine& machine) {
  for (const auto& field : recipe::machineAxesFields()) {
    const Eigen::Vector3d& axes = machine.*field.member;
    json.member(field.key, std::span<const double>(axes.data(), 3));
  }
  for (const auto& field : recipe::machineNumberFields()) {
    json.member(field.key, machine.*field.member);
  }
  for (const auto& field : recipe::machineFlagFields()) {
    json.member(field.key, machine.*field.member);
  }
}

void writeSettings(JsonWriter& json, const Recipe& recipe, const Machine& machine) {
  json.openObject("recipe");
  writeMembers(json, recipe);
  json.close();
  json.openObject("machine");
  writeMembers(json, machine);
  json.close();
}

void readMembers(const Json& object, std::string_view file, Recipe& recipe, Problems& problems,
                 std::string_view versionKey) {
  setMembers(object, file, recipe, problems, versionKey, setRecipe);
}

void readMembers(const Json& object, std::string_view file, Machine& machine, Problems& problems,
                 std::string_view versionKey) {
  setMembers(object, file, machine, problems, versionKey, setMachine);
}

std::string writeRecipe(const Recipe& recipe) {
  return write(kRecipeKey, kRecipeVersion, recipe);
}

std::string writeMachine(const Machine& machine) {
  return write(kMachineKey, kMachineVersion, machine);
}

Read<Recipe> readRecipe(std::string_view text, std::string_view file, const Recipe& defaults) {
  return read(text, file, defaults, kRecipeKey, kRecipeVersion);
}

Read<Machine> readMachine(std::string_view text, std::string_view file, const Machine& defaults) {
  return read(text, file, defaults, kMachineKey, kMachineVersion);
}

} // namespace arris::files
