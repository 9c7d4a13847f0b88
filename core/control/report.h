#pragma once

#include "core/control/axis_driver.h"
#include "core/control/faults.h"
#include "core/control/states.h"
#include "core/program/program.h"

#include <cstdint>
#include <string>

namespace arris::control {

/// Where the wheel is beside its path in a hold.
enum class Aside { OnPath, BackingOff, BackedOff, Raised };

/// Everything about one period, as it comes up from the controller: what the screen shows, records keep and the
/// operator's side decides by. Places in table coordinates, mm.
struct Report {
  std::int64_t tick = 0;     ///< periods since the controller began
  std::int64_t runTick = -1; ///< periods since the first motion of the run; −1 outside a run
  State state = State::Off;
  Aside aside = Aside::OnPath;
  double beside = 0; ///< mm, how far it went off the glass along the normal
  bool homed = false;
  bool drivesReady = false;
  std::uint32_t program = 0; ///< number of the program that is loaded; 0 none
  program::Kind kind = program::Kind::Job;
  bool isInMotion = false;                        ///< on the path of the program: `segment` and λ hold
  int segment = -1;                               ///< of the program's track
  double lambda = 0, speed = 0, acceleration = 0; ///< of λ: mm, mm/s, mm/s²
  motion::Move move = motion::Move::Approach;     ///< of that segment, as the following
  int contour = 0, number = 0, corner = 0;
  int stopCorner = 0;                  ///< the corner at which the wheel stops at its end; 0 none
  double path = 0;                     ///< true length travelled in the run, mm
  program::JobPlace place;             ///< on the job's way, the last one known
  Eigen::Vector3d segmentEnd{0, 0, 0}; ///< where that segment of the program ends
  double feed = 0;                     ///< mm/s, programmed for it at an override of 100 %
  double overrideFactor = 1;
  bool mayJog = true; ///< the panel's jog enable is held, or not required
  Eigen::Vector3d commanded{0, 0, 0};
  Eigen::Vector3d velocity{0, 0, 0};         ///< commanded, mm/s
  Eigen::Vector3d axisAcceleration{0, 0, 0}; ///< commanded, mm/s²
  std::int64_t measuredTick = -1;            ///< the period that `measured` belongs to
  Eigen::Vector3d measured{0, 0, 0};
  Eigen::Vector3d followingError{0, 0, 0}; ///< at that period
  Eigen::Vector3d origin{0, 0, 0};         ///< G54
  Inputs inputs;
  Outputs outputs;
  Faults faults;
  int pairsBuffered = 0;
  std::int64_t stops = 0;     ///< stops ordered so far, by whoever
  std::int64_t jobsEnded = 0; ///< programs of jobs that came to their end, so far
  std::int64_t refused = 0;   ///< commands that the state did not allow, so far
  std::int64_t lost = 0;      ///< reports that found no room, so far
};

/// A fault as it happened.
struct FaultReport {
  std::int64_t tick = 0;
  Fault fault = Fault::EmergencyStop;
  int axis = -1;
  double value = 0;
};

/// The fault in an English sentence.
[[nodiscard]] std::string describe(const FaultReport& fault);

} // namespace arris::control
