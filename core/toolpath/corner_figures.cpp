#include "core/base/numbers.h"
#include "core/toolpath/toolpath.h"

#include <cmath>

namespace arris::toolpath {

using base::kPi;
using base::squared;

CornerFigures cornerFigures(double beta, const recipe::Recipe& recipe) {
  const double radius = recipe.wheelRadius;
  const double depth = recipe.depth;
  const double feed = recipe.feedPerSecond();
  const double s = std::sin(beta / 2);
  const double axes = std::hypot(recipe.accelX, recipe.accelY);

  CornerFigures f;
  f.leg = radius / std::tan(beta / 2);
  f.transitionSpeed = beta / kPi * feed * recipe.cornerSpeed / 100;                         // v_trans, (16)
  f.acceleration = squared(f.transitionSpeed) / (2 * f.leg);                                // a, (14)
  f.time = 2 * f.leg / f.transitionSpeed;                                                   // t_m, (2)
  f.widest = radius / 2 * (s + 1 / s);                                                      // L(t_m/2), from (9)
  f.tipDepth = depth / s;                                                                   // d, (6)
  f.accelerationVector = 2 * f.acceleration * std::cos(beta / 2);                           // |a (e_d − e_s)|
  f.eq15 = (squared(feed) - squared(f.transitionSpeed)) / (2 * axes);                       // L_d = L_a, (15)
  f.relief = squared(1 - s) >= 2 * depth / radius;                                          // (12) in closed form
  f.reliefEq13 = depth / radius < std::sqrt(1 + (1 + std::cos(beta)) * std::cos(beta)) - 1; // (13) as printed
  return f;
}

} // namespace arris::toolpath
