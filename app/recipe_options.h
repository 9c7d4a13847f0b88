#pragma once

#include "core/base/problem.h"
#include "core/recipe/recipe.h"

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace arris::app {

/// The values of the recipe as options of a call: names, units and ranges come from the tables of fields.
class RecipeOptions {
public:
  /// Adds an option to `call` for every field, or for those named only. `call` must outlive this object.
  explicit RecipeOptions(CLI::App& call, const std::vector<std::string_view>& only = {});

  /// Puts what was given over `recipe` and checks the whole for `machine`. Errors name the option where the value came
  /// from one, and the key where it came from a file.
  [[nodiscard]] base::Problems applyTo(recipe::Recipe& recipe, const recipe::Machine& machine) const;

private:
  std::map<std::string, const CLI::Option*, std::less<>> m_options; ///< by name, without the dashes
};

} // namespace arris::app
