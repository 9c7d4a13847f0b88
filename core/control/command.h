#pragma once

#include "core/motion/speed_limits.h"
#include "core/program/program.h"

#include <cstdint>
#include <variant>

namespace arris::control {

/// What the controller must know of a program before its pairs come.
struct ProgramHeader {
  std::uint32_t number = 0; ///< of the program, above 0; its records carry it
  program::Kind kind = program::Kind::Job;
  motion::AxisLimits limits;
  double clearanceHeight = 0; ///< mm, of the wheel above the table; at it and above the wheel is clear of the glass
  double wheelSide = 1;       ///< +1: the wheel runs on the left of its direction of travel, −1 right
  double spindleSpeed = 0;    ///< r/min; 0: the program needs no spindle
  bool beginsRun = false;     ///< time of the run begins at 0 with its first motion
  program::JobPlace place;    ///< on the job's way where it takes it up
  std::int64_t stops = 0;     ///< Report::stops when it was ordered: a stop in between beats it
};

/// What the operator's side asks of the controller. Values only; refused where the table of states does not allow it.
namespace command {
struct Enable {};

struct Disable {};

struct Home {};

struct Load {
  ProgramHeader program;
}; ///< forgets what is in the buffers; the pairs of this program follow

struct Start {}; ///< the program that is loaded: job, step or way at height

struct Hold {}; ///< feed hold

struct Resume {}; ///< from where the wheel stands on the path

struct Stop {}; ///< controlled stop; the program is forgotten

struct Acknowledge {};

struct Override {
  double factor = 1; ///< 0.1 to 1.5
};

struct JogAt {
  Eigen::Vector3d velocity{0, 0, 0}; ///< mm/s; to be said again within 0.2 s, or the axes stop
};

struct JogBy {
  Eigen::Vector3d way{0, 0, 0}; ///< mm
};

struct SetOrigin {
  Eigen::Vector3d origin{0, 0, 0}; ///< G54: the table's zero in machine coordinates, mm
};

struct SpindleByHand {
  double speed = 0; ///< r/min; 0 off
};

struct CoolantByHand {
  bool on = false;
};

struct Heartbeat {}; ///< the operator's side lives
} // namespace command

using Command = std::variant<command::Enable, command::Disable, command::Home, command::Load, command::Start,
                             command::Hold, command::Resume, command::Stop, command::Acknowledge, command::Override,
                             command::JogAt, command::JogBy, command::SetOrigin, command::SpindleByHand,
                             command::CoolantByHand, command::Heartbeat>;

} // namespace arris::control
