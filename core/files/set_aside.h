#pragma once

#include "core/base/problem.h"

#include <filesystem>

namespace arris::files {

/// Gives a file that cannot be read as what it should be another name in its folder, so that nothing of it is lost and
/// its own name is free: `counters.json` becomes `counters.json.damaged`, then `counters.json.2.damaged` and so on;
/// nothing that is there is overwritten. A link is renamed itself, not what it leads to. Returns where it went;
/// CannotWrite with the reason, and the file stays where it is, also where there is none.
[[nodiscard]] base::Expected<std::filesystem::path> setAside(const std::filesystem::path& file);

/// The same, and what to tell of it: FileSetAside, or why it could not be done.
[[nodiscard]] base::Problem setAsideAndTell(const std::filesystem::path& file);

} // namespace arris::files
