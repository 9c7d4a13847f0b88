#include "core/control/states.h"

#include <algorithm>
#include <array>

namespace arris::control {
namespace {

constexpr auto table() {
  using enum State;
  return std::array{Transition{Off, Event::Enable, NotHomed},
                    Transition{Off, Event::Enable, Idle}, // where the places are still known

                    Transition{NotHomed, Event::Disable, Off},
                    Transition{NotHomed, Event::Home, Homing},
                    Transition{NotHomed, Event::Jog, Jogging},

                    Transition{Homing, Event::Homed, Idle},
                    Transition{Homing, Event::Hold, Stopping},
                    Transition{Homing, Event::Stop, Stopping},

                    Transition{Idle, Event::Disable, Off},
                    Transition{Idle, Event::Home, Homing},
                    Transition{Idle, Event::Jog, Jogging},
                    Transition{Idle, Event::Start, Starting},
                    Transition{Idle, Event::Position, Positioning},

                    Transition{Starting, Event::Ready, Running},
                    Transition{Starting, Event::Hold, Held},
                    Transition{Starting, Event::Stop, Stopping},

                    Transition{Running, Event::Hold, Holding},
                    Transition{Running, Event::Stop, Stopping},
                    Transition{Running, Event::ProgramEnd, Idle},

                    Transition{Holding, Event::AtRest, Held},
                    Transition{Holding, Event::Resume, Running},
                    Transition{Holding, Event::Resume, Positioning},
                    Transition{Holding, Event::Stop, Stopping},
                    Transition{Holding, Event::ProgramEnd, Idle}, // it came to rest at the very end

                    Transition{Held, Event::Resume, Starting},
                    Transition{Held, Event::Resume, Positioning},
                    Transition{Held, Event::Start, Starting}, // re-entry
                    Transition{Held, Event::Step, Stepping},
                    Transition{Held, Event::Stop, Stopping},

                    Transition{Stepping, Event::ProgramEnd, Held},
                    Transition{Stepping, Event::AtRest, Held}, // held on its way
                    Transition{Stepping, Event::Hold, Stepping},
                    Transition{Stepping, Event::Stop, Stopping},

                    Transition{Jogging, Event::Jog, Jogging},
                    Transition{Jogging, Event::AtRest, Idle},
                    Transition{Jogging, Event::AtRest, NotHomed},
                    Transition{Jogging, Event::Hold, Stopping},
                    Transition{Jogging, Event::Stop, Stopping},

                    Transition{Positioning, Event::Hold, Holding},
                    Transition{Positioning, Event::Stop, Stopping},
                    Transition{Positioning, Event::ProgramEnd, Idle},

                    Transition{Stopping, Event::Stop, Stopping},
                    Transition{Stopping, Event::Hold, Stopping},
                    Transition{Stopping, Event::AtRest, Idle},
                    Transition{Stopping, Event::AtRest, NotHomed},
                    Transition{Stopping, Event::AtRest, Faulted},

                    Transition{Faulted, Event::Acknowledge, Idle},
                    Transition{Faulted, Event::Acknowledge, NotHomed},
                    Transition{Faulted, Event::Acknowledge, Off},

                    Transition{EmergencyStop, Event::Acknowledge, Off}};
}

constexpr auto kTransitions = table();

// From everywhere, whatever it does: nothing stands before the machine's safety.
std::optional<State> always(State from, Event event) {
  switch (event) {
  case Event::EmergencyStop:
    return State::EmergencyStop;
  case Event::DrivesOff:
    return from == State::EmergencyStop ? State::EmergencyStop : State::Faulted;
  case Event::Fault:
    return from == State::EmergencyStop || from == State::Faulted || from == State::Off ? from : State::Stopping;
  default:
    return std::nullopt;
  }
}

constexpr std::array<std::string_view, kStateCount> kStateNames{
    "off",  "not-homed", "homing",  "idle",        "starting", "running", "holding",
    "held", "stepping",  "jogging", "positioning", "stopping", "faulted", "emergency-stop"};

constexpr std::array<std::string_view, kEventCount> kEventNames{
    "enable", "disable",     "home",  "jog",     "start",       "position", "step",  "hold",       "resume",
    "stop",   "acknowledge", "ready", "at-rest", "program-end", "homed",    "fault", "drives-off", "emergency-stop"};

} // namespace

std::string_view name(State state) {
  return kStateNames[static_cast<std::size_t>(state)];
}

std::string_view name(Event event) {
  return kEventNames[static_cast<std::size_t>(event)];
}

std::span<const Transition> transitions() {
  return kTransitions;
}

std::optional<State> next(State from, Event event) {
  if (const auto state = always(from, event)) {
    return state;
  }
  const auto* const row = std::find_if(kTransitions.begin(), kTransitions.end(), [&](const Transition& transition) {
    return transition.from == from && transition.event == event;
  });
  return row == kTransitions.end() ? std::nullopt : std::optional(row->to);
}

bool isAllowed(State from, Event event, State to) {
  if (const auto state = always(from, event)) {
    return *state == to;
  }
  return std::any_of(kTransitions.begin(), kTransitions.end(), [&](const Transition& transition) {
    return transition.from == from && transition.event == event && transition.to == to;
  });
}

bool isMoving(State state) {
  using enum State;
  return state == Homing || state == Starting || state == Running || state == Holding || state == Held ||
         state == Stepping || state == Jogging || state == Positioning || state == Stopping;
}

std::string_view name(JobState state) {
  static constexpr std::array<std::string_view, 8> kNames{"Idle",    "Queued",      "Released", "Initialized",
                                                          "Running", "Interrupted", "Aborted",  "Ended"};
  return kNames[static_cast<std::size_t>(state)];
}

} // namespace arris::control
