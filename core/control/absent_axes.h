#pragma once

#include "core/control/axis_driver.h"

#include <limits>

namespace arris::control {

/// Stands where the axes of a real machine are not to be had: they take no set-point, report nothing, and no drive is
/// ever ready. A controller on them moves nothing, and pretends nothing.
class AbsentAxes final : public AxisDriver {
public:
  [[nodiscard]] Feedback read() override {
    return {};
  }

  bool write(const Eigen::Vector3d& /*setPoint*/, const Outputs& /*outputs*/) override {
    return false;
  }

  [[nodiscard]] int queued() override {
    return std::numeric_limits<int>::max(); // there is never room
  }
};

} // namespace arris::control
