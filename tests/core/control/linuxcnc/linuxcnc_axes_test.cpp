#include "core/control/driver_module.h"
#include "tests/core/control/linuxcnc/hal_recorder.h"
#include "tests/core/control/linuxcnc/hal_session.h"
#include "tests/core/control/linuxcnc/paced_axes.h"
#include "tests/support/bench.h"
#include "tests/support/panes.h"

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <sstream>

namespace arris::control {
namespace {

using test::HalSample;
using test::HalSession;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

using Axes = base::Expected<std::unique_ptr<AxisDriver>>;

Axes axesFor(const recipe::Machine& machine) {
  return linuxcncAxes(machine, {ARRIS_MODULE_DIR});
}

std::string reasonOf(const Axes& axes) {
  return axes ? std::string() : base::describe(axes.error());
}

class LinuxcncAxes : public testing::Test {
protected:
  void SetUp() override {
    if (::access("/usr/bin/halcmd", X_OK) != 0) {
      GTEST_SKIP() << "LinuxCNC is not installed (package linuxcnc-uspace)";
    }
  }
};

/// The computer that tests is shared: where it is not the watchdog that is tested, it is patient.
void calmWatchdog() {
  test::halcmd("setp watchdog.timeout-0 0.6");
}

/// That no period is missing in what was recorded.
void expectNoGap(const std::vector<HalSample>& samples) {
  for (std::size_t i = 1; i < samples.size(); ++i) {
    ASSERT_NEAR(samples[i].time - samples[i - 1].time, 1e-3, 1e-9) << "sample " << i;
  }
}

/// That the places keep the acceleration of each axis in every second difference.
void expectWithinLimits(const std::vector<HalSample>& samples, const recipe::Machine& machine) {
  constexpr double kRounding = 1e-6; // mm/s², of places of up to 1 m in second differences of 1 ms
  for (std::size_t i = 2; i < samples.size(); ++i) {
    const Eigen::Vector3d change = (samples[i].measured - 2 * samples[i - 1].measured + samples[i - 2].measured) /
                                   (machine.period * machine.period);
    for (int axis = 0; axis < kAxes; ++axis) {
      ASSERT_LE(std::abs(change[axis]), machine.maxAccel[axis] + kRounding) << "axis " << axis << ", sample " << i;
    }
  }
}

/// Writes where the axes stand until the drives are ready.
int enableDrives(AxisDriver& axes, Outputs& outputs) {
  const Eigen::Vector3d place = axes.read().position;
  int written = 0;
  while (!axes.read().inputs.driveReady[0] && written < 5000) {
    outputs.heartbeat = !outputs.heartbeat;
    outputs.driveEnable.fill(written > 0);
    EXPECT_TRUE(axes.write(place, outputs));
    ++written;
  }
  return written;
}

TEST_F(LinuxcncAxes, SayWhatIsMissingWhereNoSessionRuns) {
  const Axes axes = axesFor({});
  ASSERT_FALSE(axes);
  EXPECT_EQ(axes.error().code, base::Code::DriverNotAvailable);
  EXPECT_THAT(reasonOf(axes), HasSubstr("no HAL session"));
  EXPECT_THAT(reasonOf(axes), HasSubstr("packaging/hal/start.sh"));
}

// LinuxCNC's library is not made to be used a second time by one process.
TEST_F(LinuxcncAxes, CanBeTriedAgainInTheSameProgramWithAnotherSession) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_THAT(reasonOf(axesFor({})), HasSubstr("no HAL session"));
    const HalSession session("simulated");
    ASSERT_TRUE(session.runs());
    for (int k = 0; k < 10; ++k) {
      ASSERT_EQ(reasonOf(axesFor({})), "") << "session " << i << ", time " << k;
    }
  }
  EXPECT_EQ(::dlopen("liblinuxcnchal.so.0", RTLD_NOW | RTLD_NOLOAD), nullptr) << "it is still loaded";
}

TEST_F(LinuxcncAxes, RefuseAProgramOfAnotherVersion) {
  void* module = ::dlopen((std::string(ARRIS_MODULE_DIR) + "/" + kLinuxcncModule).c_str(), RTLD_NOW);
  ASSERT_NE(module, nullptr);
  auto* make = reinterpret_cast<MakeAxisDriver*>(::dlsym(module, kMakeLinuxcncAxes));
  ASSERT_NE(make, nullptr);
  std::array<char, 12> reason{};
  EXPECT_EQ(make("0.0.0", {}, reason.data(), reason.size()), nullptr);
  EXPECT_STREQ(reason.data(), "the module "); // as far as there is room
  ::dlclose(module);
}

