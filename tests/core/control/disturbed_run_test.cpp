// What holds whatever the operator does and whatever goes wrong, at any moment.

#include "tests/support/bench.h"
#include "tests/support/ground_watch.h"
#include "tests/support/mishaps.h"
#include "tests/support/panes.h"
#include "tests/support/random_panes.h"
#include "tests/support/run_watch.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <random>
#include <string>

namespace arris::control {
namespace {

using test::Bench;
using test::RunWatch;

/// At rest until the operator asks for something.
bool waitsForOperator(State state) {
  return state == State::Off || state == State::NotHomed || state == State::Idle || state == State::Faulted ||
         state == State::EmergencyStop;
}

bool cutsDrives(const Faults& faults) {
  return std::any_of(allFaults().begin(), allFaults().end(),
                     [&](const FaultInfo& row) { return row.category != StopCategory::Two && faults.has(row.fault); });
}

/// One seeded sequence of commands, and of mishaps where wanted, over one run, from the cycle start to the end of the
/// job.
class Sequence {
public:
  Sequence(const job::Job& job, unsigned seed, bool withMishaps)
      : m_job(job), m_bench(job.machine), m_watch(job, job.machine), m_ground(job), m_dice(seed),
        m_withMishaps(withMishaps) {
    m_bench.getReady(job);
    m_last = m_bench.report();
    m_bench.onPeriod = [this](const Report& report, const Cycle& cycle) { see(report, cycle); };
  }

  void run() {
    ASSERT_TRUE(m_bench.supervisor.start());
    m_isAsked = true;
    const double most = 40 * m_job.duration + 4000 + (m_withMishaps ? 20000 : 0); // for homing
    double next = 0;
    int commands = 0;
    for (double time = 0; time < most && !isOver() && isFine(); time += m_job.machine.period) {
      m_bench.period();
      m_mends -= m_job.machine.period;
      if (m_mishap && m_mends <= 0) {
        mend();
      }
      if (time >= next) {
        next = time + between(0.001, 2 * m_job.duration / 20);
        m_bench.servedEvery = 1 + static_cast<int>(m_dice() % 40);
        commands < kMost ? disturb() : goOn();
        ++commands;
      }
    }
    const testing::ScopedTrace story(__FILE__, __LINE__, m_story);
    EXPECT_EQ(m_watch.broken(), "");
    EXPECT_EQ(m_ground.missing(isOver()), "");
    EXPECT_TRUE(isOver()) << "in state " << name(m_bench.report().state) << ", job "
                          << name(m_bench.supervisor.jobState()) << ", place " << m_bench.report().place.segment
                          << " of " << m_job.track.size() << ", refused " << m_bench.report().refused;
  }

private:
  static constexpr int kMost = 30;

  double between(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(m_dice);
  }

  [[nodiscard]] bool isOver() const {
    return m_bench.supervisor.jobState() == JobState::Ended && m_bench.report().state == State::Idle;
  }

  [[nodiscard]] bool isFine() const {
    return m_watch.broken().empty() && m_ground.missing(false).empty() && !testing::Test::HasFailure();
  }

  void see(const Report& report, const Cycle& cycle) {
    m_watch.add(report, cycle);
    m_ground.add(report);
    seeFaults(report);
    if (waitsForOperator(m_last.state) && !m_isAsked) {
      EXPECT_FALSE(isMoving(report.state)) << name(report.state) << " by itself in period " << report.tick;
    }
    m_isAsked = m_isAsked && (waitsForOperator(report.state) == waitsForOperator(m_last.state));
    if (report.state != m_last.state || report.aside != m_last.aside) {
      m_story +=
          fmt::format("{} {} at {}:{}\n", report.tick, name(report.state), report.place.segment, report.place.lambda);
    }
    if (report.jobsEnded > m_last.jobsEnded) {
      EXPECT_LT((report.commanded - m_job.machine.park).norm(), 1e-9);
    }
    if (m_last.runTick >= 0 && report.runTick < 0) {
      m_brokenOffAt = report.place;
    }
    m_last = report;
  }

  // They have a reason, and drives go off as their category says: with the axes at rest but for category 0.
  void seeFaults(const Report& report) {
    for (; m_faultsSeen < m_bench.faults.size(); ++m_faultsSeen) {
      const FaultReport& fault = m_bench.faults[m_faultsSeen];
      m_story += fmt::format("{} {}\n", fault.tick, info(fault.fault).name);
      EXPECT_TRUE(fault.tick >= m_mishapTick && fault.tick <= m_mendedTick)
          << info(fault.fault).name << " axis " << fault.axis << " value " << fault.value << " in period "
          << fault.tick;
    }
    if (report.state != State::Faulted || m_last.state == State::Faulted) {
      return;
    }
    EXPECT_EQ(report.outputs.driveEnable[0], m_last.outputs.driveEnable[0] && !cutsDrives(report.faults));
    if (m_last.state == State::Stopping && !report.outputs.driveEnable[0] && canBrake(report.faults)) {
      EXPECT_LT((report.measured - report.commanded).norm(), 1e-9) << "drives off too early in period " << report.tick;
    }
  }

