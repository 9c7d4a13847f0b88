#include "core/job/program_track.h"

#include "core/base/tolerances.h"
#include "core/job/track_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace arris::job {
namespace {

using base::Code;
using base::Problem;
using base::Problems;
using geometry::Box;
using geometry::Curve;
using geometry::Point;
using motion::Move;
using motion::Segment;
using toolpath::Role;

/// The wheel's lower face stays this far above the table, mm.
constexpr double kAboveTable = 1;

/// What rounding may put outside the travel, mm.
constexpr double kTravelRounding = 1e-6;

Move moveOf(Role role) {
  switch (role) {
  case Role::LeadIn:
    return Move::LeadIn;
  case Role::Contour:
    return Move::Contour;
  case Role::Transition:
    return Move::Transition;
  case Role::Roll:
    return Move::Roll;
  case Role::LeadOut:
    return Move::LeadOut;
  }
  return Move::Contour;
}

// The chain at the height of the wheel; `number` is that of the last primitive before it.
void grind(TrackBuilder& builder, const toolpath::Chain& chain, const recipe::Recipe& recipe, int& number) {
  for (const toolpath::PathSegment& piece : chain.segments) {
    Segment segment;
    std::visit([&](const auto& shape) { segment.shape = shape; }, piece.shape);
    segment.move = moveOf(piece.role);
    segment.z = builder.at().z();
    segment.feed = recipe.feedPerSecond();
    if (piece.speedCap > 0) {
      segment.speedCap = piece.speedCap;
    }
    segment.contour = chain.contour;
    segment.number = ++number;
    segment.corner = piece.corner;
    segment.stopAtEnd = piece.stopAtEnd || &piece == &chain.segments.back();
    segment.stopCorner = piece.stopCorner;
    builder.add(segment);
  }
}

std::string nameOf(const toolpath::PathSegment& piece) {
  switch (piece.role) {
  case Role::LeadIn:
    return "the lead-in";
  case Role::LeadOut:
    return "the lead-out";
  case Role::Transition:
    return fmt::format("the transition at corner {}", piece.corner);
  case Role::Roll:
    return piece.corner != 0 ? fmt::format("the roll round corner {}", piece.corner) : "the way along the contour";
  case Role::Contour:
    break;
  }
  return "the way along the contour";
}

double excess(const Box& box, const Eigen::Vector2d& travel) {
  const Eigen::Vector2d below = -box.min();
  const Eigen::Vector2d above = box.max() - travel;
  return std::max(below.maxCoeff(), above.maxCoeff());
}

// Near enough to be found in the drawing.
Point farthestOut(const Curve& curve, const Eigen::Vector2d& travel) {
  constexpr int kSteps = 64;
  const double length = geometry::parameterLength(curve);
  Point result = geometry::startPoint(curve);
  for (int i = 1; i <= kSteps; ++i) {
    const Point point = geometry::pointAt(curve, length * i / kSteps);
    if (excess({point, point}, travel) > excess({result, result}, travel)) {
      result = point;
    }
  }
  return result;
}

Problem outside(const std::string& what, double by, const Point& where) {
  return Problem(Code::OutsideTravel, {{"what", what}, {"excess_mm", by}}).at(where);
}

} // namespace

Heights heightsOf(const recipe::Recipe& recipe, const recipe::Machine& machine) {
  return {recipe.support + recipe.thickness / 2 + recipe.wheelZ,
          recipe.support + recipe.thickness + recipe.clearance + recipe.wheelHeight / 2, machine.travel.z()};
}

