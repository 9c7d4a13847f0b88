#pragma once

#include "core/control/command.h"
#include "core/control/report.h"
#include "core/control/rotary_buffers.h"

#include <boost/lockfree/spsc_queue.hpp>

namespace arris::control {

/// All that passes between the operator's side and the controller, as values through bounded queues without locks.
struct Channels {
  boost::lockfree::spsc_queue<Command> commands{256};
  RotaryBuffers buffers;
  boost::lockfree::spsc_queue<Report> reports{8192};
  boost::lockfree::spsc_queue<FaultReport> faults{1024};
};

} // namespace arris::control
