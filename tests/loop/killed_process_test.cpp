// A process that is killed at any moment leaves a point to resume from that is never old.

#include "core/control/control_thread.h"
#include "core/control/run_keeper.h"
#include "core/control/simulated_axes.h"
#include "core/control/supervisor.h"
#include "core/files/whole_file.h"
#include "tests/support/panes.h"
#include "tests/support/scratch.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

namespace arris::control {
namespace {

/// A job that is soon on the glass.
std::shared_ptr<const job::Job> quickJob() {
  recipe::Machine machine;
  machine.homeAt = {0, 0, 120};
  machine.setPointLead = 0.15; // a busy computer wakes the thread late
  recipe::Recipe recipe;
  recipe.accelX = recipe.accelY = recipe.accelZ = 500;
  recipe.feed = 9000;
  recipe.place = Eigen::Vector2d(100, 250);
  return std::make_shared<const job::Job>(job::planJob(test::triangle600(), recipe, machine));
}

/// Axes that tell through a pipe how many periods of the run they have executed.
class TellingAxes final : public AxisDriver {
public:
  TellingAxes(const recipe::Machine& machine, int pipe) : m_axes(machine, Pace::Real, {0, 0, 120}), m_pipe(pipe) {}

  Feedback read() override {
    Feedback feedback = m_axes.read();
    if (controller != nullptr && controller->report().runTick >= 0 && feedback.tick != m_told) {
      m_told = feedback.tick;
      const std::int64_t begin = controller->report().tick - controller->report().runTick;
      const std::int64_t executed = feedback.tick - begin;
      if (executed >= 0) {
        static_cast<void>(!::write(m_pipe, &executed, sizeof executed));
      }
    }
    return feedback;
  }

  bool write(const Eigen::Vector3d& setPoint, const Outputs& outputs) override {
    return m_axes.write(setPoint, outputs);
  }

  int queued() override {
    return m_axes.queued();
  }

  const Controller* controller = nullptr;

private:
  SimulatedAxes m_axes;
  int m_pipe;
  std::int64_t m_told = -1;
};

/// Runs the job again and again, until it is killed.
[[noreturn]] void runForEver(const std::filesystem::path& folder, int pipe) {
  const auto job = quickJob();
  Channels channels;
  Controller controller(job->machine, channels);
  TellingAxes axes(job->machine, pipe);
  axes.controller = &controller;
  RunKeeper keeper(
      {folder}, job, "triangle.dxf", "0123456789abcdef", [] { return std::string("2031-05-06T07:08:09"); },
      files::Axes::Simulated);
  Supervisor supervisor(job->machine, channels, {[&](const Report& report) { keeper.add(report); }, {}});
  const ControlThread thread(controller, axes, job->machine.period);
  while (true) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    supervisor.serve();
    const Report& report = supervisor.latest();
    if (report.state == State::Off) {
      supervisor.enable();
    } else if (report.state == State::NotHomed && report.drivesReady) {
      supervisor.home();
    } else if (report.state == State::Idle && report.homed && report.program == 0) {
      supervisor.load(job);
      supervisor.start();
    }
  }
}

struct Child {
  pid_t process = -1;
  int pipe = -1;
  std::filesystem::path folder;
};

Child begin(const std::filesystem::path& folder) {
  int ends[2];
  EXPECT_EQ(::pipe(ends), 0);
  const pid_t process = fork();
  if (process == 0) {
    close(ends[0]);
    runForEver(folder, ends[1]);
  }
  close(ends[1]);
  return {process, ends[0], folder};
}

/// The last that the child's axes have executed, s of the run; reads what the pipe holds.
double executedBy(int pipe, double period) {
  std::int64_t executed = -1;
  std::int64_t last = -1;
  while (::read(pipe, &executed, sizeof executed) == static_cast<ssize_t>(sizeof executed)) {
    last = executed;
  }
  return static_cast<double>(last) * period;
}

TEST(KilledProcess, LeavesAPointToResumeFromThatIsNeverOlderThanHalfASecond) {
  constexpr int kRounds = 5;
  constexpr int kAtOnce = 10;
  const test::Scratch scratch;
  const auto job = quickJob();
  ASSERT_TRUE(job->canBeGround());
  std::mt19937 dice(1);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Child> children;
    for (int i = 0; i < kAtOnce; ++i) {
      children.push_back(begin(scratch / fmt::format("{}-{}", round, i).c_str()));
    }
    for (const Child& child : children) { // until its run has begun
      pollfd waiting{child.pipe, POLLIN, 0};
      ASSERT_EQ(poll(&waiting, 1, 120'000), 1);
    }
    // A pipe holds some 8,000 periods; no child lives so long after that.
    for (const Child& child : children) {
      std::this_thread::sleep_for(std::chrono::milliseconds(std::uniform_int_distribution<int>(1, 250)(dice)));
      kill(child.process, SIGKILL);
      waitpid(child.process, nullptr, 0);
      const double executed = executedBy(child.pipe, job->machine.period);
      close(child.pipe);
      const auto text = files::readFile(files::StateFolder{child.folder}.resumePoint());
      ASSERT_TRUE(text) << base::describe(text.error());
      const auto point = files::readResumePoint(*text, "resume.json");
      ASSERT_TRUE(point.problems.empty()) << base::describe(point.problems.front());
      EXPECT_NEAR(point.value.time, executed, 0.5);
    }
  }
}

} // namespace
} // namespace arris::control
