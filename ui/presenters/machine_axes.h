#pragma once

#include "core/base/problem.h"
#include "core/control/simulated_axes.h"
#include "core/files/settings_json.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace arris::ui {

/// The axes that a machine is driven by, or what stands in for them.
struct MachineAxes {
  std::unique_ptr<control::AxisDriver> driver;
  control::SimulatedAxes* simulated = nullptr; ///< the driver, where it is these
  std::optional<base::Problem> absence;        ///< why real axes are not there: nothing can be moved then
  control::Pace pace = control::Pace::Real;    ///< whose time they keep
};

/// Simulated axes in the middle of their travel, at that pace, or those of the HAL session that runs, in real time; the
/// module for these is looked for in the folders. Where they are not available nothing takes their place: the axes are
/// absent. May wait for a second or two.
[[nodiscard]] MachineAxes makeAxes(files::Axes which, const recipe::Machine& machine, control::Pace pace,
                                   const std::vector<std::filesystem::path>& moduleFolders);

} // namespace arris::ui
