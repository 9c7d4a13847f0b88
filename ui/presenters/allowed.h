#pragma once

#include "core/control/report.h"

namespace arris::ui {

/// What the operator may do now. The one place where the window's buttons are enabled from the controller's state; the
/// controller decides for itself all the same.
struct Allowed {
  bool enable = false;
  bool disable = false;
  bool home = false;
  bool jog = false;
  bool move = false;   ///< trace, park
  bool origin = false; ///< another origin: a pane that was broken off keeps its own
  bool byHand = false; ///< spindle and coolant
  bool acknowledge = false;
  bool load = false;  ///< another job
  bool judge = false; ///< the pane that has ended, or was broken off
  bool start = false;
  bool resume = false;
  bool step = false;
  bool hold = false;
  bool stop = false;    ///< something moves or turns, or may begin to
  bool restore = false; ///< what the machine is and how it works: nothing of it is in use
  bool operator==(const Allowed&) const = default;
};

/// `isOrdered`: something has been asked for that has not begun yet.
[[nodiscard]] Allowed allowedIn(const control::Report& report, control::JobState job, bool isLoaded, bool isOrdered);

} // namespace arris::ui
