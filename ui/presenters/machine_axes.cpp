#include "ui/presenters/machine_axes.h"

#include "core/control/absent_axes.h"
#include "core/control/driver_module.h"

#include <utility>

namespace arris::ui {

MachineAxes makeAxes(files::Axes which, const recipe::Machine& machine, control::Pace pace,
                     const std::vector<std::filesystem::path>& moduleFolders) {
  if (which == files::Axes::Simulated) {
    auto simulated = std::make_unique<control::SimulatedAxes>(machine, pace, machine.travel / 2);
    control::SimulatedAxes* const axes = simulated.get();
    return {std::move(simulated), axes, std::nullopt, pace};
  }
  auto axes = control::linuxcncAxes(machine, moduleFolders);
  if (!axes) {
    return {std::make_unique<control::AbsentAxes>(), nullptr, axes.error(), control::Pace::Real};
  }
  return {*std::move(axes), nullptr, std::nullopt, control::Pace::Real};
}

} // namespace arris::ui
