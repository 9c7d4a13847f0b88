#pragma once

#include "core/job/job.h"
#include "core/pattern/pattern.h"

#include <optional>
#include <string>
#include <string_view>

namespace arris::test {

/// A recipe of which the last byte of a file decides something, so that a fuzzer can vary it while the file stays a
/// drawing (what follows its EOF is not read). After a line feed it is the default.
[[nodiscard]] recipe::Recipe recipeFor(std::string_view file);

/// A machine with the longest travel that a machine can have.
[[nodiscard]] recipe::Machine largeMachine();

// What a user relies on whatever the drawing is: the first promise that is broken, in words; nothing where all are
// kept.

/// Every problem is told in full and none is internal; what has no errors is closed contours.
[[nodiscard]] std::optional<std::string> brokenPromise(const pattern::Pattern& pattern);

/// Every problem is told in full and none is internal; what can be ground is a way without gaps and jumps from park
/// position to park position, in finite time, on which the wheel does not cut into the finished contour.
[[nodiscard]] std::optional<std::string> brokenPromise(const job::Job& job);

} // namespace arris::test
