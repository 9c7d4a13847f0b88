#pragma once

#include "core/base/problem.h"
#include "core/control/axis_driver.h"
#include "core/recipe/recipe.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

namespace arris::control {

/// The module that drives axes through LinuxCNC's HAL, and the function that it exports. It is loaded at run time, so
/// that Arris runs where there is no LinuxCNC; of core it shares the headers only.
inline constexpr const char* kLinuxcncModule = "libarris_linuxcnc.so";
inline constexpr const char* kMakeLinuxcncAxes = "arrisMakeLinuxcncAxes";

/// Makes the driver; null, and the reason in English in `reason` (of `size` bytes, ended by NUL), where that cannot be.
/// `version` is that of the program that asks; it must be the module's own.
using MakeAxisDriver = AxisDriver*(const char* version, const recipe::Machine& machine, char* reason, std::size_t size);

/// The axes of the HAL session that runs on this machine, by the module in the first of the folders that has it.
/// `DriverNotAvailable`, with the reason and what to do, where the module is missing or does not fit, no HAL session
/// runs, or the session does not suit Arris or the machine. May wait for a second or two.
[[nodiscard]] base::Expected<std::unique_ptr<AxisDriver>>
linuxcncAxes(const recipe::Machine& machine, const std::vector<std::filesystem::path>& folders);

} // namespace arris::control