TEST_F(LinuxcncAxes, RefuseASessionOfAnotherPeriod) {
  const HalSession session("simulated");
  ASSERT_TRUE(session.runs());
  recipe::Machine machine;
  machine.period = 0.002;
  EXPECT_THAT(reasonOf(axesFor(machine)), HasSubstr("period is 0.001 s, the machine's 0.002 s"));
  EXPECT_EQ(reasonOf(axesFor({})), "");
}

TEST_F(LinuxcncAxes, RefuseASessionThatLacksASignal) {
  const HalSession session("simulated");
  ASSERT_TRUE(session.runs());
  test::halcmd("delsig arris-hold");
  EXPECT_THAT(reasonOf(axesFor({})), HasSubstr("no signal arris-hold"));
}

TEST_F(LinuxcncAxes, AreDrivenByOneProgramAtATime) {
  const HalSession session("simulated");
  ASSERT_TRUE(session.runs());
  Axes first = axesFor({});
  ASSERT_TRUE(first) << reasonOf(first);
  EXPECT_THAT(reasonOf(axesFor({})), HasSubstr("another Arris"));
  first->reset();
  EXPECT_EQ(reasonOf(axesFor({})), "");
}

TEST_F(LinuxcncAxes, HaveThePinsOfTheManual) {
  const HalSession session("simulated");
  ASSERT_TRUE(session.runs());
  const Axes axes = axesFor({});
  ASSERT_TRUE(axes) << reasonOf(axes);
  std::set<std::string> pins;
  std::istringstream words(test::halcmd("list pin arris."));
  for (std::string word; words >> word;) {
    pins.insert(word);
  }
  std::set<std::string> documented{"arris.emergency-stop", "arris.spindle-at-speed", "arris.coolant-flow",
                                   "arris.vacuum",         "arris.cycle-start",      "arris.hold",
                                   "arris.stop",           "arris.jog-enable",       "arris.override-percent",
                                   "arris.spindle-speed",  "arris.coolant",          "arris.heartbeat"};
  for (const char* axis : {"x", "y", "z"}) {
    for (const char* pin :
         {"limit-low", "limit-high", "reference", "drive-ready", "drive-fault", "encoder-lost", "drive-enable"}) {
      documented.insert(std::string("arris.") + axis + "." + pin);
    }
  }
  EXPECT_EQ(pins, documented);
}

// In the template for real drives nothing sets the inputs yet.
TEST_F(LinuxcncAxes, ReadEachInputFromItsSignal) {
  const HalSession session("real");
  ASSERT_TRUE(session.runs());
  test::halcmd("sets arris-vacuum 1");
  const Axes axes = axesFor({});
  ASSERT_TRUE(axes) << reasonOf(axes);
  EXPECT_TRUE((*axes)->read().inputs.vacuumHolds) << "what was set before Arris came stays";
  test::halcmd("sets arris-vacuum 0");
  EXPECT_EQ((*axes)->read().inputs, Inputs{});

  const auto expect = [&](const std::string& signal, const Inputs& inputs) {
    test::halcmd("sets " + signal + " 1");
    EXPECT_EQ((*axes)->read().inputs, inputs) << signal;
    test::halcmd("sets " + signal + " 0");
  };
  const std::pair<const char*, bool Inputs::*> single[] = {{"emergency-stop", &Inputs::emergencyStop},
                                                           {"spindle-at-speed", &Inputs::spindleAtSpeed},
                                                           {"coolant-flow", &Inputs::coolantFlows},
                                                           {"vacuum", &Inputs::vacuumHolds},
                                                           {"cycle-start", &Inputs::cycleStart},
                                                           {"hold", &Inputs::hold},
                                                           {"stop", &Inputs::stop},
                                                           {"jog-enable", &Inputs::jogEnable}};
  for (const auto& [name, member] : single) {
    Inputs inputs;
    inputs.*member = true;
    expect(std::string("arris-") + name, inputs);
  }
  const std::pair<const char*, std::array<bool, kAxes> Inputs::*> ofAxes[] = {
      {"limit-low", &Inputs::limitLow},     {"limit-high", &Inputs::limitHigh},
      {"reference", &Inputs::reference},    {"drive-ready", &Inputs::driveReady},
      {"drive-fault", &Inputs::driveFault}, {"encoder-lost", &Inputs::encoderLost}};
  for (const auto& [name, member] : ofAxes) {
    for (std::size_t i = 0; i < kAxes; ++i) {
      Inputs inputs;
      (inputs.*member)[i] = true;
      expect(std::string("arris-") + "xyz"[i] + "-" + name, inputs);
    }
  }
  Inputs inputs;
  inputs.overridePercent = 1;
  expect("arris-override-percent", inputs);
}

