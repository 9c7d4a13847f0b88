#include "app/inputs.h"

#include "app/messages.h"
#include "core/files/recipe_json.h"
#include "core/files/whole_file.h"

#include <string>

namespace arris::app {
namespace {

namespace fs = std::filesystem;

/// A settings file read by `read`; the defaults where no file is named.
template <typename T>
OrStatus<T> loadJson(const fs::path& file, files::Read<T> (*read)(std::string_view, std::string_view, const T&)) {
  if (file.empty()) {
    return T{};
  }
  return load(file).and_then([&](const std::string& text) -> OrStatus<T> {
    files::Read<T> result = read(text, file.string(), T{});
    const ExitStatus status = tellAndJudge(result.problems);
    if (status != ExitStatus::Done) {
      return tl::unexpected(status);
    }
    return std::move(result.value);
  });
}

} // namespace

OrStatus<std::string> load(const fs::path& file) {
  auto text = files::readFile(file);
  if (!text) {
    return tl::unexpected(tellAndJudge({text.error()}));
  }
  return *std::move(text);
}

OrStatus<Settings> loadSettings(const fs::path& recipeFile, const fs::path& machineFile, const RecipeOptions& options) {
  auto machine = loadJson<recipe::Machine>(machineFile, files::readMachine);
  if (!machine) {
    return tl::unexpected(machine.error());
  }
  auto recipe = loadJson<recipe::Recipe>(recipeFile, files::readRecipe);
  if (!recipe) {
    return tl::unexpected(recipe.error());
  }
  const ExitStatus status = tellAndJudge(options.applyTo(*recipe, *machine));
  if (status != ExitStatus::Done) {
    return tl::unexpected(status);
  }
  return Settings{*std::move(recipe), *std::move(machine)};
}

pattern::Pattern patternIn(std::string_view bytes, const recipe::Recipe& recipe) {
  return pattern::readDxf(bytes, pattern::importOptions(recipe));
}

OrStatus<pattern::Pattern> loadPattern(const fs::path& file, const recipe::Recipe& recipe) {
  return load(file).map([&](const std::string& bytes) { return patternIn(bytes, recipe); });
}

} // namespace arris::app
