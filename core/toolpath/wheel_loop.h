#pragma once

#include "core/toolpath/blocked.h"
#include "core/toolpath/offset.h"
#include "core/toolpath/toolpath.h"

#include <stop_token>
#include <vector>

namespace arris::toolpath {

inline constexpr int kNoCorner = -1;

/// One primitive of a closed wheel path and what it does to the glass.
struct Step {
  geometry::Curve path;
  Role role = Role::Contour;  ///< Contour, Transition or Roll
  EdgeId edge = 0;            ///< the edge that is ground; of a corner, the edge before it
  Stretch ground;             ///< which part of the edge (Contour only), mm along the edge
  int corner = kNoCorner;     ///< whose transition, roll or arc this is: index among the corners of the loop
  bool stopAtEnd = false;     ///< a kink follows
  int stopCorner = kNoCorner; ///< the concave corner to which that kink belongs
};

/// The edges that the wheel touches before and after the fillet that it leaves at a single concave corner.
struct Fillet {
  EdgeId before = 0;
  EdgeId after = 0;
};

/// A closed way of the wheel with every corner decided, not started anywhere yet.
struct WheelLoop {
  std::vector<Step> steps;
  std::vector<Corner> corners; ///< not numbered yet
  std::vector<Fillet> fillets;
  base::Problems problems;
};

/// Bridges every corner of a loop: a transition where it is called for and no other glass is in its way, else the roll;
/// a tangential arc or a stop at every kink. A stop token ends it early. Source: method §1, items 2 and 6.
[[nodiscard]] WheelLoop makeWheelLoop(const Glass& glass, const Offset& offset, const Loop& loop,
                                      const recipe::Recipe& recipe, const std::stop_token& stop = {});

} // namespace arris::toolpath