TEST_F(LinuxcncAxes, WriteEachOutputToItsSignal) {
  const HalSession session("real");
  ASSERT_TRUE(session.runs());
  Axes axes = axesFor({});
  ASSERT_TRUE(axes) << reasonOf(axes);
  Outputs outputs{.driveEnable = {true, false, true}, .spindleSpeed = 4321.5, .coolant = true};
  ASSERT_TRUE((*axes)->write({0, 0, 0}, outputs));
  EXPECT_EQ(test::halcmd("gets arris-x-drive-enable"), "TRUE\n");
  EXPECT_EQ(test::halcmd("gets arris-y-drive-enable"), "FALSE\n");
  EXPECT_EQ(test::halcmd("gets arris-z-drive-enable"), "TRUE\n");
  EXPECT_EQ(test::halcmd("gets arris-spindle-speed"), "4321.5\n");
  EXPECT_EQ(test::halcmd("gets arris-coolant"), "TRUE\n");
}

TEST_F(LinuxcncAxes, TakeNoMoreThanFitsAndKeepTheRest) {
  const HalSession session("simulated");
  ASSERT_TRUE(session.runs());
  Axes axes = axesFor({});
  ASSERT_TRUE(axes) << reasonOf(axes);
  test::halcmd("setp streamer.0.enable 0");
  int written = 0;
  while (written < 20000 && (*axes)->write({0, 0, 0}, {})) {
    ++written;
  }
  EXPECT_GE(written, 7900);
  EXPECT_LE(written, 8000);
  EXPECT_EQ((*axes)->queued(), written);
  EXPECT_EQ((*axes)->read().tick, -1);
}

TEST_F(LinuxcncAxes, CarryAJobOfTwentyThousandSetPointsCompleteInOrderAndWithoutUnderrun) {
  const HalSession session("simulated");
  ASSERT_TRUE(session.runs());
  calmWatchdog();
  const recipe::Machine machine;
  Axes axes = axesFor(machine);
  ASSERT_TRUE(axes) << reasonOf(axes);
  test::HalRecorder recorder;
  test::PacedAxes paced(std::move(*axes), 1000);
  Outputs outputs;
  std::vector<Eigen::Vector3d> written(static_cast<std::size_t>(enableDrives(paced, outputs)), Eigen::Vector3d::Zero());
  const std::size_t before = written.size();

  const job::Job job = job::planJob(test::triangle600(), recipe::Recipe{}, machine);
  job::Sampler rows(job);
  const Eigen::Vector3d start = machine.park;
  while (written.size() < before + 20000) {
    ASSERT_FALSE(rows.done());
    written.emplace_back(rows.next().setPoint.position - start);
    outputs.heartbeat = !outputs.heartbeat;
    ASSERT_TRUE(paced.write(written.back(), outputs));
  }
  EXPECT_EQ(paced.read().underruns, 0);
  ASSERT_GT(paced.queued(), 0) << "or the underruns counted those after the end";
  while (paced.queued() > 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_EQ(paced.read().tick, static_cast<std::int64_t>(written.size()) - 1);

  const std::vector<HalSample> samples = recorder.take();
  expectNoGap(samples);
  std::size_t arrived = 0;
  for (const HalSample& sample : samples) {
    if (arrived == 0 && sample.number == 0) {
      continue;
    }
    if (arrived == written.size()) {
      break;
    }
    ASSERT_EQ(sample.number, static_cast<double>(arrived + 1));              // one a period, none twice, none left out
    ASSERT_EQ(sample.measured, written[arrived]) << "set-point " << arrived; // to the last bit
    ++arrived;
  }
  EXPECT_EQ(arrived, written.size());
}

/// Kills the program that drives the axes while it does. False where it ended by itself: the computer was too busy.
bool killWriter() {
  std::array<int, 2> ends{};
  EXPECT_EQ(::pipe(ends.data()), 0);
  const pid_t process = ::fork();
  if (process == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    ::execl(ARRIS_HAL_WRITER, ARRIS_HAL_WRITER, ARRIS_MODULE_DIR, nullptr);
    ::_exit(127);
  }
  ::close(ends[1]);
  std::array<char, 16> said{};
  const bool moves = ::read(ends[0], said.data(), said.size() - 1) > 0;
  ::close(ends[0]);
  ::kill(process, SIGKILL);
  int status = 0;
  ::waitpid(process, &status, 0);
  return moves && WIFSIGNALED(status);
}

/// What became of the axes when their writer was killed at 180 mm/s: indices of samples.
struct Stop {
  std::size_t dry = 0;  ///< the first without a set-point
  std::size_t open = 0; ///< the latch is open
  std::size_t off = 0;  ///< the power is off
};

Stop stopIn(const std::vector<HalSample>& samples) {
  Stop stop;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const bool isLast = samples[i].number == samples.back().number;
    stop.dry = samples[i - 1].number == samples[i].number && isLast && stop.dry == 0 ? i : stop.dry;
    stop.open = samples[i - 1].chainOk && !samples[i].chainOk ? i : stop.open;
    stop.off = samples[i - 1].enabled && !samples[i].enabled ? i : stop.off;
  }
  return stop;
}

