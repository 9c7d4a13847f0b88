#pragma once

#include "core/files/recipe_json.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace arris::files {

// Recipes that have names: a folder of recipe files, each NAME.json.

inline constexpr std::string_view kRecipeEnding = ".json";
inline constexpr std::size_t kLongestRecipeName = 200; ///< bytes; file systems take 255 with what is added to it

/// Whether a recipe can have this name: UTF-8, not empty, none of '/', '\\' and control characters, no dot before and
/// no space before or after it.
[[nodiscard]] bool isRecipeName(std::string_view name);

struct NamedRecipe {
  std::string name;
  recipe::Recipe recipe;
  bool operator==(const NamedRecipe&) const = default;
};

using NamedRecipes = std::vector<NamedRecipe>;

/// Those of a folder, by thickness of the glass and then by name; none where there is no such folder. A damaged one is
/// set aside and told among the problems; what is no recipe by its name is passed over.
[[nodiscard]] Read<NamedRecipes> readRecipes(const std::filesystem::path& folder);

/// Keeps a recipe under a name that can be one, over an earlier one; CannotWrite with the reason.
[[nodiscard]] base::Expected<void> keepRecipe(const std::filesystem::path& folder, const NamedRecipe& recipe);

/// CannotWrite with the reason, also where there is none of this name.
[[nodiscard]] base::Expected<void> removeRecipe(const std::filesystem::path& folder, std::string_view name);

/// The recipe of a file with what is wrong with it: CannotOpen, CannotRead, and what `readRecipe` tells.
[[nodiscard]] Read<recipe::Recipe> readRecipeFile(const std::filesystem::path& file);

} // namespace arris::files
