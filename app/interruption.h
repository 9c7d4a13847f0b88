#pragma once

namespace arris::app {

/// From here on the first SIGINT or SIGTERM only sets a mark, so that no half-written file is left; a second one ends
/// the program at once.
void watchForInterruption();

/// Whether that has happened.
[[nodiscard]] bool interrupted();

} // namespace arris::app
