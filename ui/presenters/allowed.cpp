#include "ui/presenters/allowed.h"

namespace arris::ui {

using control::Event;
using control::State;

Allowed allowedIn(const control::Report& report, control::JobState job, bool isLoaded, bool isOrdered) {
  const auto may = [&](Event event) { return control::next(report.state, event).has_value(); };
  const bool isIdle = report.state == State::Idle && report.program == 0 && !isOrdered;
  const bool isAtHome = isIdle && report.homed && report.drivesReady;
  const bool isHeldUp = report.inputs.emergencyStop;
  const bool runs = job == control::JobState::Running || job == control::JobState::Interrupted;
  Allowed allowed;
  allowed.enable = report.state == State::Off && !isHeldUp;
  allowed.disable = may(Event::Disable);
  allowed.home = may(Event::Home) && report.drivesReady && !isOrdered;
  allowed.jog =
      report.mayJog && (report.state == State::Jogging || (may(Event::Jog) && report.drivesReady && !isOrdered));
  allowed.move = isAtHome;
  allowed.origin = isAtHome && job != control::JobState::Aborted;
  allowed.byHand = isAtHome;
  allowed.acknowledge = may(Event::Acknowledge) && !isHeldUp;
  allowed.load = report.program == 0 && !isOrdered && !runs;
  allowed.judge = allowed.load && isLoaded;
  allowed.start = isAtHome && isLoaded;
  allowed.resume = report.state == State::Held || report.state == State::Holding;
  allowed.step = report.state == State::Held && isLoaded;
  allowed.hold = isOrdered || (may(Event::Hold) && report.state != State::Stopping);
  const bool turns = report.outputs.spindleSpeed > 0 || report.outputs.coolant;
  allowed.stop = control::isMoving(report.state) || turns || isOrdered;
  allowed.restore = !allowed.stop && !isLoaded && report.program == 0;
  return allowed;
}

} // namespace arris::ui
