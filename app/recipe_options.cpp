#include "app/recipe_options.h"

#include "core/base/numbers.h"
#include "core/recipe/fields.h"

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace arris::app {
namespace {

using base::Code;
using base::Problem;
using base::Problems;
using recipe::ChoiceField;
using recipe::NumberField;
using recipe::PlaceField;
using recipe::Recipe;
using Options = std::map<std::string, const CLI::Option*, std::less<>>;

constexpr const char* kRecipeGroup = "Recipe";

/// What an option was given as; nothing where it was not.
std::optional<std::string> given(const Options& options, std::string_view option) {
  const auto found = options.find(option);
  if (found == options.end() || found->second->count() == 0) {
    return std::nullopt;
  }
  return found->second->results().front();
}

std::string dashed(std::string_view option) {
  return fmt::format("--{}", option);
}

Problem wrongType(std::string_view option, const std::string& expected, const std::string& text) {
  return Problem(Code::ValueWrongType,
                 {{"name", dashed(option)}, {"expected", expected}, {"value", fmt::format("\"{}\"", text)}});
}

std::optional<double> finiteNumber(std::string_view text) {
  const auto number = base::parseNumber<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<Eigen::Vector2d> place(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) {
    return std::nullopt;
  }
  const auto x = finiteNumber(text.substr(0, comma));
  const auto y = finiteNumber(text.substr(comma + 1));
  return x && y ? std::optional(Eigen::Vector2d(*x, *y)) : std::nullopt;
}

void applyNumbers(const Options& options, Recipe& recipe, Problems& problems) {
  for (const NumberField& field : recipe::numberFields()) {
    if (const auto text = given(options, field.option)) {
      if (const auto number = finiteNumber(*text)) {
        recipe.*field.member = *number;
      } else {
        problems.push_back(wrongType(
            field.option,
            fmt::format("a number from {} to {} {} with a decimal point", field.least, field.most, field.unit), *text));
      }
    }
  }
}

void applyChoices(const Options& options, Recipe& recipe, Problems& problems) {
  for (const ChoiceField& field : recipe::choiceFields()) {
    if (const auto text = given(options, field.option)) {
      const auto word = std::find(field.words.begin(), field.words.end(), *text);
      if (word != field.words.end()) {
        field.set(recipe, static_cast<int>(word - field.words.begin()));
      } else {
        problems.emplace_back(Code::ValueNotAChoice,
                              std::vector<base::Value>{{"name", dashed(field.option)},
                                                       {"value", *text},
                                                       {"choices", fmt::format("{}", fmt::join(field.words, ", "))}});
      }
    }
  }
}

void applyPlaces(const Options& options, Recipe& recipe, Problems& problems) {
  for (const PlaceField& field : recipe::placeFields()) {
    if (const auto text = given(options, field.option)) {
      if (const auto point = place(*text)) {
        recipe.*field.member = point;
      } else {
        problems.push_back(wrongType(
            field.option, fmt::format("X,Y in mm, each from {} to {}", -recipe::kFarthestPlace, recipe::kFarthestPlace),
            *text));
      }
    }
  }
}

void applyListsAndFlags(const Options& options, Recipe& recipe) {
  for (const recipe::ListField& field : recipe::listFields()) {
    if (given(options, field.option)) {
      recipe.*field.member = options.find(field.option)->second->results();
    }
  }
  for (const recipe::FlagField& field : recipe::flagFields()) {
    if (given(options, field.option)) {
      recipe.*field.member = options.find(field.option)->second->as<bool>();
    }
  }
}

/// The option in the place of the key in a problem's `name`, where the value came from the command line.
template <typename Fields> void nameByOption(Problem& problem, const Fields& fields, const Options& options) {
  const auto value = std::find_if(problem.values.begin(), problem.values.end(),
                                  [](const base::Value& candidate) { return candidate.name == "name"; });
  if (value == problem.values.end()) {
    return;
  }
  auto& name = std::get<std::string>(value->value);
  for (const auto& field : fields) {
    const std::string_view axis = std::string_view(name).substr(std::min(field.key.size(), name.size()));
    if (name.starts_with(field.key) && (axis.empty() || axis.starts_with(' ')) && given(options, field.option)) {
      name = dashed(field.option) + std::string(axis);
      return;
    }
  }
}

/// The unit without signs that would upset the columns of the help.
std::string plainUnit(std::string_view unit) {
  return unit == "mm/s²" ? "mm/s2" : unit == "°" ? "deg" : std::string(unit);
}

std::string range(const NumberField& field) {
  return fmt::format("{} ({} to {} {}, default {})", field.what, field.least, field.most, field.unit,
                     Recipe{}.*field.member);
}

std::string words(const ChoiceField& field) {
  const int standard = field.get(Recipe{});
  return fmt::format("{} ({}{})", field.what, fmt::join(field.words, ", "),
                     standard < 0 ? "" : fmt::format("; default {}", field.words[static_cast<std::size_t>(standard)]));
}

} // namespace

RecipeOptions::RecipeOptions(CLI::App& call, const std::vector<std::string_view>& only) {
  const auto add = [&](std::string_view option, const std::string& what, const std::string& argument) {
    if (!only.empty() && std::find(only.begin(), only.end(), option) == only.end()) {
      return static_cast<CLI::Option*>(nullptr);
    }
    CLI::Option* added = argument.empty() ? call.add_flag(dashed(option))
                                          : call.add_option(dashed(option))->type_name(argument)->expected(1);
    m_options[std::string(option)] = added->description(what)->group(kRecipeGroup);
    return added;
  };
  for (const NumberField& field : recipe::numberFields()) {
    add(field.option, range(field), plainUnit(field.unit));
  }
  for (const ChoiceField& field : recipe::choiceFields()) {
    add(field.option, words(field), "WORD");
  }
  for (const PlaceField& field : recipe::placeFields()) {
    add(field.option, fmt::format("{}, mm on the table", field.what), "X,Y");
  }
  for (const recipe::ListField& field : recipe::listFields()) {
    if (CLI::Option* option = add(field.option, fmt::format("{}; may be repeated", field.what), "NAME")) {
      option->take_all()->allow_extra_args(false);
    }
  }
  for (const recipe::FlagField& field : recipe::flagFields()) {
    add(field.option, std::string(field.what), "");
  }
}

Problems RecipeOptions::applyTo(Recipe& recipe, const recipe::Machine& machine) const {
  Problems problems;
  applyNumbers(m_options, recipe, problems);
  applyChoices(m_options, recipe, problems);
  applyPlaces(m_options, recipe, problems);
  applyListsAndFlags(m_options, recipe);
  for (Problem& problem : recipe::check(recipe, machine)) {
    nameByOption(problem, recipe::numberFields(), m_options);
    nameByOption(problem, recipe::placeFields(), m_options);
    problems.push_back(std::move(problem));
  }
  return problems;
}

} // namespace arris::app
