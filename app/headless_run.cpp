#include "app/headless_run.h"

#include "app/interruption.h"
#include "app/messages.h"
#include "app/progress.h"
#include "core/control/control_thread.h"
#include "core/control/driver_module.h"
#include "core/control/station.h"
#include "core/files/wall_clock.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <thread>

namespace arris::app {
namespace {

using control::State;

/// The operator's side is served so often, s.
constexpr double kServeEvery = 0.01;

/// Longer than any axis needs to find its switch, s.
constexpr double kHomingPatience = 3600;

/// The controller takes a program within this, s.
constexpr double kLaunchWait = 5;

control::Pace paceOf(const HeadlessRun& run) {
  return run.isFast ? control::Pace::Simulated : control::Pace::Real;
}

base::Expected<std::unique_ptr<control::AxisDriver>> axesOf(const HeadlessRun& run, const recipe::Machine& machine) {
  if (run.axes == files::Axes::Linuxcnc) {
    return control::linuxcncAxes(machine, run.moduleFolders);
  }
  return std::make_unique<control::SimulatedAxes>(machine, paceOf(run),
                                                  machine.travel / 2); // as it was left, somewhere
}

/// The machine with its operator's side, in real or simulated time.
class Machine {
public:
  Machine(const HeadlessRun& run, const std::shared_ptr<const job::Job>& job, std::unique_ptr<control::AxisDriver> axes)
      : m_run(run), m_job(job),
        m_keeper(run.folder, job, run.patternFile, run.patternHash, files::wallClock, run.axes, run.panes),
        m_simulated(dynamic_cast<control::SimulatedAxes*>(axes.get())),
        m_station(job->machine, std::move(axes), paceOf(run),
                  {[this](const control::Report& report) { hear(report); },
                   [this](const control::FaultReport& fault) { hear(fault); }},
                  [this](const control::Report& report) { inject(report); }) {}

  Executed execute() {
    // A run that could leave nothing to resume from does not begin.
    if (const ExitStatus failure = tellAndJudge(m_keeper.takeProblems()); failure != ExitStatus::Done) {
      return {failure, {}};
    }
    const ExitStatus status = begin() ? grindAll() : broken();
    comeToRest();
    m_keeper.finish();
    tell(m_keeper.takeProblems());
    if (const control::ControlThread* const thread = m_station.thread()) {
      const control::Timing timing = thread->timing();
      if (const std::string missing = thread->shortcomings(); !missing.empty()) {
        complain(fmt::format("note: {}", missing));
      }
      fmt::print("Late wake-ups {}, least lead left {} periods\n", timing.lateWakeUps, timing.worstLead);
    }
    return {status, m_keeper.record()};
  }

private:
  // Everything up to the cycle start; false where a fault or an interruption came in between.
  bool begin() {
    constexpr double kSoon = 5;
    return until([this] { return latest().tick > 0; }, kSoon) && m_station.operatorSide().enable() &&
           until([this] { return latest().drivesReady; }, kSoon) && m_station.operatorSide().home() &&
           until([this] { return latest().state == State::Idle && latest().homed; }, kHomingPatience) && setOrigin() &&
           park() && m_station.operatorSide().load(m_job, panesLeft()) && start();
  }

  bool setOrigin() {
    constexpr double kSoon = 5;
    return latest().origin == m_run.origin || (m_station.operatorSide().setOrigin(m_run.origin) &&
                                               until([this] { return latest().origin == m_run.origin; }, kSoon));
  }

  bool park() {
    const bool isThere = (latest().commanded - m_job->machine.park).norm() < 1e-6;
    return isThere ||
           (m_station.operatorSide().park() && until([this] { return latest().state == State::Positioning; }, 5) &&
            until([this] { return latest().state == State::Idle; }, kHomingPatience));
  }

  [[nodiscard]] int panesLeft() const {
    return m_run.panes.ordered - m_run.panes.first + 1;
  }

  bool start() {
    m_station.operatorSide().setOverride(m_run.overrideFactor);
    const bool started =
        m_run.from ? m_station.operatorSide().startFrom(*m_run.from) : m_station.operatorSide().start();
    while (m_station.operatorSide().isPlanning() && !interrupted()) {
      pass();
    }
    if (m_station.operatorSide().refusal()) {
      tell({&*m_station.operatorSide().refusal(), 1}, "on the table");
    }
    return started && !m_station.operatorSide().refusal();
  }

  ExitStatus grindAll() {
    for (int done = 0;;) {
      const ExitStatus status = grind(done);
      if (status != ExitStatus::Done) {
        return status;
      }
      tellPane(m_run.panes.first + done);
      if (++done >= panesLeft()) {
        return status;
      }
      if (!next()) {
        return broken();
      }
    }
  }

  void tellPane(int pane) {
    if (m_keeper.record().empty()) { // it was broken off at its very end
      m_keeper.nothingLeft();
      fmt::print("Nothing was left to grind.\n");
      return;
    }
    m_keeper.finish();
    const std::string which = m_run.panes.ordered > 1 ? fmt::format("Pane {} of {}: ", pane, m_run.panes.ordered) : "";
    fmt::print("{}Ground in {:.3f} s. Record: {}\n", which, m_time, m_keeper.record().string());
    std::fflush(stdout);
  }

