// Drives the axes through HAL until it is killed: arris_hal_writer MODULE_FOLDER. X speeds up to 180 mm/s and stays so,
// Y swings; one line on stdout says when X has its speed.

#include "core/control/driver_module.h"
#include "tests/core/control/linuxcnc/paced_axes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

int main(int argc, char** argv) {
  using namespace arris;
  const recipe::Machine machine;
  auto axes = control::linuxcncAxes(machine, {argc > 1 ? argv[1] : "."});
  if (!axes) {
    std::fprintf(stderr, "%s\n", base::describe(axes.error()).c_str());
    return 1;
  }
  test::PacedAxes paced(std::move(*axes), 30);
  control::Outputs outputs;
  const Eigen::Vector3d start = paced.read().position;
  const auto period = [&](const Eigen::Vector3d& way) {
    outputs.heartbeat = !outputs.heartbeat;
    return paced.write(start + way, outputs) && paced.read().inputs.driveReady[0];
  };
  period({0, 0, 0});
  outputs.driveEnable.fill(true);
  while (!period({0, 0, 0})) {
  }
  constexpr double kSpeed = 180, kAcceleration = 400, kSwing = 20, kFrequency = 4;
  for (int k = 0;; ++k) {
    const double t = k * machine.period;
    const double faster = std::min(t, kSpeed / kAcceleration);
    const double x = kAcceleration * faster * faster / 2 + kSpeed * (t - faster);
    if (!period({x, kSwing * (1 - std::cos(kFrequency * t)), 0})) {
      return 2;
    }
    if (k == 1000) {
      std::puts("moving");
      std::fflush(stdout);
    }
  }
}
