#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>

namespace arris::control {

inline constexpr int kAxes = 3; ///< X, Y, Z

/// Signals from the machine and its panel. A button is true while it is pressed.
struct Inputs {
  bool emergencyStop = false;           ///< the hard-wired emergency stop has tripped
  std::array<bool, kAxes> limitLow{};   ///< limit switch at the low end of an axis is hit
  std::array<bool, kAxes> limitHigh{};  ///< and at the high end
  std::array<bool, kAxes> reference{};  ///< reference switch is on
  std::array<bool, kAxes> driveReady{}; ///< the drive is enabled and holds its axis
  std::array<bool, kAxes> driveFault{};
  std::array<bool, kAxes> encoderLost{};
  bool spindleAtSpeed = false;
  bool coolantFlows = false;
  bool vacuumHolds = false;
  bool cycleStart = false, hold = false, stop = false, jogEnable = false; ///< panel buttons
  int overridePercent = 0; ///< of the panel's selector; 0 where there is none
  bool operator==(const Inputs&) const = default;
};

/// Signals to the machine. They act at once, set-points in their turn.
struct Outputs {
  std::array<bool, kAxes> driveEnable{};
  double spindleSpeed = 0; ///< r/min; 0 off
  bool coolant = false;
  bool heartbeat = false; ///< changes with every period: the controller lives
  bool operator==(const Outputs&) const = default;
};

/// What the axes report.
struct Feedback {
  std::int64_t tick = -1;            ///< number of the last set-point that the axes have taken; −1 none yet
  Eigen::Vector3d position{0, 0, 0}; ///< measured at that instant, machine coordinates of the encoders, mm
  Inputs inputs;
  std::int64_t underruns = 0; ///< periods for which no set-point was there
};

/// The hardware seam: takes one set-point a period, somewhat ahead of time, and follows them on its own clock. The
/// methods are for the control loop: they do not block, allocate or throw.
class AxisDriver {
public:
  AxisDriver() = default;
  AxisDriver(const AxisDriver&) = delete;
  AxisDriver& operator=(const AxisDriver&) = delete;
  virtual ~AxisDriver() = default;

  /// The latest that the axes have reported.
  [[nodiscard]] virtual Feedback read() = 0;

  /// The set-point that follows the last one (mm, coordinates of the encoders), and the outputs from now on. False, and
  /// nothing is taken, where the queue is full.
  virtual bool write(const Eigen::Vector3d& setPoint, const Outputs& outputs) = 0;

  /// Set-points written that the axes have not taken yet.
  [[nodiscard]] virtual int queued() = 0;
};

} // namespace arris::control
