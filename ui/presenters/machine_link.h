#pragma once

#include "core/control/counter_keeper.h"
#include "core/control/run_keeper.h"
#include "core/control/station.h"
#include "core/program/progress.h"
#include "ui/presenters/allowed.h"
#include "ui/presenters/machine_axes.h"
#include "ui/presenters/order_book.h"
#include "ui/presenters/planner.h"
#include "ui/presenters/resume_offer.h"

#include <QObject>
#include <QString>
#include <QThreadPool>
#include <QTimer>

#include <functional>
#include <vector>

namespace arris::ui {

/// A fault as the window tells it.
struct Alarm {
  control::FaultReport fault;
  files::Alarm logged;  ///< as it stands in the alarm log
  bool isActive = true; ///< not acknowledged yet
};

/// What a machine is and where it keeps what its runs leave.
struct MachineSetup {
  recipe::Machine machine;
  files::StateFolder folder;
  control::Pace pace = control::Pace::Real; ///< Simulated: simulated axes as fast as they can, for tests
  PlannerSteps steps = plannerSteps();      ///< by which a job that was broken off is planned again
  std::function<void(const control::Report&)> watcher = {}; ///< hears of every period, if anybody does
  std::optional<files::Axes> axes = {};                     ///< none said: as the settings say
  std::vector<std::filesystem::path> moduleFolders = {};    ///< where the module of the LinuxCNC axes may lie
};

/// What has been chosen on the page Setup; it outlives the page.
struct SetupChoices {
  int part = 0;    ///< of the page
  int jogStep = 0; ///< 0: as long as a button is pressed; else the place of the step in the list
  bool jogFast = false;
  double spindle = 0; ///< r/min, by hand; 0 not chosen yet
};

/// The machine as the window sees it: axes with their controller, in a thread of its own in real time, and the
/// operator's side, which is served from the window's thread: where the window hangs the controller stops. Commands go
/// down and reports come up as values. Where real axes are not available the reason is its complaint and nothing can be
/// moved. Shares nothing with widgets.
class MachineLink : public QObject {
  Q_OBJECT

public:
  /// With the axes that the setup asks for, simulated ones where it says nothing; LinuxCNC's keep real time, and may
  /// have to be waited for, a second or two.
  explicit MachineLink(const MachineSetup& setup, QObject* parent = nullptr);
  MachineLink(const MachineSetup& setup, MachineAxes axes, QObject* parent = nullptr); ///< with these axes
  ~MachineLink() override; ///< brings the axes to rest first
  MachineLink(const MachineLink&) = delete;
  MachineLink& operator=(const MachineLink&) = delete;
  MachineLink(MachineLink&&) = delete;
  MachineLink& operator=(MachineLink&&) = delete;

  /// The last period.
  [[nodiscard]] const control::Report& report() const {
    return operatorSide().latest();
  }

  [[nodiscard]] control::JobState jobState() const {
    return operatorSide().jobState();
  }

  [[nodiscard]] Allowed allowed() const;

  /// The axes are simulated: they can be made to fail, and have no panel but the window's.
  [[nodiscard]] bool isSimulated() const {
    return m_simulated != nullptr;
  }

  /// Why real axes are not there.
  [[nodiscard]] const std::optional<base::Problem>& absence() const {
    return m_absence;
  }

  /// What the controller has, frozen while it has it; null where none is loaded.
  [[nodiscard]] const PlanPointer& loaded() const {
    return m_loaded;
  }

  [[nodiscard]] int panesDone() const {
    return operatorSide().panesDone();
  }

  [[nodiscard]] int panesOrdered() const {
    return operatorSide().panesOrdered();
  }

  /// The order, and what the operator says of its panes.
  [[nodiscard]] OrderBook& order() {
    return m_order;
  }

  [[nodiscard]] const OrderBook& order() const {
    return m_order;
  }

  /// The job that an earlier process left broken off.
  [[nodiscard]] ResumeOffer& resumeOffer() {
    return m_offer;
  }

  [[nodiscard]] SetupChoices& setupChoices() {
    return m_choices;
  }

  [[nodiscard]] const recipe::Machine& machine() const {
    return m_machine;
  }

  /// A pane of the job that is loaded was broken off, by this process or an earlier one: the next cycle start goes on
  /// with it.
  [[nodiscard]] bool goesOnWithAPane() const;

  /// Of the way along the glass of the job that is loaded, as far as it is ground on this pane; 0 to 1. It does not
  /// begin anew where a pane is gone on with.
  [[nodiscard]] double progress() const;

  /// What is left of that way, mm.
  [[nodiscard]] double wayLeft() const;

  /// To the end of the pane at the override in effect, s.
  [[nodiscard]] double timeLeft() const;

  /// Whether a plan is another than the one that is loaded: of another pattern, or with other values.
  [[nodiscard]] bool isRevision(const Plan& plan) const;

  /// Every fault since the program began, the latest last.
  [[nodiscard]] const std::vector<Alarm>& alarms() const {
    return m_alarms;
  }

  /// What could not be started or written, the last of it; or else that the axes are not there.
  [[nodiscard]] const std::optional<base::Problem>& complaint() const {
    return m_complaint ? m_complaint : m_absence;
  }

