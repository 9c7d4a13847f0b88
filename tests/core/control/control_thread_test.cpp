// The controller on its thread, beside a busy operator's side.

#include "core/control/control_thread.h"
#include "core/control/simulated_axes.h"
#include "core/control/supervisor.h"
#include "tests/support/panes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace arris::control {
namespace {

/// Simulated axes that remember the last outputs, and can stop taking set-points as a driver does that hangs.
class WatchedAxes final : public AxisDriver {
public:
  explicit WatchedAxes(const recipe::Machine& machine) : m_axes(machine, Pace::Real, {0, 0, 120}) {}

  Feedback read() override {
    m_told = stalls ? m_told : m_axes.read();
    return m_told;
  }

  bool write(const Eigen::Vector3d& setPoint, const Outputs& outputs) override {
    last = outputs;
    return !stalls && m_axes.write(setPoint, outputs);
  }

  int queued() override {
    m_queued = stalls ? m_queued : m_axes.queued();
    return m_queued;
  }

  Outputs last; ///< of the thread; to be read once it has ended
  std::atomic<bool> stalls = false;

private:
  Feedback m_told;
  int m_queued = 0;
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

TEST(ControlThread, SeesAxesThatTakeNoMoreSetPointsAndTakesTheDrivesPower) {
  recipe::Machine machine;
  machine.setPointLead = 0.2;
  Channels channels;
  Controller controller(machine, channels);
  WatchedAxes axes(machine);
  Supervisor supervisor(machine, channels);
  const ControlThread thread(controller, axes, machine.period);
  const auto serveUntil = [&](auto isSo) {
    while (!isSo(supervisor.latest())) {
      supervisor.serve();
      pause();
    }
  };
  serveUntil([](const Report& report) { return report.tick > 0; });
  ASSERT_TRUE(supervisor.enable());
  serveUntil([](const Report& report) { return report.drivesReady; });
  ASSERT_TRUE(supervisor.home());
  serveUntil([](const Report& report) { return report.velocity.z() != 0; });
  axes.stalls = true;
  serveUntil([](const Report& report) { return report.faults.has(Fault::FeedbackLost); });
  EXPECT_EQ(supervisor.latest().state, State::Faulted);
  EXPECT_FALSE(supervisor.latest().outputs.driveEnable[2]);
  EXPECT_FALSE(supervisor.latest().homed);
}

} // namespace
} // namespace arris::control
