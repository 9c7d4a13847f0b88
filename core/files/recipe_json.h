#pragma once

#include "core/recipe/recipe.h"

#include <string>
#include <string_view>

namespace arris::files {

/// A value read from a file and what was wrong there; usable unless there are errors among the problems.
template <typename T> struct Read {
  T value;
  base::Problems problems;
};

/// A recipe as a JSON file: every key in effect. What is left to the program (start, place, units, layers) is absent.
[[nodiscard]] std::string writeRecipe(const recipe::Recipe& recipe);

/// A recipe from the text of a JSON file: the keys that stand there, over `defaults`. Reports every wrong value by name
/// with its unit and range; an unknown key is a warning, a newer version is refused. `file` names it in the problems.
[[nodiscard]] Read<recipe::Recipe> readRecipe(std::string_view text, std::string_view file,
                                              const recipe::Recipe& defaults = {});

/// The same for the machine.
[[nodiscard]] std::string writeMachine(const recipe::Machine& machine);
[[nodiscard]] Read<recipe::Machine> readMachine(std::string_view text, std::string_view file,
                                                const recipe::Machine& defaults = {});

} // namespace arris::files
