#include "core/pattern/dxf_curves.h"

#include "core/base/numbers.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace arris::pattern {
namespace {

using base::Code;
using base::Problem;
using base::Unexpected;
using geometry::Bezier;
using geometry::Interpolation;
using geometry::Point;
using geometry::Spline;
using geometry::Vector;

/// What the groups of a SPLINE say.
struct SplineGroups {
  bool closed = false;
  Spline spline;
  Interpolation interpolation;
  Vector startDirection = Vector::Zero();
  Vector endDirection = Vector::Zero();
};

void takeInteger(SplineGroups& groups, const Group& group) {
  constexpr std::int64_t kClosedOrPeriodic = 1 | 2;
  const std::int64_t number = wholeNumber(group.value).value_or(0);
  if (group.code == 70) {
    groups.closed = (number & kClosedOrPeriodic) != 0;
  } else if (group.code == 71) {
    groups.spline.degree = static_cast<int>(std::clamp<std::int64_t>(number, -1, geometry::kMostDegree + 1));
  }
}

void takeReal(SplineGroups& groups, const Group& group) {
  const double number = finiteNumber(group.value).value_or(0);
  switch (group.code) {
  case 10:
    groups.spline.points.emplace_back(number, 0);
    break;
  case 20:
    groups.spline.points.back().y() = number;
    break;
  case 11:
    groups.interpolation.points.emplace_back(number, 0);
    break;
  case 21:
    groups.interpolation.points.back().y() = number;
    break;
  case 12:
  case 22:
    groups.startDirection[group.code == 12 ? 0 : 1] = number;
    break;
  case 13:
  case 23:
    groups.endDirection[group.code == 13 ? 0 : 1] = number;
    break;
  case 40:
    groups.spline.knots.push_back(number);
    break;
  case 41:
    groups.spline.weights.push_back(number);
    break;
  default:
    break;
  }
}

SplineGroups groupsOf(const Entity& entity) {
  SplineGroups groups;
  Group group;
  for (GroupCursor cursor(entity.body); cursor.next(group);) {
    if (group.code == 70 || group.code == 71) {
      takeInteger(groups, group);
    } else if (group.code >= 10 && group.code < 60) {
      takeReal(groups, group);
    }
  }
  groups.interpolation.closed = groups.closed;
  if (!groups.startDirection.isZero()) {
    groups.interpolation.startDirection = groups.startDirection;
  }
  if (!groups.endDirection.isZero()) {
    groups.interpolation.endDirection = groups.endDirection;
  }
  return groups;
}

// Each knot and each point stands once: the curve runs on round the circle.
void repeatForClosed(Spline& spline) {
  const auto degree = static_cast<std::size_t>(std::max(spline.degree, 0));
  const std::size_t count = spline.points.size();
  if (degree == 0 || count <= degree || spline.knots.size() != count + 1) {
    return;
  }
  const double period = spline.knots.back() - spline.knots.front();
  std::vector<double> knots;
  for (std::size_t i = 0; i < count + 2 * degree + 1; ++i) {
    const std::size_t place = i + (degree / count + 1) * count - degree; // never below 0
    const double rounds =
        std::floor((static_cast<double>(i) - static_cast<double>(degree)) / static_cast<double>(count));
    knots.push_back(spline.knots[place % count] + rounds * period);
  }
  spline.knots = std::move(knots);
  for (std::size_t i = 0; i < degree; ++i) {
    spline.points.push_back(spline.points[i]);
    if (spline.weights.size() > i && spline.weights.size() >= count) {
      spline.weights.push_back(spline.weights[i]);
    }
  }
}

// Knots that are repeated more often than the degree allow of it.
bool breaksApart(const std::vector<Bezier>& pieces) {
  const auto gapBefore = [&](std::size_t i) {
    return (pieces[i].points.front().hnormalized() - pieces[i - 1].points.back().hnormalized()).norm();
  };
  double most = 0;
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    most = std::max(most, gapBefore(i));
  }
  return most > base::kZeroLength;
}

/// Points that are all the same are a curve without length.
std::vector<Bezier> throughPoints(const Interpolation& interpolation) {
  std::vector<Bezier> pieces = geometry::bezierPieces(interpolation);
  if (pieces.empty()) {
    const Eigen::Vector3d point = interpolation.points.front().homogeneous();
    pieces.push_back({{point, point}});
  }
  return pieces;
}

} // namespace

geometry::EllipticArc readEllipse(const Entity& entity) {
  constexpr double kSameParameter = 1e-6;
  constexpr double kOnceRound = 2 * base::kPi;
  Point center = Point::Zero();
  Vector major = Vector::Zero();
  double ratio = 1;
  std::array<double, 2> parameters{0, kOnceRound};
  Group group;
  for (GroupCursor cursor(entity.body); cursor.next(group);) {
    const double number = finiteNumber(group.value).value_or(0);
    if (group.code == 10 || group.code == 20) {
      center[group.code == 10 ? 0 : 1] = number;
    } else if (group.code == 11 || group.code == 21) {
      major[group.code == 11 ? 0 : 1] = number;
    } else if (group.code == 40) {
      ratio = number;
    } else if (group.code == 41 || group.code == 42) {
      parameters.at(group.code == 41 ? 0 : 1) = number;
    }
  }
  const double rest = std::fmod(parameters[1] - parameters[0], kOnceRound);
  const double sweep = rest < 0 ? rest + kOnceRound : rest;
  const bool whole = sweep < kSameParameter || sweep > kOnceRound - kSameParameter;
  geometry::EllipticArc ellipse;
  ellipse.arc = geometry::arcAbout(Point::Zero(), 1, parameters[0], whole ? kOnceRound : sweep);
  ellipse.map.linear().col(0) = major;
  ellipse.map.linear().col(1) = (entity.extrusion[2] < 0 ? -ratio : ratio) * geometry::leftOf(major);
  ellipse.map.translation() = center;
  return ellipse;
}

base::Expected<std::vector<Bezier>> readSpline(const Entity& entity) {
  SplineGroups groups = groupsOf(entity);
  if (groups.closed) {
    repeatForClosed(groups.spline);
  }
  std::string flaw = geometry::flawOf(groups.spline);
  if (flaw.empty()) {
    std::vector<Bezier> pieces = geometry::bezierPieces(groups.spline);
    if (!breaksApart(pieces)) {
      return pieces;
    }
    flaw = "it breaks apart";
  }
  if (!groups.interpolation.points.empty()) {
    return throughPoints(groups.interpolation);
  }
  return Unexpected(Problem(Code::SplineFlawed, {{"reason", std::move(flaw)}}).onLine(entity.line));
}

} // namespace arris::pattern
