#include "core/files/recipe_folder.h"

#include "core/base/utf8.h"
#include "core/files/descriptor.h"
#include "core/files/set_aside.h"
#include "core/files/whole_file.h"

#include <algorithm>
#include <tuple>

namespace arris::files {
namespace {

namespace fs = std::filesystem;

fs::path fileOf(const fs::path& folder, std::string_view name) {
  return folder / (std::string(name) + std::string(kRecipeEnding));
}

// Of a folder's entry; empty where it is no recipe.
std::string recipeNameOf(const fs::directory_entry& entry) {
  std::error_code gone;
  const std::string name = entry.path().stem().string();
  const bool isRecipe = entry.path().extension() == kRecipeEnding && isRecipeName(name) && entry.is_regular_file(gone);
  return isRecipe ? name : std::string();
}

void take(Read<NamedRecipes>& read, const fs::path& file, std::string name) {
  Read<recipe::Recipe> recipe = readRecipeFile(file);
  if (!base::hasErrors(recipe.problems)) {
    read.value.push_back({std::move(name), std::move(recipe.value)});
    return;
  }
  read.problems.insert(read.problems.end(), recipe.problems.begin(), recipe.problems.end());
  read.problems.push_back(setAsideAndTell(file));
}

} // namespace

bool isRecipeName(std::string_view name) {
  const auto isForbidden = [](char c) { return c == '/' || c == '\\' || (c >= 0 && c < ' ') || c == '\x7f'; };
  return !name.empty() && name.size() <= kLongestRecipeName && base::isUtf8(name) && name.front() != '.' &&
         name.front() != ' ' && name.back() != ' ' && std::none_of(name.begin(), name.end(), isForbidden);
}

Read<NamedRecipes> readRecipes(const fs::path& folder) {
  Read<NamedRecipes> read;
  std::error_code error;
  if (!fs::exists(folder, error)) {
    return read;
  }
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    if (std::string name = recipeNameOf(*entry); !name.empty()) {
      take(read, entry->path(), std::move(name));
    }
  }
  if (error) {
    read.problems.push_back(systemProblem(base::Code::CannotRead, folder, error.value()));
  }
  std::sort(read.value.begin(), read.value.end(), [](const NamedRecipe& a, const NamedRecipe& b) {
    return std::tie(a.recipe.thickness, a.name) < std::tie(b.recipe.thickness, b.name);
  });
  return read;
}

base::Expected<void> keepRecipe(const fs::path& folder, const NamedRecipe& recipe) {
  std::error_code failure;
  fs::create_directories(folder, failure); // where that fails the write tells why
  return writeWholeFile(fileOf(folder, recipe.name), writeRecipe(recipe.recipe));
}

base::Expected<void> removeRecipe(const fs::path& folder, std::string_view name) {
  const fs::path file = fileOf(folder, name);
  std::error_code failure;
  if (!fs::remove(file, failure)) {
    return base::Unexpected(systemProblem(base::Code::CannotWrite, file, failure ? failure.value() : ENOENT));
  }
  return {};
}

Read<recipe::Recipe> readRecipeFile(const fs::path& file) {
  const auto text = readFile(file);
  return text ? readRecipe(*text, file.string()) : Read<recipe::Recipe>{{}, {text.error()}};
}

} // namespace arris::files