Problems checkHeights(const recipe::Recipe& recipe, const recipe::Machine& machine) {
  const Heights heights = heightsOf(recipe, machine);
  Problems problems;
  const double lowerFace = heights.grinding - recipe.wheelHeight / 2;
  if (lowerFace < kAboveTable) {
    problems.push_back(Problem(Code::WheelBelowTable, {{"height_mm", lowerFace}, {"least_mm", kAboveTable}}));
  }
  const auto check = [&](const char* what, double height) {
    if (height > heights.top || height < 0) {
      problems.push_back(
          Problem(Code::HeightOutsideTravel, {{"what", what}, {"height_mm", height}, {"most_mm", heights.top}}));
    }
  };
  check("clearance", heights.clearance);
  check("grinding", heights.grinding);
  if (heights.grinding > heights.clearance) {
    problems.push_back(
        Problem(Code::GrindingAboveClearance, {{"height_mm", heights.grinding}, {"clearance_mm", heights.clearance}}));
  }
  return problems;
}

// Where the park position is low, the wheel stands beside the glass and above the table.
Problems checkPark(const std::vector<pattern::Contour>& contours, const recipe::Recipe& recipe,
                   const recipe::Machine& machine) {
  const Point park = machine.park.head<2>();
  const double lowerFace = machine.park.z() - recipe.wheelHeight / 2;
  const double beside = recipe.wheelRadius + recipe.depth + kAboveTable;
  const bool atGlass = std::any_of(contours.begin(), contours.end(), [&](const pattern::Contour& contour) {
    const auto isNear = [&](const Curve& c) { return geometry::nearest(c, park).distance < beside; };
    return geometry::bounds(contour.curves).contains(park) ||
           std::any_of(contour.curves.begin(), contour.curves.end(), isNear);
  });
  const double least = atGlass ? recipe.support + recipe.thickness + kAboveTable : kAboveTable;
  if (lowerFace < least) {
    return {Problem(Code::ParkTooLow, {{"height_mm", lowerFace}, {"least_mm", least}}).at(park)};
  }
  return {};
}

// One problem for each corner and lead, and one for the rest: the worst of it.
Problems checkTravel(const toolpath::Toolpath& toolpath, const recipe::Machine& machine) {
  Problems problems;
  const Eigen::Vector2d travel = machine.travel.head<2>();
  for (const toolpath::Chain& chain : toolpath.chains) {
    std::optional<Problem> worstOnContour;
    double worst = kTravelRounding;
    std::vector<int> named;
    for (const toolpath::PathSegment& piece : chain.segments) {
      const Box box = geometry::bounds(piece.shape);
      const double by = excess(box, travel);
      if (by <= kTravelRounding) {
        continue;
      }
      const Problem problem = outside(nameOf(piece), by, farthestOut(piece.shape, travel)).ofContour(chain.contour);
      if (piece.corner != 0 && std::find(named.begin(), named.end(), piece.corner) == named.end()) {
        named.push_back(piece.corner);
        problems.push_back(Problem(problem).ofCorner(piece.corner));
      } else if (piece.role == Role::LeadIn || piece.role == Role::LeadOut) {
        problems.push_back(problem);
      } else if (piece.corner == 0 && by > worst) {
        worst = by;
        worstOnContour = problem;
      }
    }
    if (worstOnContour) {
      problems.push_back(*worstOnContour);
    }
  }
  return problems;
}

std::vector<Segment> makeTrack(const toolpath::Toolpath& toolpath, const recipe::Recipe& recipe,
                               const recipe::Machine& machine) {
  const Heights heights = heightsOf(recipe, machine);
  TrackBuilder builder(machine, machine.park);
  int number = 0;
  builder.vertical(Move::Approach, heights.top);
  Move across = Move::Approach;
  for (const toolpath::Chain& chain : toolpath.chains) {
    builder.across(across, geometry::startPoint(chain.segments.front().shape));
    builder.vertical(Move::Approach, heights.clearance);
    builder.vertical(Move::Plunge, heights.grinding);
    grind(builder, chain, recipe, number);
    builder.vertical(Move::Retract, heights.clearance);
    across = Move::Traverse;
  }
  builder.vertical(Move::Retract, heights.top);
  builder.across(Move::Traverse, machine.park.head<2>());
  builder.vertical(Move::Traverse, machine.park.z());
  return builder.take();
}

} // namespace arris::job
