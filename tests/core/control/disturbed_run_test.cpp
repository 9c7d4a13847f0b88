// What holds whatever the operator does, at any moment.

#include "tests/support/bench.h"
#include "tests/support/panes.h"
#include "tests/support/random_panes.h"
#include "tests/support/run_watch.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace arris::control {
namespace {

using test::Bench;
using test::RunWatch;

/// One seeded sequence of commands over one run, from the cycle start to the end of the job.
class Sequence {
public:
  Sequence(const job::Job& job, unsigned seed)
      : m_job(job), m_bench(job.machine), m_watch(job, job.machine), m_dice(seed) {
    m_bench.onPeriod = [this](const Report& report, const Cycle& cycle) { m_watch.add(report, cycle); };
    m_bench.getReady(job);
  }

  void run() {
    ASSERT_TRUE(m_bench.supervisor.start());
    const double most = 40 * m_job.duration + 4000;
    double next = 0;
    int commands = 0;
    const auto isOver = [&] {
      return m_bench.supervisor.jobState() == JobState::Ended && m_bench.report().state == State::Idle;
    };
    for (double time = 0; time < most && !isOver() && m_watch.broken().empty(); time += m_job.machine.period) {
      m_bench.period();
      if (time >= next) {
        next = time + between(0.001, 2 * m_job.duration / 20);
        m_bench.servedEvery = 1 + static_cast<int>(m_dice() % 40);
        commands < kMost ? disturb() : goOn();
        ++commands;
      }
    }
    EXPECT_EQ(m_watch.broken(), "");
    EXPECT_TRUE(isOver()) << "in state " << name(m_bench.report().state) << ", job "
                          << name(m_bench.supervisor.jobState()) << ", place " << m_bench.report().place.segment
                          << " of " << m_job.track.size() << ", refused " << m_bench.report().refused;
    for (const FaultReport& fault : m_bench.faults) {
      ADD_FAILURE() << info(fault.fault).name << " axis " << fault.axis << " value " << fault.value << " in period "
                    << fault.tick;
    }
    EXPECT_LT((m_bench.report().commanded - m_job.machine.park).norm(), 1e-9);
  }

private:
  static constexpr int kMost = 30;

  double between(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(m_dice);
  }

  void disturb() {
    Supervisor& operatorSide = m_bench.supervisor;
    switch (m_dice() % 8) {
    case 0:
    case 1:
      operatorSide.setOverride(between(0.1, 1.5));
      break;
    case 2:
    case 3:
      operatorSide.hold();
      break;
    case 4:
      operatorSide.step(between(-600, 600));
      break;
    case 5:
      if (m_dice() % 4 == 0) {
        operatorSide.stop();
      }
      break;
    default:
      goOn();
    }
  }

  void goOn() {
    Supervisor& operatorSide = m_bench.supervisor;
    const Report& report = m_bench.report();
    if (report.state == State::Held || report.state == State::Holding) {
      operatorSide.resume();
    } else if (report.state == State::Idle && operatorSide.jobState() == JobState::Aborted) {
      operatorSide.startFrom(report.place);
    } else if (report.state == State::Idle && operatorSide.jobState() == JobState::Initialized) {
      operatorSide.start(); // it was stopped before it began
    }
  }

  const job::Job& m_job;
  Bench m_bench;
  RunWatch m_watch;
  std::mt19937 m_dice;
};

/// A few of them every time; as many as ARRIS_SEQUENCES says for each of the seeds by hand.
int sequences() {
  const char* const wanted = std::getenv("ARRIS_SEQUENCES");
  return wanted != nullptr ? std::atoi(wanted) : 2;
}

class DisturbedRuns : public testing::TestWithParam<int> {};

TEST_P(DisturbedRuns, KeepLimitsPathCapAndStatesAndComeToTheEnd) {
  std::uint64_t seed = 100 * static_cast<std::uint64_t>(GetParam());
  for (int i = 0; i < sequences(); ++i) {
    const job::Job job = test::randomJob(seed);
    SCOPED_TRACE(testing::Message() << "pane " << seed - 1 << " sequence " << i);
    Sequence(job, static_cast<unsigned>(1000 * GetParam() + i)).run();
    if (HasFailure()) {
      return;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, DisturbedRuns, testing::Range(0, 16));

} // namespace
} // namespace arris::control
