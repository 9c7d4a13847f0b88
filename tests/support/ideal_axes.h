#pragma once

#include "core/control/axis_driver.h"
#include "core/recipe/recipe.h"

#include <deque>

namespace arris::test {

/// Axes that are where their set-points say, the lead later, as long as their drives work, with spindle and coolant
/// that are there at once: for tests of the controller alone. Tests set what they want to go wrong in `inputs`;
/// reference switches, drives ready, spindle and coolant are added.
class IdealAxes : public control::AxisDriver {
public:
  /// `standsAt`: table coordinates at power-up, where the encoders read 0.
  IdealAxes(recipe::Machine machine, Eigen::Vector3d standsAt, int lead);

  [[nodiscard]] control::Feedback read() override;
  bool write(const Eigen::Vector3d& setPoint, const control::Outputs& outputs) override;
  [[nodiscard]] int queued() override;

  control::Inputs inputs;
  bool spindleWorks = true;
  bool coolantWorks = true;
  bool switchesWork = true;
  bool answers = true; ///< feedback goes on
  bool drivesWork = true;
  std::int64_t underruns = 0;

private:
  recipe::Machine m_machine;
  Eigen::Vector3d m_standsAt;
  int m_lead;
  std::deque<Eigen::Vector3d> m_queue;
  control::Feedback m_feedback;
  control::Feedback m_told;
  control::Outputs m_outputs;
};

} // namespace arris::test