  /// The record of the present or the last run; empty before the first.
  [[nodiscard]] std::filesystem::path record() const {
    return m_keeper ? m_keeper->record() : std::filesystem::path();
  }

  /// Tells a problem on the banner, until the operator goes on.
  void complain(const base::Problem& problem);

  /// Where the machine keeps what its runs leave.
  [[nodiscard]] const files::StateFolder& folder() const {
    return m_folder;
  }

  /// The largest following error of each axis since the program began, mm.
  [[nodiscard]] const Eigen::Vector3d& worstFollowingError() const {
    return m_worstFollowingError;
  }

  /// Of the controller's thread; none in simulated time.
  [[nodiscard]] std::optional<control::Timing> timing() const {
    return m_station.timing();
  }

  /// Over the life of the machine.
  [[nodiscard]] files::Counters counters() const {
    return m_counters ? m_counters->counters() : files::Counters();
  }

  /// What was wrong with the file of the counters when it was read.
  [[nodiscard]] std::optional<base::Problem> counterDamage() const {
    return m_counters ? m_counters->damage() : std::nullopt;
  }

  /// While it does not count its file may be replaced; afterwards it goes on from what stands there.
  void setCounting(bool counts);

  // What the operator wants; where it is not allowed nothing happens.

  void enable();
  void disable();
  void home();
  void acknowledge();
  /// For the panes of the order that are still wanted, where it is of the same pattern and not complete, and another
  /// plan than the one that is loaded; or else for a new order. A pane that was broken off is given up.
  void load(const PlanPointer& plan);
  void load(const PlanPointer& plan, int panes); ///< as many are wanted
  void start();                       ///< cycle start: the next pane, or the pane that was broken off from where it was
  void judge(files::Verdict verdict); ///< of the pane that has ended; a pane that was broken off can only be a reject
  void hold();
  void resume();
  void step(double distance); ///< mm along the path, negative back
  void stop();
  void trace();
  void park();
  void jogAt(const Eigen::Vector3d& velocity);   ///< mm/s; to be said again within 0.2 s
  void jogBy(const Eigen::Vector3d& way);        ///< mm, at the speed of a fast jog
  void setOrigin(const Eigen::Vector3d& origin); ///< G54: the table's zero in machine coordinates, mm
  void spindleByHand(double speed);              ///< r/min; 0 off
  void coolantByHand(bool on);
  void setOverride(double factor);

  // Of simulated axes; with others nothing happens.

  void inject(control::SimulatedFault fault);
  void clearFaults();
  void press(control::Button button, bool down); ///< of their panel

Q_SIGNALS:
  /// A new period has been reported.
  void reported();
  /// State, job or what is allowed have changed.
  void changed();
  void alarmRaised(const arris::ui::Alarm& alarm);

private:
  void pass();
  void passOnce(); ///< at the end, without the timer

  [[nodiscard]] const control::Supervisor& operatorSide() const {
    return m_station.operatorSide();
  }

  void hear(const control::Report& report);
  void hear(const control::FaultReport& fault);
  files::Alarm log(const control::FaultReport& fault);
  void logged(const base::Expected<void>& result);
  bool prepare(const PlanPointer& plan, const control::PaneOrder& panes,
               const std::optional<control::Supervisor::Broken>& broken);
  void takeUp(const TakenUp& job);
  void giveUpPane();
  void notePanes();
  void noteOrigin();
  void renewTimes();
  void tellChanges();

  files::StateFolder m_folder;
  control::Pace m_pace;
  recipe::Machine m_machine;
  control::SimulatedAxes* m_simulated; ///< the station's axes, where they are these
  files::Axes m_axes;
  std::optional<base::Problem> m_absence;
  control::Station m_station;
  PlanPointer m_loaded;
  OrderBook m_order;
  ResumeOffer m_offer;
  SetupChoices m_choices;
  std::function<void(const control::Report&)> m_watcher;
  std::optional<program::WorkingWay> m_way;          ///< of the job that is loaded
  std::shared_ptr<const program::Timetable> m_times; ///< of that job; null until it is ready
  bool m_timesAsked = false;
  double m_ground = 0;     ///< of the pane, mm
  double m_paneTime = 0;   ///< of the pane, s
  double m_timeBefore = 0; ///< in its earlier runs, s
  int m_paneOfRun = 0;     ///< number of the pane that m_ground and m_paneTime are of
  int m_doneSeen = 0;
  std::int64_t m_jobsSeen = 0;
  Eigen::Vector3d m_originSeen{0, 0, 0};
  std::unique_ptr<control::RunKeeper> m_keeper;
  std::optional<control::CounterKeeper> m_counters; ///< none while it does not count
  Eigen::Vector3d m_worstFollowingError{0, 0, 0};   ///< mm
  std::vector<Alarm> m_alarms;
  std::optional<base::Problem> m_complaint;
  std::optional<base::Problem> m_refusalSeen; ///< of the operator's side, told already
  Allowed m_told;
  control::State m_toldState = control::State::Off;
  control::JobState m_toldJob = control::JobState::Idle;
  QTimer m_timer;
  QThreadPool m_pool; ///< one thread; last, so that it ends before what it uses
};

} // namespace arris::ui
