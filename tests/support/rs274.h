#pragma once

#include "core/geometry/curve.h"

#include <string>
#include <vector>

namespace arris::test {

/// A motion that LinuxCNC's interpreter asks the machine for. It prints four decimals.
struct CanonicalMotion {
  enum class Kind { Rapid, Line, Arc, Spline };
  Kind kind = Kind::Rapid;
  Eigen::Vector3d from{0, 0, 0}; ///< mm; not known after a spline
  Eigen::Vector3d to{0, 0, 0};   ///< mm; not known of a spline
  geometry::Point center{0, 0};  ///< of an arc
  bool counterClockwise = false;
  double feed = 0;        ///< mm/min
  bool exactStop = false; ///< in exact stop mode
  bool spindleOn = false;
  bool coolantOn = false;
};

/// What the interpreter makes of a program.
struct Interpretation {
  int status = 0; ///< 0: accepted
  std::string message;
  std::vector<CanonicalMotion> motions;
  bool ended = false; ///< by M2 or M30
};

/// Runs LinuxCNC's stand-alone interpreter (rs274 of the package linuxcnc-uspace) over a program.
[[nodiscard]] Interpretation interpret(const std::string& program);

} // namespace arris::test
