#pragma once

#include "core/control/channels.h"
#include "core/control/homing.h"
#include "core/control/path_window.h"
#include "core/motion/interpolator.h"
#include "core/recipe/recipe.h"

#include <optional>
#include <vector>

namespace arris::control {

/// What the controller gives to the axes in one period.
struct Cycle {
  Eigen::Vector3d setPoint{0, 0, 0}; ///< encoder coordinates, mm
  Outputs outputs;
};

/// The logic of the machine: commands and feedback in, set-points, outputs and reports out. It has no thread and no
/// clock: each call of `advance` is one servo period. In it nothing is allocated, locked, logged or thrown.
class Controller {
public:
  /// Refers to `channels`. The machine has been checked.
  Controller(const recipe::Machine& machine, Channels& channels);

  /// One servo period.
  const Cycle& advance(const Feedback& feedback);

  /// What the period gave, also in the reports.
  [[nodiscard]] const Report& report() const {
    return m_report;
  }

  /// Set-points are this many periods ahead of the axes.
  [[nodiscard]] int leadPeriods() const {
    return m_lead;
  }

private:
  // Commands and events (controller.cpp)
  void takeCommands();
  void takeButtons();
  void handle(Event event);
  void enter(State state);
  [[nodiscard]] State choose(Event event, State state) const;
  [[nodiscard]] bool mayFollow(Event event) const;
  void handle(const Command& command);
  void load(const ProgramHeader& header);
  void forgetProgram();
  void jog(const Eigen::Vector3d& velocity);
  void jogBy(const Eigen::Vector3d& way);
  [[nodiscard]] bool mayJog() const;
  void beginRamps();
  void tell();

  // What may go wrong (controller_watch.cpp)
  void watch();
  void watchInputs();
  [[nodiscard]] bool hitsLimit(std::size_t axis) const;
  void watchFeedback();
  void watchServices();
  void raise(Fault fault, int axis = -1, double value = 0);
  void keepReachedPlace();
  [[nodiscard]] bool isConsistent(const Eigen::Vector3d& setPoint);
  [[nodiscard]] bool drivesReady() const;

  // Motion (controller_motion.cpp)
  void move();
  void beginPath();
  void movePath(double factor);
  void moveStarting();
  void moveHeld();
  void moveStopping();
  void moveHoming();
  void moveJogging();
  void tellSegment(const motion::SetPoint& at);
  void endOfProgram();
  [[nodiscard]] bool wouldRunDry() const;
  [[nodiscard]] bool isOnGlass() const;
  [[nodiscard]] const motion::Segment& segmentUnder() const;
  void backOff();
  void raiseWheel();
  void beginShort(const motion::Segment& segment);
  bool moveShort(double factor);
  void set(const motion::SetPoint& point);
  void standStill();
  void followAxes();

  [[nodiscard]] Eigen::Vector3d tableOf(const Eigen::Vector3d& encoder) const {
    return encoder + m_offset - m_origin;
  }

  recipe::Machine m_machine;
  Channels& m_channels;
  double m_period;
  int m_lead;
  std::int64_t m_tick = -1;
  Feedback m_feedback;
  Inputs m_lastInputs;
  State m_state = State::Off;
  Faults m_faults;
  Report m_report;
  Cycle m_cycle;

  // Places
  bool m_homed = false;
  Eigen::Vector3d m_offset{0, 0, 0};       ///< machine minus encoder coordinates
  Eigen::Vector3d m_origin{0, 0, 0};       ///< G54
  std::vector<Eigen::Vector3d> m_history;  ///< set-points by tick, a ring
  std::vector<program::JobPlace> m_places; ///< on the job's way by tick, a ring
  Eigen::Vector3d m_velocity{0, 0, 0};     ///< of the last set-point by difference, mm/s, for the guard
  int m_guarded = 0;                       ///< set-points since the last break
  std::int64_t m_movedTick = 0;            ///< of the last set-point that differed from the one before
  Eigen::Vector3d m_most{0, 0, 0};         ///< accelerations of what moves, mm/s²
  std::int64_t m_underruns = 0;
  std::int64_t m_freshTick = 0; ///< when the feedback's tick last changed
  std::int64_t m_readyTick = 0; ///< when the drives became ready
  std::int64_t m_enabledTick = 0;
  bool m_wereReady = false;

  // The program
  ProgramHeader m_program;
  PathWindow m_window;
  std::optional<motion::Interpolator> m_path;
  std::int64_t m_pathTick = 0; ///< of the next set-point on the path
  int m_pathSegment = 0;       ///< segments before it are left behind
  double m_travelled = 0;      ///< in the run up to that segment, mm
  double m_override = 1;
  bool m_runs = false; ///< the run's time goes on
  bool m_holdStep = false;
  std::int64_t m_loadedTick = 0;
  std::optional<program::JobPlace> m_reachedPlace; ///< when the axes ceased to follow; the run is broken off there

  // Beside the path
  motion::Segment m_shortSegment;
  motion::Interval m_shortInterval;
  std::optional<motion::Interpolator> m_short;
  std::int64_t m_shortTick = 0;
  std::int64_t m_restTicks = 0; ///< at rest in a hold
  Aside m_aside = Aside::OnPath;
  bool m_raise = false; ///< after the stop
  bool m_cutDrives = false;
  bool m_drivesOn = false;

  // By hand
  std::array<AxisRamp, kAxes> m_ramps;
  Homing m_homing;
  Eigen::Vector3d m_jogVelocity{0, 0, 0};
  Eigen::Vector3d m_jogTarget{0, 0, 0};
  bool m_jogsToTarget = false;
  bool m_jogEnabled = false; ///< by a fresh press of the panel's jog enable that still lasts
  bool m_rampsMove = false;
  std::int64_t m_jogTick = 0;
  std::int64_t m_operatorTick = 0;
  std::int64_t m_startTick = 0;
  double m_spindle = 0;
  bool m_coolant = false;
};

} // namespace arris::control
