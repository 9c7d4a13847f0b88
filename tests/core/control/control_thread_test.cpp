// The controller on its thread, beside a busy operator's side.

#include "core/control/control_thread.h"
#include "core/control/simulated_axes.h"
#include "core/control/supervisor.h"
#include "tests/support/panes.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace arris::control {
namespace {

/// Simulated axes that remember the last outputs.
class WatchedAxes final : public AxisDriver {
public:
  explicit WatchedAxes(const recipe::Machine& machine) : m_axes(machine, Pace::Real, {0, 0, 120}) {}

  Feedback read() override {
    return m_axes.read();
  }

  bool write(const Eigen::Vector3d& setPoint, const Outputs& outputs) override {
    last = outputs;
    return m_axes.write(setPoint, outputs);
  }

  int queued() override {
    return m_axes.queued();
  }

  Outputs last; ///< of the thread; to be read once it has ended

private:
  SimulatedAxes m_axes;
};

void pause() {
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

TEST(ControlThread, RunsTheControllerBesideABusyOperatorAndSwitchesTheDrivesOffHoweverItEnds) {
  recipe::Machine machine;
  machine.setPointLead = 0.2; // a busy computer wakes the thread late
  recipe::Recipe recipe;
  recipe.accelX = recipe.accelY = recipe.accelZ = 500;
  const auto job = std::make_shared<const job::Job>(job::planJob(test::triangle600(), recipe, machine));
  Channels channels;
  Controller controller(machine, channels);
  WatchedAxes axes(machine);
  std::int64_t reports = 0;
  std::int64_t ran = 0;
  bool inOrder = true;
  Supervisor supervisor(machine, channels,
                        {[&](const Report& report) {
                           inOrder = inOrder && report.tick == reports;
                           ++reports;
                           ran = std::max(ran, report.runTick);
                         },
                         {}});
  {
    const ControlThread thread(controller, axes, machine.period);
    double factor = 0.1;
    while (ran < 300) { // periods of the run
      supervisor.serve();
      supervisor.setOverride(factor = factor < 1.4 ? factor + 0.01 : 0.1);
      const Report& report = supervisor.latest();
      ASSERT_FALSE(report.faults.any());
      if (report.state == State::Off) {
        supervisor.enable();
      } else if (report.state == State::NotHomed && report.drivesReady) {
        supervisor.home();
      } else if (report.state == State::Idle && report.homed && report.program == 0) {
        supervisor.load(job);
        supervisor.start();
      }
      pause();
    }
    supervisor.stop();
    while (supervisor.latest().state != State::Idle) {
      supervisor.serve();
      pause();
    }
  }
  EXPECT_TRUE(inOrder) << "a report was lost or came twice";
  EXPECT_EQ(axes.last, Outputs{});
}

} // namespace
} // namespace arris::control