Eigen::Vector3d speedAt(const std::vector<HalSample>& samples, std::size_t i) {
  return (samples[i].measured - samples[i - 1].measured) * 1000;
}

TEST_F(LinuxcncAxes, StopWithinTheirLimitsAndLoseTheirPowerWhenArrisIsKilled) {
  const recipe::Machine machine;
  bool moved = false;
  for (int attempt = 0; attempt < 5 && !moved; ++attempt) { // the writer may be late on a busy computer
    const HalSession session("simulated");
    ASSERT_TRUE(session.runs());
    test::HalRecorder recorder;
    if (!killWriter()) {
      continue;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    const std::vector<HalSample> samples = recorder.take();
    expectNoGap(samples);
    expectWithinLimits(samples, machine);
    EXPECT_FALSE(samples.back().chainOk);
    EXPECT_FALSE(samples.back().enabled);

    const auto [dry, open, off] = stopIn(samples);
    ASSERT_GT(dry, 0);
    moved = std::abs(speedAt(samples, dry - 1).x() - 180) < 1e-6;
    EXPECT_LE(open, dry + 101) << "0.1 s after the last heartbeat, which was before the last set-point";
    EXPECT_GE(off, open + 499) << "0.5 s for braking";
    EXPECT_LE(off, open + 501);
    EXPECT_EQ(speedAt(samples, off), Eigen::Vector3d::Zero()) << "at rest when the power goes";
    EXPECT_EQ(samples.back().measured, samples[off].measured);
    if (moved) {
      const double way = samples.back().measured.x() - samples[dry - 1].measured.x();
      EXPECT_NEAR(way, 180.0 * 180 / (2 * machine.maxAccel.x()), 0.3) << "it brakes as hard as it may, and stays there";
    }
  }
  EXPECT_TRUE(moved) << "in no attempt the axes moved steadily; the computer is too busy";
}

TEST_F(LinuxcncAxes, AreTakenOverAfterArrisWasKilled) {
  const HalSession session("simulated");
  ASSERT_TRUE(session.runs());
  bool killed = false;
  for (int attempt = 0; attempt < 5 && !killed; ++attempt) {
    killed = killWriter();
  }
  ASSERT_TRUE(killed) << "in every attempt the writer ended by itself; the computer is too busy";
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  Axes axes = axesFor({});
  ASSERT_TRUE(axes) << reasonOf(axes);
  EXPECT_EQ((*axes)->read().tick, -1);
  EXPECT_GT((*axes)->read().position.x(), 10);
  EXPECT_FALSE((*axes)->read().inputs.driveReady[0]);
  Outputs outputs;
  test::PacedAxes paced(std::move(*axes), 30);
  EXPECT_LT(enableDrives(paced, outputs), 5000);
  EXPECT_TRUE(paced.read().inputs.driveReady[0]);
}

/// A small pane near the table's zero, and a machine that is patient with this computer.
job::Job smallJob() {
  recipe::Machine machine;
  machine.homeLatch = 1800;
  machine.setPointLead = 0.2;
  recipe::Recipe recipe;
  recipe.wheelRadius = 20;
  recipe.accelX = recipe.accelY = recipe.accelZ = 400;
  recipe.feed = 9000;
  recipe.place = geometry::Point(100, 100);
  return job::planJob(test::isosceles(70, 150), recipe, machine);
}

TEST_F(LinuxcncAxes, HomeAndGrindAWholeJob) {
  const HalSession session("simulated");
  ASSERT_TRUE(session.runs());
  calmWatchdog();
  const job::Job job = smallJob();
  const recipe::Machine& machine = job.machine;
  ASSERT_TRUE(job.canBeGround()) << (job.problems.empty() ? "" : base::describe(job.problems.front()));

  Axes axes = axesFor(machine);
  ASSERT_TRUE(axes) << reasonOf(axes);
  test::HalRecorder recorder;
  test::Bench bench(machine, std::make_unique<test::PacedAxes>(std::move(*axes), 200));
  bench.getReady(job);
  std::int64_t rows = 0;
  double farthestOff = 0;
  bench.onPeriod = [&](const Report& report, const Cycle&) {
    rows += report.runTick >= 0 ? 1 : 0;
    farthestOff = std::max(farthestOff, report.followingError.cwiseAbs().maxCoeff());
  };
  ASSERT_TRUE(bench.supervisor.start());
  ASSERT_TRUE(bench.until([&] { return bench.supervisor.jobState() == JobState::Ended; }, job.duration + 20));
  bench.runFor(0.3);
  EXPECT_THAT(bench.faults, IsEmpty());
  EXPECT_EQ(bench.supervisor.panesDone(), 1);
  EXPECT_EQ(rows, static_cast<std::int64_t>(job::Sampler(job).count()));
  EXPECT_LT(farthestOff, 1e-9) << "the simulated axes are where their set-points say";
  EXPECT_TRUE(bench.report().measured.isApprox(machine.park, 1e-6)) << bench.report().measured.transpose();
  EXPECT_EQ(bench.axes->read().underruns, 0);

  const std::vector<HalSample> samples = recorder.take();
  expectNoGap(samples);
  expectWithinLimits(samples, machine);
}

TEST_F(LinuxcncAxes, KeepTheirPowerInAFaultUntilTheWheelIsRaisedAndLoseItInAnEmergencyStop) {
  const HalSession session("simulated");
  ASSERT_TRUE(session.runs());
  calmWatchdog();
  test::halcmd("setp braking.off-delay 0");
  const job::Job job = smallJob();
  Axes axes = axesFor(job.machine);
  ASSERT_TRUE(axes) << reasonOf(axes);
  test::HalRecorder recorder;
  test::Bench bench(job.machine, std::make_unique<test::PacedAxes>(std::move(*axes), 200));
  bench.getReady(job);

  ASSERT_TRUE(bench.supervisor.start());
  ASSERT_TRUE(bench.until([&] { return bench.report().place.segment >= 0 && bench.report().commanded.z() < 50; }, 20));
  test::halcmd("setp vacuum.in 1");
  ASSERT_TRUE(bench.until(State::Faulted, 5));
  bench.runFor(1); // longer than the watchdog waits for a heartbeat
  EXPECT_TRUE(bench.report().drivesReady);
  EXPECT_GT(bench.report().measured.z(), 70) << "the wheel is clear of the glass";
  ASSERT_THAT(bench.faults, SizeIs(1));
  EXPECT_EQ(bench.faults.front().fault, Fault::VacuumLost);
  ASSERT_TRUE(bench.supervisor.acknowledge());
  ASSERT_TRUE(bench.until(State::Idle, 1));

  for (int i = 0; i < 10; ++i) {
    ASSERT_TRUE(bench.supervisor.jogAt({40, 40, 0}));
    bench.runFor(0.1);
  }
  EXPECT_NEAR(bench.report().velocity.x(), 40, 1e-6);
  test::halcmd("sets arris-emergency-stop 1");
  ASSERT_TRUE(bench.until(State::EmergencyStop, 1));
  bench.runFor(0.5);
  const std::vector<HalSample> samples = recorder.take();
  expectNoGap(samples);
  expectWithinLimits(samples, job.machine);
  EXPECT_FALSE(samples.back().chainOk);
  EXPECT_FALSE(samples.back().enabled);
  EXPECT_EQ(speedAt(samples, samples.size() - 1), Eigen::Vector3d::Zero());

  test::halcmd("sets arris-emergency-stop 0");
  bench.runFor(0.3);
  ASSERT_TRUE(bench.supervisor.acknowledge());
  ASSERT_TRUE(bench.until(State::Off, 1));
  ASSERT_TRUE(bench.supervisor.enable());
  ASSERT_TRUE(bench.until([&] { return bench.report().drivesReady; }, 1));
  EXPECT_EQ(bench.report().state, State::Idle);
}

} // namespace
} // namespace arris::control