  // Somebody has to change the pane on a real machine, and says so.
  bool next() {
    m_began = false;
    if (m_simulated != nullptr) {
      return m_station.operatorSide().start();
    }
    complain("the next pane is ground when cycle start is pressed on the panel");
    while (latest().program == 0 && !isFaulted() && !interrupted()) {
      pass();
    }
    return latest().program != 0;
  }

  // The pane after so many that are done.
  ExitStatus grind(int done) {
    using control::JobState;
    const auto isDone = [&] { return m_station.operatorSide().panesDone() > done; };
    const auto isOver = [&] {
      m_began = m_began || latest().program != 0;
      const bool isForgotten = latest().state == State::Idle && latest().program == 0 && m_began;
      return isDone() || m_station.operatorSide().jobState() == JobState::Aborted || isForgotten || isFaulted();
    };
    bool stops = false;
    double waits = 0;
    while (!isOver() && (m_began || waits < kLaunchWait)) {
      pass();
      waits += kServeEvery;
      if (interrupted() && !stops) {
        stops = true;
        m_station.operatorSide().stop();
      }
      if (stops && latest().state == State::Idle) {
        break;
      }
    }
    // The last places are still under way.
    for (int i = 0; i < 20; ++i) {
      pass();
    }
    m_progress.show("");
    if (isFaulted()) {
      return ExitStatus::MachineFaulted;
    }
    return isDone() ? ExitStatus::Done : ExitStatus::Interrupted;
  }

  [[nodiscard]] ExitStatus broken() const {
    if (isFaulted()) {
      return ExitStatus::MachineFaulted;
    }
    return interrupted() ? ExitStatus::Interrupted : ExitStatus::CannotBeGround;
  }

  // Whatever the reason to end: the axes rest before the drives go off.
  void comeToRest() {
    constexpr int kMostPasses = 6000; // a minute
    for (int i = 0; i < kMostPasses && control::isMoving(latest().state); ++i) {
      if (i == 0) {
        m_station.operatorSide().stop();
      }
      pass();
    }
    m_station.operatorSide().serve();
  }

  [[nodiscard]] bool isFaulted() const {
    return latest().state == State::Faulted || latest().state == State::EmergencyStop;
  }

  [[nodiscard]] const control::Report& latest() const {
    return m_station.operatorSide().latest();
  }

  // So much time goes by, and the operator's side is served.
  void pass() {
    if (!m_run.isFast) {
      std::this_thread::sleep_for(std::chrono::duration<double>(kServeEvery));
    }
    m_station.pass(std::max(1, static_cast<int>(kServeEvery / m_job->machine.period)));
  }

  bool until(const std::function<bool()>& isSo, double seconds) {
    const auto most = static_cast<std::int64_t>(seconds / kServeEvery);
    for (std::int64_t i = 0; i < most && !isFaulted() && !interrupted(); ++i) {
      pass();
      if (isSo()) {
        return true;
      }
    }
    if (!isFaulted() && !interrupted()) {
      complain(fmt::format("the machine does not answer as it should; it is {}", control::name(latest().state)));
    }
    return false;
  }

  void inject(const control::Report& report) {
    const double time = static_cast<double>(report.runTick) * m_job->machine.period;
    std::erase_if(m_injections, [&](const Injection& injection) {
      const bool isDue = report.runTick >= 0 && time >= injection.seconds;
      if (isDue) {
        m_simulated->inject(injection.fault);
      }
      return isDue;
    });
  }

  void hear(const control::Report& report) {
    m_keeper.add(report);
    if (!m_run.isFast) {
      inject(report);
    }
    if (report.runTick >= 0) {
      m_time = static_cast<double>(report.runTick) * m_job->machine.period;
      m_progress.show("Grinding", std::min(1.0, report.path / m_length));
    }
  }

  void hear(const control::FaultReport& fault) {
    m_keeper.add(fault);
    const control::FaultInfo& row = control::info(fault.fault);
    m_progress.show("");
    complain(fmt::format("fault: {} [{}]", control::describe(fault), row.name));
    complain(fmt::format("remedy: {}", row.remedy));
  }

  const HeadlessRun& m_run;
  std::shared_ptr<const job::Job> m_job;
  double m_length = motion::arcLength(m_job->track);
  control::RunKeeper m_keeper;
  control::SimulatedAxes* m_simulated; ///< where the axes are these; faults are injected into no others
  control::Station m_station;
  Progress m_progress;
  std::vector<Injection> m_injections = m_run.injections; ///< that are still to come
  double m_time = 0;                                      ///< of the run, s
  bool m_began = false;
};

} // namespace

Executed execute(const HeadlessRun& run, const std::shared_ptr<const job::Job>& job) {
  auto axes = axesOf(run, job->machine);
  if (!axes) {
    return {tellAndJudge({axes.error()}), {}};
  }
  const auto machine = std::make_unique<Machine>(run, job, *std::move(axes));
  return machine->execute();
}

} // namespace arris::app
