// What the control loop does not do, in every state: allocate, free, lock.

#include "core/control/simulated_axes.h"
#include "tests/loop/counted_calls.h"
#include "tests/support/bench.h"
#include "tests/support/random_panes.h"

#include <gtest/gtest.h>

#include <memory>
#include <mutex>
#include <random>
#include <set>

namespace arris::test {
namespace {

using control::State;

// Without it a check that cannot fail would pass.
TEST(Counted, CallsAreSeen) {
  const Counting counting;
  const auto number = std::make_unique<int>(1);
  std::mutex mutex;
  mutex.lock();
  mutex.unlock();
  EXPECT_EQ(counting.calls().allocations, 1);
  EXPECT_EQ(counting.calls().locks, 1);
}

/// The loop of the controller with its driver, counted; the operator's side is not.
class CountedLoop {
public:
  explicit CountedLoop(const job::Job& job)
      : m_axes(job.machine, control::Pace::Simulated, {100, 200, 90}, {0, 0, 0}), m_controller(job.machine, m_channels),
        m_supervisor(job.machine, m_channels, {}, std::launch::deferred), m_job(std::make_shared<const job::Job>(job)) {
  }

  void period() {
    {
      const Counting counting;
      const control::Cycle& cycle = m_controller.advance(m_axes.read());
      m_axes.write(cycle.setPoint, cycle.outputs);
      m_calls.allocations += counting.calls().allocations;
      m_calls.frees += counting.calls().frees;
      m_calls.locks += counting.calls().locks;
    }
    m_seen.insert(m_controller.report().state);
    if (m_controller.report().tick % 10 == 0) {
      m_supervisor.serve();
    }
  }

  void runFor(double seconds) {
    for (double time = 0; time < seconds; time += 0.001) {
      period();
    }
    m_supervisor.serve();
  }

  /// Until the wheel has ground for a while.
  void onGlass() {
    const auto grinds = [this] {
      const control::Report& report = m_controller.report();
      return report.state == State::Running && report.place.segment > 4 && report.isInMotion;
    };
    for (int i = 0; i < 300'000 && !grinds(); ++i) {
      period();
    }
    runFor(0.5);
  }

  void expectNothing() const {
    EXPECT_EQ(m_calls.allocations, 0);
    EXPECT_EQ(m_calls.frees, 0);
    EXPECT_EQ(m_calls.locks, 0);
  }

  /// Every state that there is.
  void live() {
    std::mt19937 dice(3);
    runFor(0.1);
    m_supervisor.enable();
    runFor(0.2);
    m_supervisor.home();
    runFor(400);
    m_supervisor.jogAt({10, 10, 0});
    runFor(1);
    m_supervisor.load(m_job);
    m_supervisor.park();
    runFor(100);
    m_supervisor.setOverride(0.1);
    m_supervisor.start();
    onGlass();
    for (int i = 0; i < 20; ++i) {
      m_supervisor.setOverride(0.1 + 0.02 * i);
      m_supervisor.hold();
      runFor(8);
      m_supervisor.step(dice() % 2 == 0 ? -20 : 10);
      runFor(8);
      m_supervisor.resume();
      onGlass();
    }
    m_supervisor.stop();
    runFor(20);
    m_supervisor.startFrom(m_controller.report().place);
    onGlass();
    m_axes.inject(control::SimulatedFault::CoolantLoss);
    runFor(20);
    m_axes.clearFaults();
    m_supervisor.acknowledge();
    runFor(1);
    m_axes.inject(control::SimulatedFault::EmergencyStop);
    runFor(1);
  }

  [[nodiscard]] const std::set<State>& seen() const {
    return m_seen;
  }

private:
  control::Channels m_channels;
  control::SimulatedAxes m_axes;
  control::Controller m_controller;
  control::Supervisor m_supervisor;
  std::shared_ptr<const job::Job> m_job;
  Calls m_calls;
  std::set<State> m_seen;
};

TEST(ControlLoop, AllocatesNothingAndTakesNoLockInAnyState) {
  std::uint64_t seed = 11;
  CountedLoop loop(randomJob(seed));
  loop.live();
  loop.expectNothing();
  for (int state = 0; state < control::kStateCount; ++state) {
    EXPECT_TRUE(loop.seen().contains(static_cast<State>(state))) << control::name(static_cast<State>(state));
  }
}

} // namespace
} // namespace arris::test
