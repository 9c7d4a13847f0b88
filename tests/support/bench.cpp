#include "tests/support/bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace arris::test {

using control::State;

namespace {

std::unique_ptr<control::AxisDriver> idealAxesOf(const recipe::Machine& machine) {
  const int lead = static_cast<int>(std::lround(machine.setPointLead / machine.period));
  return std::make_unique<IdealAxes>(machine, Eigen::Vector3d(200, 300, 100), lead);
}

} // namespace

Bench::Bench(const recipe::Machine& machineOfBench, std::launch planning)
    : Bench(machineOfBench, idealAxesOf(machineOfBench), planning) {
  ideal = static_cast<IdealAxes*>(axes.get());
}

Bench::Bench(recipe::Machine machineOfBench, std::unique_ptr<control::AxisDriver> driver, std::launch planning)
    : machine(std::move(machineOfBench)), controller(machine, channels),
      supervisor(machine, channels, {{}, [this](const control::FaultReport& fault) { faults.push_back(fault); }},
                 planning),
      axes(std::move(driver)) {}

void Bench::period() {
  const control::Cycle& cycle = controller.advance(axes->read());
  axes->write(cycle.setPoint, cycle.outputs);
  if (onPeriod) {
    onPeriod(controller.report(), cycle);
  }
  if (operatorLives && m_count++ % servedEvery == 0) {
    supervisor.serve();
  }
}

bool Bench::until(const std::function<bool()>& isSo, double seconds) {
  const auto most = static_cast<std::int64_t>(seconds / machine.period);
  for (std::int64_t i = 0; i < most; ++i) {
    period();
    if (isSo()) {
      if (operatorLives) {
        supervisor.serve();
      }
      return true;
    }
  }
  return false;
}

void Bench::runFor(double seconds) {
  const auto count = static_cast<std::int64_t>(std::ceil(seconds / machine.period));
  for (std::int64_t i = 0; i < count; ++i) {
    period();
  }
}

void Bench::getReady(const job::Job& job) {
  period();
  supervisor.serve();
  EXPECT_TRUE(supervisor.enable());
  EXPECT_TRUE(until([this] { return report().drivesReady; }, 2));
  EXPECT_TRUE(supervisor.home());
  EXPECT_TRUE(until(State::Idle, 1e5));
  EXPECT_TRUE(supervisor.load(std::make_shared<const job::Job>(job)));
  EXPECT_TRUE(supervisor.park());
  while (supervisor.isPlanning()) {
    period();
  }
  EXPECT_TRUE(until(State::Positioning, 1));
  EXPECT_TRUE(until(State::Idle, 1e4));
}

} // namespace arris::test
