#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace arris::control {

/// What the controller is doing.
enum class State {
  Off,      ///< drives off
  NotHomed, ///< drives on, places unknown
  Homing,
  Idle,     ///< at rest, ready
  Starting, ///< waits for spindle, coolant and the first of the program
  Running,
  Holding,  ///< brakes on the path
  Held,     ///< at rest in a program, or backed off the glass
  Stepping, ///< along the path while held
  Jogging,
  Positioning,   ///< outline trace, go to park
  Stopping,      ///< brakes to rest, then raises the wheel where that is asked for
  Faulted,       ///< at rest after a fault, until it is acknowledged
  EmergencyStop, ///< the emergency stop has tripped; drives off
};
inline constexpr int kStateCount = 14;
[[nodiscard]] std::string_view name(State state); ///< "not-homed"

/// What makes the state change: commands of the operator, and what the controller sees.
enum class Event {
  Enable,
  Disable,
  Home,
  Jog,
  Start,    ///< cycle start of the program that is loaded
  Position, ///< start of a way at height
  Step,
  Hold,
  Resume,
  Stop,
  Acknowledge,
  Ready,      ///< spindle at speed, coolant flows, the first of the program is there
  AtRest,     ///< what was under way has come to rest
  ProgramEnd, ///< at rest at the end of the program
  Homed,
  Fault,         ///< of stop category 1 or 2: brake first
  DrivesOff,     ///< a fault of stop category 0
  EmergencyStop, ///< its input
};
inline constexpr int kEventCount = 18;
[[nodiscard]] std::string_view name(Event event);

/// A row of the table of states.
struct Transition {
  State from;
  Event event;
  State to;
};

/// The whole table. Where AtRest in Stopping and Acknowledge lead depends on faults and homing: the controller chooses
/// among the rows that fit.
[[nodiscard]] std::span<const Transition> transitions();

/// Whether an event is allowed in a state, and where it leads first of all; nothing where it is refused.
[[nodiscard]] std::optional<State> next(State from, Event event);

/// Whether one may follow the other by that event.
[[nodiscard]] bool isAllowed(State from, Event event, State to);

/// Whether the axes move, or may begin to at any time without a further command.
[[nodiscard]] bool isMoving(State state);

/// The job's state by OPC 40301 (flat glass processing).
enum class JobState { Idle, Queued, Released, Initialized, Running, Interrupted, Aborted, Ended };
[[nodiscard]] std::string_view name(JobState state);

} // namespace arris::control
