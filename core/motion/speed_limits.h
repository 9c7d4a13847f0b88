#pragma once

#include "core/motion/track.h"
#include "core/recipe/recipe.h"

#include <stop_token>
#include <vector>

namespace arris::motion {

/// The limits of the axes. Under AccelerationRule::Combined X and Y bind by the resultant √(a_x²+a_y²) alone.
struct AxisLimits {
  Eigen::Vector3d acceleration{0, 0, 0}; ///< mm/s²
  Eigen::Vector3d speed{0, 0, 0};        ///< mm/s
  recipe::AccelerationRule rule = recipe::AccelerationRule::PerAxis;
};

[[nodiscard]] AxisLimits axisLimits(const recipe::Recipe& recipe, const recipe::Machine& machine);

/// A stretch of one segment on which λ̈ may be held. Inside it K² is the lesser of two straight lines over λ: what the
/// speeds of blend and machine let pass, from cap2 to capEnd2, and the braking line end2 + 2 brake (to − λ).
struct Interval {
  int segment = 0;
  double from = 0; ///< λ, mm
  double to = 0;
  double cap2 = 0;    ///< (mm/s)², at `from`
  double capEnd2 = 0; ///< (mm/s)², at `to`
  double end2 = 0;    ///< K² at `to`
  double brake = 0;   ///< mm/s², ≥ 0: a deceleration that the axes have all along K²
};

/// The highest override, as a factor: K holds for all up to it.
inline constexpr double kHighestOverride = 1.5;
inline constexpr double kLowestOverride = 0.1;

/// Under AccelerationRule::PerAxis the axes are planned with this share of their limits: λ̈ held over a thousandth of
/// the radius lets an axis overshoot inside an arc by up to 1e-6 of its limit, and positions of 1 m in double precision
/// are rounded by some 1e-6 mm/s² in second differences over 1 ms.
inline constexpr double kPlanningShare = 1 - 3e-6;

/// The backward pass: the highest speed from which every later limit can still be kept, over a whole track that ends at
/// rest. Reachability after Pham & Pham (TOPP-RA), with the limits held at both ends of every interval. A stop ends it
/// early.
[[nodiscard]] std::vector<Interval> speedLimits(const std::vector<Segment>& track, const AxisLimits& limits,
                                                const std::stop_token& stop = {});

/// The one interval of a straight move from rest to rest by itself, without a list: for the control loop.
[[nodiscard]] Interval restToRest(const Segment& straight, const AxisLimits& limits);

} // namespace arris::motion
