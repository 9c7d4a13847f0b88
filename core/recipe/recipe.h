#pragma once

#include "core/base/problem.h"

#include <Eigen/Core>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace arris::recipe {

/// How the axis accelerations bind the speed: each axis on its own (the promise that none exceeds its limit), or the
/// resultant of X and Y as in the paper's Eq. (15), which does not keep the limits of the single axes.
enum class AccelerationRule { PerAxis, Combined };

/// Direction round outlines; cut-outs run the other way so that the glass stays on the same side (cw: on the right).
enum class Direction { Clockwise, CounterClockwise };

/// Mirroring of the pattern before it is rotated: X negates the X coordinates, Y the Y coordinates.
enum class Mirror { None, X, Y };

enum class Units { Millimetre, Centimetre, Metre, Inch, Foot };

/// Everything the operator chooses for a pane. Defaults are the paper's. Units are in the names of the table of fields
/// (fields.h): mm, mm/min, mm/s², r/min, degrees, percent.
struct Recipe {
  double wheelRadius = 75;   ///< mm
  double wheelHeight = 30;   ///< mm, thickness of the wheel
  double wheelZ = 0;         ///< mm, fine adjustment of the grinding height
  double depth = 0.13;       ///< mm, normal grinding depth d_n
  double thickness = 12;     ///< mm, of the glass
  double support = 40;       ///< mm, underside of the glass above the table
  double clearance = 10;     ///< mm, wheel's lower face above the glass when traversing
  double feed = 3600;        ///< mm/min, v_nor
  double accelX = 20;        ///< mm/s²
  double accelY = 20;        ///< mm/s²
  double accelZ = 20;        ///< mm/s²
  double spindle = 6000;     ///< r/min
  double cornerSpeed = 100;  ///< percent of v_trans
  double sizeCorrection = 0; ///< mm, positive leaves the pane larger
  double lead = 20;          ///< mm, radius of the lead-in and lead-out arcs
  double overlap = 10;       ///< mm along the contour past the start
  double rotate = 0;         ///< degrees, about the drawing's origin
  double gap = 0.05;         ///< mm, joining of pieces
  double smooth = 0.01;      ///< mm, fitting of chopped curves
  AccelerationRule accelerationRule = AccelerationRule::PerAxis;
  Direction direction = Direction::Clockwise;
  Mirror mirror = Mirror::None;
  std::optional<Eigen::Vector2d> start; ///< mm on the table; the contour point nearest to it is the start
  std::optional<Eigen::Vector2d> place; ///< mm on the table, lower-left corner of the outlines; centred by default
  std::optional<Units> units;           ///< of the drawing, over what the file says
  std::vector<std::string> layers;      ///< only these; all where empty
  bool acceptUnreached = false;

  [[nodiscard]] double feedPerSecond() const {
    return feed / 60;
  } ///< mm/s

  bool operator==(const Recipe&) const = default;
};

/// What the machine is and can do. Travel is the box of the wheel's centre in table coordinates.
struct Machine {
  Eigen::Vector3d travel{1500, 2500, 120};      ///< mm
  Eigen::Vector3d maxSpeed{12000, 12000, 3000}; ///< mm/min
  Eigen::Vector3d maxAccel{500, 500, 500};      ///< mm/s²
  double plungeFeed = 1000;                     ///< mm/min
  Eigen::Vector3d park{0, 0, 120};              ///< mm
  double period = 0.001;                        ///< s, servo period
  Eigen::Vector3d homeAt{0, 0, 120}; ///< mm, where an axis stands when its reference switch comes on; the switch is on
                                     ///< from there to the nearer end of the travel
  double homeSearch = 1500;          ///< mm/min, towards the switch
  double homeLatch = 60;             ///< mm/min, off the switch again, when the place is taken
  double jogSpeed = 3000;            ///< mm/min, the fastest jog
  double setPointLead = 0.03;        ///< s, how far ahead of time set-points are handed to the axes
  double followingError = 1;         ///< mm, more than this between set-point and measured place is a fault
  double backOff = 5;                ///< mm along the normal, when the wheel stands turning on the glass
  double backOffAfter = 2;           ///< s at rest
  double spindleWait = 15;           ///< s, for the spindle to reach its speed and the coolant to flow
  bool jogEnableRequired = false;    ///< jog only while the panel's jog enable is held

  bool operator==(const Machine&) const = default;
};

} // namespace arris::recipe
