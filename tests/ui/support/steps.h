#pragma once

#include "tests/support/scratch.h"
#include "ui/presenters/machine_link.h"

namespace arris::test {

inline constexpr int kPatience = 60000; ///< ms; only a failing test waits as long

/// A planner's steps that read no files: the name of the file chooses the pane (see panes.h): "triangle.dxf",
/// "rectangle.dxf", "outside.dxf" (leaves the travel), "many.dxf" (forty corners), "splashback.dxf" (the sample),
/// "repaired.dxf" (the triangle with a gap that was closed); any other cannot be opened.
[[nodiscard]] ui::PlannerSteps paneSteps();

/// The simulated machine in its own time, as fast as it can; what it keeps goes into the folder.
[[nodiscard]] ui::MachineSetup fastMachine(const Scratch& folder);

} // namespace arris::test
