#pragma once

#include "app/exit_status.h"
#include "app/recipe_options.h"
#include "core/pattern/pattern.h"
#include "core/recipe/recipe.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace arris::app {

/// A value, or the status to end with; what was wrong has been told then.
template <typename T> using OrStatus = tl::expected<T, ExitStatus>;

/// The bytes of a file.
[[nodiscard]] OrStatus<std::string> load(const std::filesystem::path& file);

struct Settings {
  recipe::Recipe recipe;
  recipe::Machine machine;
};

/// Defaults, then the files (an empty path: none), then the options; checked for each other. Warnings are told.
[[nodiscard]] OrStatus<Settings> loadSettings(const std::filesystem::path& recipeFile,
                                              const std::filesystem::path& machineFile, const RecipeOptions& options);

/// The drawing in the bytes of a file, with whatever problems it has.
[[nodiscard]] pattern::Pattern patternIn(std::string_view bytes, const recipe::Recipe& recipe);

/// The drawing in a file, with whatever problems it has.
[[nodiscard]] OrStatus<pattern::Pattern> loadPattern(const std::filesystem::path& file, const recipe::Recipe& recipe);

} // namespace arris::app
