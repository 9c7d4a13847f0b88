#pragma once

#include "core/motion/track.h"

#include <cstdint>

namespace arris::program {

/// On which side of a sharp corner a segment lies (the paper's `datatype`).
enum class CornerSide { None, Before, After };

/// A place on the job's way: a segment of its track and λ on it, mm. The segment is −1 off the job's way.
struct JobPlace {
  int segment = -1;
  double lambda = 0;
  bool operator==(const JobPlace&) const = default;
};

/// How places of a program's segment lie on the job's way: λ on it is at `from.lambda + rate·λ`; the rate is −1 where a
/// step goes back, and differs from ±1 where the wheel goes beside the way.
struct JobStretch {
  JobPlace from;
  double rate = 1;
};

[[nodiscard]] inline JobPlace placeOn(const JobStretch& stretch, double lambda) {
  return {stretch.from.segment, stretch.from.lambda + stretch.rate * lambda};
}

/// The transition at a sharp corner, which the controller generates in the broken zone between the segments before and
/// after it, Eq. (1): the quadratic Bézier A, Q, C.
struct Transition {
  geometry::Point a, q, c;
  int number = 0; ///< of the wheel path's primitive
  int limits = 0; ///< how many of its speed limits follow the segment's own in the buffer
};

/// The auxiliary record of a segment: the paper's INPUTPOINT, and how many speed limits of section 3 (motion::Interval)
/// follow it in the second buffer. Where `sharpCorner` is set and `side` is Before, the transition follows the segment.
struct InputPoint {
  std::uint32_t program = 0; ///< number of the program that it belongs to
  int segment = 0;           ///< index in the program, transitions counted
  bool isLast = false;       ///< the program ends with this pair
  double normalSpeed = 0;    ///< v_nor, mm/s
  bool sharpCorner = false;
  CornerSide side = CornerSide::None;
  int corner = 0;                                        ///< of the sharp corner before or after
  double transitionSpeed = 0;                            ///< v_trans, mm/s
  double cornerAngle = 0;                                ///< β, rad
  geometry::Vector accelerations{0, 0};                  ///< a_x, a_y, mm/s²
  double decelerationLength = 0, accelerationLength = 0; ///< L_d, L_a that the profile has, mm
  double room = 0; ///< mm, how far the wheel may go off the glass along the normal anywhere on the segment
  double transitionRoom = 0;
  int limits = 0;        ///< how many speed limits follow for the segment itself
  Transition transition; ///< where the segment stands before a sharp corner
  JobStretch place;
  JobStretch transitionPlace;
};

} // namespace arris::program
