#include "core/toolpath/corners.h"

#include "core/base/numbers.h"
#include "core/toolpath/glass.h"

#include <algorithm>
#include <cmath>

namespace arris::toolpath {
namespace {

using base::kPi;
using base::squared;
using geometry::Point;
using geometry::Vector;

// Eq. (14) can ask for more than the axes have: the acceleration on the whole blend is q'' λ̇² with constant q''.
void clampToAxes(Corner& corner, const Vector& before, const Vector& after, const recipe::Recipe& recipe) {
  const Vector second = (after - before) / (2 * corner.leg);
  const auto clamp = [&](double limit, double share, LimitedBy axis) {
    const double speed = std::sqrt(limit / std::abs(share));
    if (speed < corner.transitionSpeed) {
      corner.transitionSpeed = speed;
      corner.limitedBy = axis;
    }
  };
  clamp(recipe.accelX, second.x(), LimitedBy::AxisX);
  clamp(recipe.accelY, second.y(), LimitedBy::AxisY);
}

} // namespace

Corner classify(const Point& s, const Vector& before, const Vector& after, const recipe::Recipe& recipe) {
  const double side = wheelSide(recipe.direction);
  const double radius = recipe.wheelRadius;
  Corner corner;
  corner.s = s;
  corner.angle = kPi + side * geometry::turn(before, after);
  corner.a = s + side * radius * geometry::leftOf(before);
  corner.c = s + side * radius * geometry::leftOf(after);
  const CornerFigures figures = cornerFigures(corner.angle, recipe);
  corner.relief = figures.relief;
  corner.reliefEq13 = figures.reliefEq13;
  corner.tipDepth = figures.tipDepth;
  corner.widest = figures.widest;
  if (!corner.relief && corner.angle >= kBluntAngle) {
    corner.kind = CornerKind::Blunt;
    corner.treatment = Treatment::Roll;
    corner.reason = Reason::BluntWithoutRelief;
    corner.widest = radius;
    return corner;
  }
  corner.reason = corner.relief ? Reason::SharpWithRelief : Reason::SharpWithoutRelief;
  corner.leg = figures.leg;
  corner.q = corner.a + corner.leg * before;
  corner.transitionSpeed = figures.transitionSpeed;
  corner.limitedBy = recipe.cornerSpeed < 100 ? LimitedBy::CornerSpeed : LimitedBy::Angle;
  if (recipe.accelerationRule == recipe::AccelerationRule::PerAxis) {
    clampToAxes(corner, before, after, recipe);
  }
  corner.blendAcceleration = squared(corner.transitionSpeed) / (2 * corner.leg);
  corner.blendTime = 2 * corner.leg / corner.transitionSpeed;
  return corner;
}

Corner rolledInstead(Corner corner, const recipe::Recipe& recipe) {
  corner.treatment = Treatment::Roll;
  corner.reason = Reason::TransitionBlocked;
  corner.transitionSpeed = corner.blendAcceleration = corner.blendTime = corner.leg = 0;
  corner.widest = recipe.wheelRadius;
  return corner;
}

} // namespace arris::toolpath
