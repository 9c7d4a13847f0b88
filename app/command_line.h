#pragma once

#include "app/exit_status.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace arris::app {

using Arguments = std::vector<std::string>;

/// Does what the arguments (without the program's name) ask for and tells the outcome.
[[nodiscard]] ExitStatus run(const Arguments& arguments);

/// Reads the arguments of one call. Where the call shall not go on (help was asked for, wrong usage) that has been
/// said already and the status to end with is returned.
[[nodiscard]] std::optional<ExitStatus> read(CLI::App& call, const Arguments& arguments);

// The calls; each takes the arguments after its name.
[[nodiscard]] ExitStatus openWindow(const Arguments& arguments);
[[nodiscard]] ExitStatus plan(const Arguments& arguments);
[[nodiscard]] ExitStatus runJob(const Arguments& arguments);
[[nodiscard]] ExitStatus inspect(const Arguments& arguments);
[[nodiscard]] ExitStatus plot(const Arguments& arguments);
[[nodiscard]] ExitStatus help(const Arguments& arguments);

} // namespace arris::app
