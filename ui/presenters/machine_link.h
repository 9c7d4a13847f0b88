#pragma once

#include "core/control/counter_keeper.h"
#include "core/control/run_keeper.h"
#include "core/control/simulated_axes.h"
#include "core/control/station.h"
#include "ui/presenters/allowed.h"
#include "ui/presenters/planner.h"

#include <QObject>
#include <QString>
#include <QTimer>

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
  control::StateFolder folder;
  control::Pace pace = control::Pace::Real; ///< Simulated: as fast as it can, for tests
};

/// The machine as the window sees it: the simulated axes with their controller, in a thread of its own in real time,
/// and the operator's side, which is served from the window's thread: where the window hangs the controller stops.
/// Commands go down and reports come up as values. Shares nothing with widgets.
class MachineLink : public QObject {
  Q_OBJECT

public:
  explicit MachineLink(const MachineSetup& setup, QObject* parent = nullptr);
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

  /// Of the job that is loaded, as far as it was ground in this run; 0 to 1.
  [[nodiscard]] double progress() const;

  /// To the end of the run at 100 %, s.
  [[nodiscard]] double timeLeft() const;

  /// Every fault since the program began, the latest last.
  [[nodiscard]] const std::vector<Alarm>& alarms() const {
    return m_alarms;
  }

  /// What could not be started or written, the last of it.
  [[nodiscard]] const std::optional<base::Problem>& complaint() const {
    return m_complaint;
  }

  /// The record of the present or the last run; empty before the first.
  [[nodiscard]] std::filesystem::path record() const {
    return m_keeper ? m_keeper->record() : std::filesystem::path();
  }

  /// Tells a problem on the banner, until the operator goes on.
  void complain(const base::Problem& problem);

  /// Where the machine keeps what its runs leave.
  [[nodiscard]] const control::StateFolder& folder() const {
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
  void load(const PlanPointer& plan, int panes);
  void start(); ///< cycle start: the next pane, or the pane that was broken off from where it was
  void hold();
  void resume();
  void step(double distance); ///< mm along the path, negative back
  void stop();
  void trace();
  void park();
  void jogAt(const Eigen::Vector3d& velocity); ///< mm/s; to be said again within 0.2 s
  void setOverride(double factor);
  void inject(control::SimulatedFault fault);
  void clearFaults(); ///< of the simulated machine

Q_SIGNALS:
  /// A new period has been reported.
  void reported();
  /// State, job or what is allowed have changed.
  void changed();
  void alarmRaised(const arris::ui::Alarm& alarm);

private:
  MachineLink(const MachineSetup& setup, std::unique_ptr<control::SimulatedAxes> axes, QObject* parent);

  void pass();

  [[nodiscard]] const control::Supervisor& operatorSide() const {
    return m_station.operatorSide();
  }

  void hear(const control::Report& report);
  void hear(const control::FaultReport& fault);
  files::Alarm log(const control::FaultReport& fault);
  void logged(const base::Expected<void>& result);
  void tellChanges();

  control::StateFolder m_folder;
  control::Pace m_pace;
  recipe::Machine m_machine;
  control::SimulatedAxes* m_axes; ///< the station's
  control::Station m_station;
  PlanPointer m_loaded;
  double m_length = 1; ///< of the job's way, mm
  std::unique_ptr<control::RunKeeper> m_keeper;
  std::optional<control::CounterKeeper> m_counters; ///< none while it does not count
  Eigen::Vector3d m_worstFollowingError{0, 0, 0};   ///< mm
  std::vector<Alarm> m_alarms;
  std::optional<base::Problem> m_complaint;
  Allowed m_told;
  control::State m_toldState = control::State::Off;
  control::JobState m_toldJob = control::JobState::Idle;
  QTimer m_timer;
};

} // namespace arris::ui
