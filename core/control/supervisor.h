#pragma once

#include "core/control/command.h"
#include "core/control/report.h"
#include "core/program/manoeuvres.h"
#include "core/program/stream.h"
#include "core/recipe/recipe.h"

#include <functional>
#include <future>
#include <memory>
#include <optional>

namespace arris::control {

struct Channels;

/// The operator's side of the controller: keeps the job that is loaded, supplies the rotary buffers, plans steps and
/// re-entries, and turns what the operator wants into commands when their time has come. Shares nothing with the
/// controller but the channels; for one thread.
class Supervisor {
public:
  /// Hears of every period and of every fault, in order.
  struct Listener {
    std::function<void(const Report&)> period;
    std::function<void(const FaultReport&)> fault;
  };

  /// Where a job was broken off by an earlier process, and where the table's zero was then. It is put there again
  /// before the job can be gone on with.
  struct Broken {
    program::JobPlace place;
    Eigen::Vector3d origin{0, 0, 0};
  };

  /// What the wheel is to do is planned in a thread of its own, as it may take longer than the controller waits for a
  /// call of `serve`; with `std::launch::deferred` in the call that asks for it or in `serve`, for simulated time.
  Supervisor(recipe::Machine machine, Channels& channels, Listener listener = {},
             std::launch planning = std::launch::async);

  /// To be called every few hundredths of a second: without it for half a second the controller stops. Takes the
  /// reports, supplies the buffers, does what waits for its time.
  void serve();

  /// A way is being planned that has been asked for.
  [[nodiscard]] bool isPlanning() const {
    return m_plan.has_value() && m_plan->isWanted;
  }

  /// Something has been asked for that has not begun yet: it is being planned, on its way or waits for its time.
  [[nodiscard]] bool isOrdered() const {
    return isPlanning() || m_launching || m_wantsResume || m_wantsStep != 0;
  }

  /// The last period that was reported.
  [[nodiscard]] const Report& latest() const {
    return m_latest;
  }

  [[nodiscard]] JobState jobState() const {
    return m_jobState;
  }

  /// The job that is loaded, or none. A job is frozen while it is loaded.
  [[nodiscard]] const std::shared_ptr<const job::Job>& job() const {
    return m_job;
  }

  /// Why the last program was not started, where there is more to say than the state.
  [[nodiscard]] const std::optional<base::Problem>& refusal() const {
    return m_refusal;
  }

  /// Where the job that is loaded is taken up by the next cycle start, where an earlier process broke it off.
  [[nodiscard]] const std::optional<Broken>& broken() const {
    return m_broken;
  }

  /// Panes ground of the job that is loaded, of those ordered. More may be ground than were ordered.
  [[nodiscard]] int panesDone() const {
    return m_done;
  }

  [[nodiscard]] int panesOrdered() const {
    return m_ordered;
  }

  // What the operator wants. False where the state does not allow it; nothing is done then. What is allowed is on its
  // way to the controller when the call returns, or will be as soon as it is planned.

  bool enable();
  bool disable();
  bool home();
  bool acknowledge();
  bool setOrigin(const Eigen::Vector3d& origin);
  bool jogAt(const Eigen::Vector3d& velocity);
  bool jogBy(const Eigen::Vector3d& way);
  bool spindleByHand(double speed);
  bool coolantByHand(bool on);
  void setOverride(double factor);

  /// A job that can be ground, in a state without a program, for so many panes; the first of them from where an earlier
  /// process broke it off.
  bool load(std::shared_ptr<const job::Job> job, int panes = 1, const std::optional<Broken>& broken = std::nullopt);
  bool unload();

  /// Cycle start, on the screen or of the panel: the pane that was broken off from where it was, or else the next one.
  bool cycleStart();

  /// The next pane.
  bool start();

  /// The job again from a place where it was broken off, once the operator has said so.
  bool startFrom(const program::JobPlace& place);
  bool hold();

  /// On along the path; where the wheel has gone off the glass by a lead-in before the place.
  bool resume();

  /// Along the path while held, mm, negative back; as soon as the wheel is off the glass.
  bool step(double distance);
  void stop();
  bool trace();
  bool park();

private:
  /// A program that is being planned, and what it was asked for.
  struct Plan {
    std::future<std::optional<program::Program>> program; ///< none: there is no way
    State state = State::Idle;                            ///< in which it was asked for, and
    std::int64_t stops = 0;                               ///< after so many stops
    bool beginsRun = false;
    program::JobPlace place;
    bool isWanted = true; ///< neither hold nor stop came after it
  };

  void take(const Report& report);
  void noteRun(const Report& report);
  void endRun();
  void watchPanel(const Report& report);
  void doWhatPanelWants();
  void doWhatWaits();
  void putOriginBack();
  void supply();
  bool send(const Command& command);
  template <typename Way> bool plan(Way way, bool beginsRun, const program::JobPlace& place = {});
  bool takePlan();
  void giveUpPlans();
  bool launch(program::Program program, const Plan& plan);
  [[nodiscard]] bool isIdle() const;
  [[nodiscard]] bool isBusy() const;

  recipe::Machine m_machine;
  Channels& m_channels;
  Listener m_listener;
  std::shared_ptr<const job::Job> m_job;
  std::unique_ptr<program::Room> m_room; ///< beside the job's way
  program::Program m_program;
  std::optional<program::Stream> m_stream;
  std::uint32_t m_number = 0;
  Report m_latest;
  JobState m_jobState = JobState::Idle;
  bool m_isRun = false; ///< a run has begun and not ended
  std::optional<Broken> m_broken;
  int m_done = 0;
  int m_ordered = 0;
  std::optional<base::Problem> m_refusal;
  bool m_wantsResume = false;
  double m_wantsStep = 0;
  std::int64_t m_pressedTick = -1; ///< cycle start of the panel that waits; −1 none
  bool m_launching = false;        ///< a program is on its way to the controller
  std::int64_t m_launchTick = 0;
  std::launch m_planning;
  std::optional<Plan> m_plan;
};

} // namespace arris::control
