#pragma once

#include "app/exit_status.h"
#include "core/base/problem.h"

#include <span>
#include <string_view>

namespace arris::app {

/// A line on stderr for each problem: severity, place, sentence and code; `frame` says which coordinates the places
/// have.
void tell(std::span<const base::Problem> problems, std::string_view frame = "in the drawing");

/// One line on stderr, after the name of the program: for what has no code.
void complain(std::string_view words);

/// The status to end with when this problem of a file or value stops the program.
[[nodiscard]] ExitStatus statusFor(const base::Problem& problem);

/// Tells the problems; the status to end with where there is an error among them, else Done.
[[nodiscard]] ExitStatus tellAndJudge(const base::Problems& problems);

} // namespace arris::app
