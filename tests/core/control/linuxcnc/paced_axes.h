#pragma once

#include "core/control/axis_driver.h"

#include <chrono>
#include <memory>
#include <thread>
#include <utility>

namespace arris::test {

/// Axes that let their writer wait until no more than `lead` set-points are ahead: so the writer goes at their pace.
class PacedAxes : public control::AxisDriver {
public:
  PacedAxes(std::unique_ptr<control::AxisDriver> axes, int lead) : m_axes(std::move(axes)), m_lead(lead) {}

  [[nodiscard]] control::Feedback read() override {
    return m_axes->read();
  }

  bool write(const Eigen::Vector3d& setPoint, const control::Outputs& outputs) override {
    while (m_axes->queued() >= m_lead) {
      std::this_thread::sleep_for(std::chrono::microseconds(300));
    }
    return m_axes->write(setPoint, outputs);
  }

  [[nodiscard]] int queued() override {
    return m_axes->queued();
  }

private:
  std::unique_ptr<control::AxisDriver> m_axes;
  int m_lead;
};

} // namespace arris::test
