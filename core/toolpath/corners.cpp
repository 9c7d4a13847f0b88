#include "core/toolpath/corners.h"

#include "core/base/numbers.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace arris::toolpath {
namespace {

using base::Code;
using base::degrees;
using base::kPi;
using base::Problem;
using base::squared;
using geometry::Arc;
using geometry::Curve;
using geometry::Parabola;
using geometry::Point;
using geometry::Vector;

/// A tip more pointed than this is a mistake of the drawing, rad: the wheel would swing out by 570 radii.
constexpr double kLeastAngle = base::radians(0.1);

std::vector<Curve> inDirectionOfTravel(std::vector<Curve> curves, recipe::Direction direction) {
  if (direction == recipe::Direction::Clockwise) {
    std::reverse(curves.begin(), curves.end());
    std::transform(curves.begin(), curves.end(), curves.begin(), geometry::reversed);
  }
  return curves;
}

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

Joint transitionJoint(Corner corner) {
  return {corner, Parabola{corner.a, corner.q, corner.c}};
}

Joint rollJoint(Corner corner, const Vector& before, double turn, double radius) {
  return {corner, Arc{corner.a, before, (turn > 0 ? 1 : -1) / radius, radius * std::abs(turn)}};
}

Joint join(const Edge& edge, const Edge& next, int contour, const recipe::Recipe& recipe, base::Problems& problems) {
  const Vector before = geometry::endTangent(edge.contour);
  const Vector after = geometry::startTangent(next.contour);
  const double turn = geometry::turn(before, after);
  const Point s = geometry::startPoint(next.contour);
  const bool leftOut = (geometry::endPoint(edge.contour) - s).norm() > base::kZeroLength; // an edge between, refused
  if (std::abs(turn) <= base::kTangentTurn || leftOut) {
    return {};
  }
  const double beta = kPi + wheelSide(recipe.direction) * turn;
  if (beta < kLeastAngle || beta > 2 * kPi - kLeastAngle) {
    problems.push_back(
        Problem(Code::SpikeInContour, {{"angle_deg", std::abs(degrees(beta))}}).at(s).ofContour(contour));
    return {};
  }
  if (beta > kPi) {
    problems.push_back(Problem(Code::ConcaveCorner, {{"angle_deg", degrees(beta)}}).at(s).ofContour(contour));
    return {};
  }
  Corner corner = classify(s, before, after, recipe);
  corner.contour = contour;
  corner.a = geometry::endPoint(edge.path); // the same to rounding, and without a gap
  corner.c = geometry::startPoint(next.path);
  return corner.treatment == Treatment::Transition ? transitionJoint(corner)
                                                   : rollJoint(corner, before, turn, recipe.wheelRadius);
}

} // namespace

double wheelSide(recipe::Direction direction) {
  return direction == recipe::Direction::Clockwise ? 1 : -1;
}

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

CompensatedContour compensate(const pattern::Contour& contour, const recipe::Recipe& recipe, base::Problems& problems) {
  const double distance = wheelSide(recipe.direction) * recipe.wheelRadius;
  CompensatedContour result;
  result.contour = contour.id;
  for (const Curve& curve : inDirectionOfTravel(contour.curves, recipe.direction)) {
    const auto* arc = std::get_if<Arc>(&curve);
    if (arc && arc->curvature * distance >= 1) {
      Problem tooSmall =
          Problem(Code::InnerRadiusTooSmall, {{"wheel_mm", recipe.wheelRadius}, {"radius_mm", arc->radius()}})
              .at(geometry::pointAt(curve, arc->length / 2))
              .ofContour(contour.id);
      tooSmall.largestWheel = arc->radius();
      problems.push_back(std::move(tooSmall));
      continue;
    }
    result.edges.push_back({curve, geometry::offset(curve, distance)});
  }
  const std::size_t count = result.edges.size();
  for (std::size_t i = 0; i < count; ++i) {
    result.joints.push_back(join(result.edges[i], result.edges[(i + 1) % count], contour.id, recipe, problems));
  }
  return result;
}

} // namespace arris::toolpath