  // Axes that the drives do not hold cannot be braked on the path.
  [[nodiscard]] static bool canBrake(const Faults& faults) {
    return std::none_of(allFaults().begin(), allFaults().end(), [&](const FaultInfo& row) {
      const bool isOfDrive =
          row.fault == Fault::DriveFault || row.fault == Fault::DriveNotReady || row.fault == Fault::FollowingError;
      return (isOfDrive || row.category == StopCategory::Zero) && faults.has(row.fault);
    });
  }

  void disturb() {
    Supervisor& operatorSide = m_bench.supervisor;
    if (m_withMishaps && !m_mishap && m_dice() % 10 == 0) {
      beginMishap();
    }
    if (!m_bench.operatorLives) {
      return;
    }
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

  void beginMishap() {
    const std::vector<test::Mishap> all = test::mishaps();
    m_mishap = all[m_dice() % all.size()];
    m_mishap->begins(m_bench);
    m_story += fmt::format("{} mishap of {}\n", m_bench.report().tick, info(m_mishap->fault).name);
    m_mishapTick = m_bench.report().tick;
    m_mendedTick = std::numeric_limits<std::int64_t>::max();
    m_mends = std::exp(between(std::log(0.005), std::log(8)));
  }

  void mend() {
    m_mishap->isMended(m_bench);
    m_mishap.reset();
    m_mendedTick = m_bench.report().tick + 1;
  }

  // What leads back to a run, from whatever state.
  void goOn() {
    Supervisor& operatorSide = m_bench.supervisor;
    const Report& report = m_bench.report();
    if (!m_bench.operatorLives) {
      return;
    }
    m_isAsked = true;
    if (report.state == State::Held || report.state == State::Holding) {
      operatorSide.resume();
    } else if (report.state == State::Faulted || report.state == State::EmergencyStop) {
      operatorSide.acknowledge();
    } else if (report.state == State::Off) {
      operatorSide.enable();
    } else if (report.state == State::NotHomed) {
      operatorSide.home();
    } else if (report.state == State::Idle && operatorSide.jobState() == JobState::Aborted) {
      EXPECT_EQ(report.place, m_brokenOffAt);
      operatorSide.startFrom(report.place);
    } else if (report.state == State::Idle && operatorSide.jobState() == JobState::Initialized) {
      operatorSide.start(); // it was stopped before it began
    }
  }

  const job::Job& m_job;
  Bench m_bench;
  RunWatch m_watch;
  test::GroundWatch m_ground;
  std::mt19937 m_dice;
  bool m_withMishaps;
  std::optional<test::Mishap> m_mishap; ///< that lasts
  double m_mends = 0;                   ///< s from now
  std::int64_t m_mishapTick = 0;        ///< the last one began
  std::int64_t m_mendedTick = -1;       ///< and was mended
  std::size_t m_faultsSeen = 0;
  Report m_last;
  bool m_isAsked = false; ///< for something, since the machine last came to rest
  program::JobPlace m_brokenOffAt;
  std::string m_story; ///< for whoever looks into a failure
};

/// One for each of the seeds every time; as many as ARRIS_SEQUENCES says by hand.
int sequences() {
  const char* const wanted = std::getenv("ARRIS_SEQUENCES");
  return wanted != nullptr ? std::atoi(wanted) : 1;
}

/// The seeds of a test's sequences: panes and dice from `seed` on.
void runSequences(int seed, bool withMishaps) {
  std::uint64_t pane = 100 * static_cast<std::uint64_t>(seed);
  for (int i = 0; i < sequences(); ++i) {
    const job::Job job = test::randomJob(pane);
    SCOPED_TRACE(testing::Message() << "pane " << pane - 1 << " sequence " << i);
    Sequence(job, static_cast<unsigned>(1000 * seed + i), withMishaps).run();
    if (testing::Test::HasFailure()) {
      return;
    }
  }
}

class DisturbedRuns : public testing::TestWithParam<int> {};

TEST_P(DisturbedRuns, KeepLimitsPathCapAndStatesAndComeToTheEnd) {
  runSequences(GetParam(), false);
}

TEST_P(DisturbedRuns, KeepThemWhateverGoesWrongAndEveryPartIsGroundWhenTheyWereResumed) {
  runSequences(GetParam(), true);
}

INSTANTIATE_TEST_SUITE_P(Seeds, DisturbedRuns, testing::Range(0, 16));

} // namespace
} // namespace arris::control
